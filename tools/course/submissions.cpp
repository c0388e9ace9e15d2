#include "submissions.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>
#include <utility>

#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

const std::size_t most_entries = 20'000;

std::string in_small_letters(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

// What version control and file managers leave behind.
bool is_ignored(const std::string& name) {
    static const std::set<std::string> names{".git",         ".svn",        ".hg",
                                             ".DS_Store",    "__MACOSX",    ".Spotlight-V100",
                                             ".Trashes",     ".fseventsd",  "@eaDir",
                                             "Thumbs.db",    "desktop.ini", ".directory",
                                             "$RECYCLE.BIN", "lost+found",  "System Volume Information"};
    return names.contains(name) || name.starts_with("._");
}

bool is_source(const fs::path& file) {
    static const std::set<std::string> endings{".cpp", ".cc", ".cxx", ".c++"};
    return endings.contains(in_small_letters(file.extension().string()));
}

// Is it a C++ file with the name of one of these exercises?
bool answers(const fs::path& file, const std::vector<Exercise>& exercises) {
    return std::any_of(exercises.begin(), exercises.end(),
                       [&](const Exercise& exercise) { return is_source(file) && file.stem() == exercise.name; });
}

// Why a file named after an exercise is no answer to it; "" if it is not meant as one.
std::string why_not(const fs::path& file, const std::string& exercise) {
    static const std::set<std::string> texts{"", ".c", ".h", ".hh", ".hpp", ".txt"};
    if (is_source(file)) return "must be named " + exercise + ".cpp, in exactly these letters: rename it";
    if (texts.contains(in_small_letters(file.extension().string())))
        return "does not have the name of a C++ file: rename it to " + exercise + ".cpp";
    return "";
}

// The files with an exercise's name: those that answer it, and those that do not, with the reason.
struct Found {
    std::vector<fs::path> answers;
    std::vector<std::pair<fs::path, std::string>> refused;
};

// All that a submission holds, at any depth.
struct Contents {
    std::vector<Found> found;       // for each exercise
    std::vector<fs::path> sources;  // C++ files of any name
    std::vector<std::string> left_out;
    std::string fault;  // why it could not be read whole
};

std::string below(const fs::path& root, const fs::path& place) {
    return in_one_line(place.lexically_relative(root).string());
}

// The exercise whose name the file has, in large or small letters.
std::size_t named_after(const fs::path& file, const std::vector<Exercise>& exercises) {
    const std::string stem = in_small_letters(file.stem().string());
    const auto at = std::find_if(exercises.begin(), exercises.end(),
                                 [&](const Exercise& exercise) { return exercise.name == stem; });
    return static_cast<std::size_t>(at - exercises.begin());
}

// Nothing is graded in a folder that is left out, but a learner whose only answer is there is told.
void note_answers_left_out(const fs::path& root, const fs::path& folder, const std::vector<Exercise>& exercises,
                           Contents& contents) {
    std::size_t seen = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && entry != end && ++seen <= most_entries; entry.increment(error)) {
        const std::size_t at = named_after(entry->path(), exercises);
        if (at < exercises.size() && is_source(entry->path()))
            contents.found[at].refused.emplace_back(
                entry->path(), "lies where nothing is graded, in '" + below(root, folder) + "': move it");
    }
}

Contents contents_of(const fs::path& root, const std::vector<Exercise>& exercises) {
    Contents contents{std::vector<Found>(exercises.size()), {}, {}, {}};
    std::size_t seen = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(root, error), end; !error && entry != end; entry.increment(error)) {
        if (++seen > most_entries) {
            contents.fault = "holds more than " + std::to_string(most_entries) + " files and folders";
            return contents;
        }
        const fs::path& file = entry->path();
        const std::string name = file.filename().string();
        const bool is_folder = fs::is_directory(entry->symlink_status(error));
        if (is_ignored(name) || (is_folder && name.starts_with("."))) {
            contents.left_out.push_back(name.starts_with("._") ? "._*" : in_one_line(name));
            entry.disable_recursion_pending();
            if (is_folder) note_answers_left_out(root, file, exercises, contents);
            continue;
        }
        if (!is_folder && is_source(file)) contents.sources.push_back(file);
        const std::size_t at = named_after(file, exercises);
        if (at == exercises.size()) continue;
        Found& found = contents.found[at];
        if (exercises[at].name == file.stem() && is_source(file))
            found.answers.push_back(file);
        else if (const std::string why = why_not(file, exercises[at].name); !is_folder && !why.empty())
            found.refused.emplace_back(file, why);
    }
    if (error) contents.fault = "holds a folder that cannot be read (" + error.message() + ")";
    return contents;
}

