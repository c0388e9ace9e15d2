#include "submissions.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <set>

#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

bool is_answer(const fs::path& entry, const std::vector<Exercise>& exercises) {
    return std::any_of(exercises.begin(), exercises.end(),
                       [&](const Exercise& exercise) { return is_source(entry) && entry.stem() == exercise.name; });
}

}  // namespace

std::string in_one_line(const std::string& name) {
    std::string line;
    for (std::size_t i = 0; i < name.size();) {
        const std::string character = name.substr(i, std::max<std::size_t>(character_at(name, i), 1));
        const bool at_an_end = i == 0 || i + 1 == name.size();
        i += character.size();
        if (character == "\\" || character == "\n" || character == "\t")
            line += character == "\\" ? "\\\\" : character == "\n" ? "\\n" : "\\t";
        else if (is_seen(character) && !(character == " " && at_an_end))
            line += character;
        else
            for (const char byte : character) {
                char code[8];
                std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(byte));
                line += code;
            }
    }
    return line;
}

namespace {

bool holds_answers(const fs::path& place, const std::vector<Exercise>& exercises) {
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(place, error))) return false;
    const auto answers = collect_answers({"", place}, exercises).all;
    return std::any_of(answers.begin(), answers.end(), [](const HandedIn& answer) { return !answer.file.empty(); });
}

// May it be a submission of its own, which would be lost if the folder around it counted as one submission?
bool may_be_anothers(const fs::path& entry) {
    const std::string name = entry.filename().string();
    if (name.starts_with(".")) return holds_answers(entry, all_exercises());
    std::error_code error;
    const auto type = fs::symlink_status(entry, error).type();
    if (type != fs::file_type::regular) return !is_of_the_course(entry);
    static const std::set<std::string> packed{".zip", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".zst", ".7z", ".rar"};
    return packed.contains(entry.extension().string()) || (is_source(entry) && !answers_another(entry));
}

// Subfolders that hold answers (not chapters); none if the folder holds an answer itself. Two or more mean a class.
std::vector<std::string> learners_in(const fs::path& folder, const std::vector<Exercise>& exercises) {
    std::vector<std::string> names;
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(folder, error))) return {};
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name == "exercises" || is_answer(entry->path(), all_exercises())) return {};
        const bool chapter = std::any_of(all_exercises().begin(), all_exercises().end(),
                                         [&](const Exercise& exercise) { return exercise.chapter == name; });
        if (!chapter && !name.starts_with(".") && !is_ignored(name) &&
            (holds_answers(entry->path(), exercises) || holds_answers(entry->path(), all_exercises())))
            names.push_back(in_one_line(name));
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

// The word as a shell needs it.
std::string typed(const std::string& word) {
    const bool plain = std::all_of(
        word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) || std::strchr("_-./", c) != nullptr; });
    std::string inside = word;
    replace_all(inside, "'", "'\\''");
    return plain && !word.empty() ? word : "'" + inside + "'";
}

}  // namespace

Submissions find_submissions(const fs::path& place, const std::vector<Exercise>& exercises, bool one) {
    std::error_code error;
    const fs::path whole = fs::canonical(place, error);
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use, (place.empty() ? "''" : in_one_line(place.string())) + ": " + why);
    };
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (!fs::is_directory(whole) && !fs::is_regular_file(whole)) refuse("is neither a folder nor a file");
    const Submission itself{in_one_line(whole.filename().string()), whole};
    if (one || fs::is_regular_file(whole)) return {{itself}, {}, true};

    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(whole, error), end; !error && entry != end; entry.increment(error))
        entries.push_back(entry->path());
    if (error) refuse("cannot be read (" + error.message() + ")");
    std::sort(entries.begin(), entries.end());

    Submissions found;
    std::string mark, anothers;       // a sign of one submission; of another beside it
    std::vector<std::string> beside;  // left out if it is one submission
    for (const fs::path& entry : entries) {
        const std::string name = entry.filename().string(), written = in_one_line(name);
        if (is_ignored(name)) {
            if (holds_answers(entry, all_exercises()))
                refuse("'" + written + "' holds an answer, and a folder of that name is left out: rename it");
            found.left_out.push_back(written);
            beside.push_back(written);
            continue;
        }
        found.all.push_back({written, entry});
        if (name == "exercises" || is_answer(entry, exercises))
            mark = mark.empty() ? written : mark;
        else if (may_be_anothers(entry))
            anothers = anothers.empty() ? written : anothers;
        else if (!is_of_the_course(entry) && !answers_another(entry))
            beside.push_back(written);
    }
    if (found.all.empty())
        refuse("holds no submission" + (found.left_out.empty() ? ": it is empty" : ", only " + listed(found.left_out)));
    for (const Submission& inner : found.all)
        if (const auto learners = learners_in(inner.place, exercises);
            learners.size() > 1 && (found.all.size() == 1 || inner.name == "exercises"))
            refuse("'" + inner.name + "' in it may be a class, with '" + learners[0] + "' and '" + learners[1] +
                   "': if it is, ./course grade " + typed((place / inner.place.filename()).string()) +
                   "; if it is one submission, ./course grade " + typed(place.string()) + " --one");
    if (mark.empty()) return found;
    if (!anothers.empty())
        refuse("'" + mark + "' in it makes it one submission, and '" + anothers +
               "' beside it may be another's: if it is one, ./course grade " + typed(place.string()) +
               " --one; if it is a class, take '" + mark + "' out of it");
    return {{itself}, beside, true};
}

}  // namespace course