// The answer among several files with the exercise's name: the one at its place.
HandedIn choose(std::vector<fs::path> files, const fs::path& root, const Exercise& exercise) {
    std::sort(files.begin(), files.end());
    const auto is_at_its_place = [&](const fs::path& file) {
        const fs::path folder = file.parent_path();
        return folder.filename() == exercise.chapter && folder.parent_path().filename() == "exercises";
    };
    const auto at_place = std::count_if(files.begin(), files.end(), is_at_its_place);
    if (files.size() > 1 && at_place != 1)
        return {files[0], std::to_string(files.size()) + " files answer it, " +
                              (files.size() > 2 ? "among them " : "") + below(root, files[0]) + " and " +
                              below(root, files[1]) + ", and exercises/" + exercise.chapter +
                              " does not hold exactly one of them: keep only one"};
    const fs::path answer = at_place == 1 ? *std::find_if(files.begin(), files.end(), is_at_its_place) : files[0];
    std::string others;
    for (const fs::path& file : files)
        if (file != answer) others += (others.empty() ? "" : ", ") + below(root, file);
    if (!others.empty())
        others = exercise.name + ": " + below(root, answer) + " is graded, " + others +
                 (files.size() == 2 ? " is" : " are") + " left out";
    return {answer, "", false, others};
}

// The answer in a submission that is one file.
Answers collect_from_file(const fs::path& file, const std::vector<Exercise>& exercises) {
    Answers answers{std::vector<HandedIn>(exercises.size())};
    std::error_code error;
    const bool is_regular = fs::symlink_status(file, error).type() == fs::file_type::regular;
    if (exercises.size() == 1) {
        answers.all[0] = {file,
                          is_source(file) || !is_regular
                              ? ""
                              : "it is neither a folder nor a C++ file, .cpp (archives are to be unpacked first)"};
        return answers;
    }
    const std::string stem = file.stem().string();
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const std::string& name = exercises[i].name;
        if (in_small_letters(stem) != name) continue;
        const std::string why = stem == name && is_source(file) ? "" : why_not(file, name);
        if (!why.empty() || is_source(file))
            answers.all[i] = {file, why.empty() ? "" : in_one_line(file.filename().string()) + " " + why};
    }
    return answers;
}

bool holds_answers(const fs::path& place, const std::vector<Exercise>& exercises) {
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(place, error))) return false;
    const auto answers = collect_answers({"", place}, exercises).all;
    return std::any_of(answers.begin(), answers.end(),
                       [](const HandedIn& answer) { return is_source(answer.file) && !answer.whole; });
}

const std::vector<Exercise>& all_exercises() {
    static const std::vector<Exercise> all = read_exercises();
    return all;
}

// May it be a submission of its own, which would be lost if the folder around it counted as one submission?
bool may_be_anothers(const fs::path& entry) {
    if (entry.filename().string().starts_with(".")) return holds_answers(entry, all_exercises());
    std::error_code error;
    if (fs::symlink_status(entry, error).type() != fs::file_type::regular) return true;
    static const std::set<std::string> packed{".zip", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".zst", ".7z", ".rar"};
    return packed.contains(entry.extension().string()) || (is_source(entry) && !answers(entry, all_exercises()));
}

// The subfolders that hold answers and are no chapters. Two or more may be a class; none if the folder itself is one
// submission.
std::vector<std::string> learners_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(folder, error))) return {};
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name == "exercises" || answers(entry->path(), all_exercises())) return {};
        const bool is_chapter = std::any_of(all_exercises().begin(), all_exercises().end(),
                                            [&](const Exercise& exercise) { return exercise.chapter == name; });
        if (!is_chapter && !name.starts_with(".") && !is_ignored(name) && holds_answers(entry->path(), all_exercises()))
            names.push_back(in_one_line(name));
    }
    std::sort(names.begin(), names.end());
    return names;
}

bool is_kit_of_a_learner(const fs::path& folder) {
    std::error_code error;
    return fs::exists(folder / "include/timestep", error) && fs::is_regular_file(folder / "course", error);
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

std::string text_of(const HandedIn& answer) {
    if (!answer.refused.empty()) throw Stop(Status::bad_use, answer.refused);
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use, in_one_line(answer.file.filename().string()) + " " + why);
    };
    std::error_code error;
    const auto type = fs::symlink_status(answer.file, error).type();
    if (type == fs::file_type::symlink) refuse("is a link, and links are not followed");
    if (type == fs::file_type::directory) refuse("is a folder");
    if (type != fs::file_type::regular) refuse("is no regular file");
    if (fs::file_size(answer.file, error) > 1 << 20) refuse("is larger than 1 MB");
    return contents(answer.file);
}

Answers collect_answers(const Submission& submission, const std::vector<Exercise>& exercises) {
    std::error_code error;
    const fs::path& root = submission.place;
    if (!fs::is_directory(fs::symlink_status(root, error))) return collect_from_file(root, exercises);
    const Contents contents = contents_of(root, exercises);
    Answers collected{std::vector<HandedIn>(exercises.size()), contents.left_out};
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const auto& [files, refused] = contents.found[i];
        const auto& sources = contents.sources;
        HandedIn& answer = collected.all[i];
        // The only C++ file counts under any name: platforms and browsers rename files.
        const bool only = exercises.size() == 1 && sources.size() == 1 && !answers(sources[0], all_exercises()) &&
                          (refused.empty() || (refused.size() == 1 && refused[0].first == sources[0]));
        if (!contents.fault.empty())
            answer = {root, "the submission " + contents.fault, true};
        else if (!files.empty())
            answer = choose(files, root, exercises[i]);
        else if (only)
            answer.file = sources[0];
        else if (!refused.empty()) {
            const auto& [file, why] = *std::min_element(refused.begin(), refused.end());
            answer = {file, below(root, file) + " " + why};
        }
    }
    return collected;
}

Submissions find_submissions(const fs::path& place, const std::vector<Exercise>& exercises, bool one) {
    std::error_code error;
    const fs::path whole = fs::canonical(place, error);
    const std::string given = place.empty() ? "''" : in_one_line(place.string());
    const auto refuse = [&](const std::string& why) { throw Stop(Status::bad_use, given + ": " + why); };
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (!fs::is_directory(whole) && !fs::is_regular_file(whole)) refuse("is neither a folder nor a file");
    const Submissions itself{{{in_one_line(whole.filename().string()), whole}}};
    if (one || fs::is_regular_file(whole) || is_kit_of_a_learner(whole)) return itself;

    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(whole, error), end; !error && entry != end; entry.increment(error))
        entries.push_back(entry->path());
    if (error) refuse("cannot be read (" + error.message() + ")");
    std::sort(entries.begin(), entries.end());

    Submissions found;
    std::string mark, anothers;  // a sign of one submission; of another beside it
    for (const fs::path& entry : entries) {
        const std::string name = entry.filename().string(), written = in_one_line(name);
        if (is_ignored(name)) {
            if (holds_answers(entry, all_exercises()))
                refuse("'" + written + "' holds an answer, and a folder of that name is left out: rename it");
            found.left_out.push_back(written);
            continue;
        }
        found.all.push_back({written, entry});
        if (name == "exercises" || answers(entry, exercises))
            mark = mark.empty() ? written : mark;
        else if (may_be_anothers(entry))
            anothers = anothers.empty() ? written : anothers;
    }
    if (found.all.empty()) refuse("holds no submission");
    // A class one folder further down than was named would be one submission.
    for (const Submission& inner : found.all)
        if (const auto learners = learners_in(inner.place);
            learners.size() > 1 && (found.all.size() == 1 || inner.name == "exercises"))
            refuse("'" + inner.name + "' in it may be a class, with '" + learners[0] + "' and '" + learners[1] +
                   "': if it is, name that folder; if it is one submission, ./course grade " + given + " --one");
    if (mark.empty()) return found;
    if (!anothers.empty())
        refuse("'" + mark + "' in it makes it one submission, and '" + anothers +
               "' beside it may be another's: if it is one, ./course grade " + given +
               " --one; if it is a class, take '" + mark + "' out of it");
    return itself;
}

}  // namespace course
