#include "submissions.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

const std::size_t most_entries = 20'000;
const int deepest = 32;

// What versions, file managers and archives leave beside the submissions, and beside each file of a Mac's.
bool is_litter(const std::string& name) {
    static const std::set<std::string> names{
        ".git",        ".svn",        ".hg",    ".DS_Store", "__MACOSX",        ".Spotlight-V100",
        ".Trashes",    ".fseventsd",  "@eaDir", "Thumbs.db", "desktop.ini",     ".directory",
        "$RECYCLE.BIN", "lost+found", "System Volume Information"};
    return names.contains(name) || name.starts_with("._");
}

// All that bears an answer's name, at whatever depth.
struct Search {
    const std::map<std::string, std::size_t>& wanted;  // file name -> place in `found`
    std::vector<std::vector<fs::path>> found;
    std::size_t seen = 0;
    std::string fault = {};  // why it has not seen all
    std::vector<fs::path> others = {};  // files of C++ by other names

    void in(const fs::path& folder, int depth) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            if (++seen > most_entries) {
                fault = "holds more than " + std::to_string(most_entries) + " files and folders";
                return;
            }
            const std::string name = entry->path().filename().string();
            if (is_litter(name)) continue;
            if (const auto at = wanted.find(name); at != wanted.end())
                found[at->second].push_back(entry->path());
            else if (!name.starts_with(".") && fs::is_directory(entry->symlink_status(error))) {
                if (depth < deepest)
                    in(entry->path(), depth + 1);
                else
                    fault = "holds folders more than " + std::to_string(deepest) + " deep";
            } else if (entry->path().extension() == ".cpp") {
                others.push_back(entry->path());
            }
            error.clear();
        }
        if (error) fault = "holds a folder that cannot be read (" + error.message() + ")";
    }
};

const std::vector<Exercise>& all_exercises() {
    static const std::vector<Exercise> all = read_exercises();
    return all;
}

// Is it named after an exercise, of which we know that it is not the one looked for?
bool answers_another(const fs::path& file) {
    const auto& all = all_exercises();
    return std::any_of(all.begin(), all.end(),
                       [&](const Exercise& exercise) { return exercise.name == file.stem(); });
}

bool is_at_its_place(const fs::path& file, const Exercise& exercise) {
    const fs::path folder = file.parent_path();
    return folder.filename() == exercise.chapter && folder.parent_path().filename() == "exercises";
}

HandedIn choose(const std::vector<fs::path>& found, const Exercise& exercise) {
    if (found.empty()) return {};
    std::vector<fs::path> files = found;
    if (files.size() > 1)
        std::erase_if(files, [&](const fs::path& file) { return !is_at_its_place(file, exercise); });
    const std::string name = exercise.name + ".cpp";
    if (files.size() != 1)
        return {found[0], std::to_string(found.size()) + " files are named " + name +
                              ", and not just one of them is exercises/" + exercise.chapter + "/" +
                              name};
    return {files[0], ""};
}

bool is_answer(const fs::path& entry, const std::vector<Exercise>& exercises) {
    return std::any_of(exercises.begin(), exercises.end(), [&](const Exercise& exercise) {
        return entry.filename() == exercise.name + ".cpp";
    });
}

}  // namespace

// Opened once, and all is asked of what was opened: what bears the name may change.
std::string text_of(const HandedIn& answer) {
    const std::size_t most = 1 << 20;
    const std::string name = in_one_line(answer.file.filename().string());
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use, name + " " + why);
    };
    if (!answer.refused.empty()) throw Stop(Status::bad_use, answer.refused);
    const int file = open(answer.file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0 && errno == ELOOP) refuse("is a link, and links are not followed");
    if (file < 0) refuse(std::string("cannot be read (") + std::strerror(errno) + ")");
    struct stat status {};
    std::string text(most + 1, '\0'), fault;
    std::size_t size = 0;
    if (fstat(file, &status) != 0 || S_ISDIR(status.st_mode))
        fault = "is a folder";
    else if (!S_ISREG(status.st_mode))
        fault = "is no regular file";
    while (fault.empty() && size < text.size()) {
        const ssize_t got = read(file, text.data() + size, text.size() - size);
        if (got < 0) fault = std::string("cannot be read (") + std::strerror(errno) + ")";
        if (got <= 0) break;
        size += static_cast<std::size_t>(got);
    }
    close(file);
    if (fault.empty() && size > most) fault = "is larger than 1 MB";
    if (!fault.empty()) refuse(fault);
    text.resize(size);
    return text;
}

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
    const auto answers = answers_in({"", place}, exercises);
    return std::any_of(answers.begin(), answers.end(),
                       [](const HandedIn& answer) { return !answer.file.empty(); });
}

// A folder that holds the whole course: what it is made of belongs to it.
bool is_of_the_course(const fs::path& entry) {
    static const std::set<std::string> parts{
        "chapters", "docs",  "exercises", "include",        "kit",               "site",    "solutions", "tests",
        "tools",    "build", "course",    "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", ".gitignore",
        ".progress", ".github", ".ci", ".clang-format"};
    std::error_code error;
    const fs::path folder = entry.parent_path();
    return parts.contains(entry.filename().string()) && fs::exists(folder / "include/timestep", error) &&
           fs::exists(folder / "chapters", error) && fs::is_regular_file(folder / "course", error);
}

// May it be somebody's, who would be lost where the folder that it is in is taken for one submission?
bool may_be_anothers(const fs::path& entry) {
    const std::string name = entry.filename().string();
    if (name.starts_with(".")) return holds_answers(entry, all_exercises());
    std::error_code error;
    const auto type = fs::symlink_status(entry, error).type();
    if (type != fs::file_type::regular) return !is_of_the_course(entry);
    static const std::set<std::string> packed{".zip", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".zst", ".7z", ".rar"};
    return packed.contains(entry.extension().string()) || (entry.extension() == ".cpp" && !answers_another(entry));
}

// The names of its folders that hold answers and are no chapters; none where it holds an answer itself: two are a class.
std::vector<std::string> learners_in(const fs::path& folder, const std::vector<Exercise>& exercises) {
    std::vector<std::string> names;
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(folder, error))) return {};
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name == "exercises" || is_answer(entry->path(), all_exercises())) return {};
        const bool chapter = std::any_of(all_exercises().begin(), all_exercises().end(),
                                         [&](const Exercise& exercise) { return exercise.chapter == name; });
        if (!chapter && !name.starts_with(".") && !is_litter(name) &&
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

// As it is to be typed.
std::string typed(const std::string& word) {
    const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return std::isalnum(c) || std::strchr("_-./", c) != nullptr;
    });
    std::string inside = word;
    replace_all(inside, "'", "'\\''");
    return plain && !word.empty() ? word : "'" + inside + "'";
}

}  // namespace

Submissions find_submissions(const fs::path& place, const std::vector<Exercise>& exercises, bool one) {
    std::error_code error;
    const fs::path whole = fs::canonical(place, error);
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use,
                   (place.empty() ? "''" : in_one_line(place.string())) + ": " + why);
    };
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (!fs::is_directory(whole) && !fs::is_regular_file(whole))
        refuse("is neither a folder nor a file");
    const Submission itself{in_one_line(whole.filename().string()), whole};
    if (one || fs::is_regular_file(whole)) return {{itself}};

    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(whole, error), end; !error && entry != end;
         entry.increment(error))
        entries.push_back(entry->path());
    if (error) refuse("cannot be read (" + error.message() + ")");
    std::sort(entries.begin(), entries.end());

    Submissions found;
    std::string mark, anothers;       // of one submission; of somebody beside it
    std::vector<std::string> beside;  // what is left out where it is one
    for (const fs::path& entry : entries) {
        const std::string name = entry.filename().string(), written = in_one_line(name);
        if (is_litter(name)) {
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
    return {{itself}, beside};
}

std::vector<HandedIn> answers_in(const Submission& submission,
                                 const std::vector<Exercise>& exercises) {
    std::vector<HandedIn> answers(exercises.size());
    std::error_code error;
    const auto type = fs::symlink_status(submission.place, error).type();
    if (type != fs::file_type::directory) {
        for (std::size_t i = 0; i < exercises.size(); ++i) {
            if (exercises.size() > 1 && submission.name != exercises[i].name + ".cpp") continue;
            const bool source = submission.place.extension() == ".cpp";
            answers[i] = {submission.place,
                          source || type != fs::file_type::regular
                              ? ""
                              : "it is neither a folder nor a .cpp file (archives are to be "
                                "unpacked first)"};
        }
        return answers;
    }
    std::map<std::string, std::size_t> wanted;
    for (std::size_t i = 0; i < exercises.size(); ++i) wanted[exercises[i].name + ".cpp"] = i;
    Search search{wanted, std::vector<std::vector<fs::path>>(exercises.size())};
    search.in(submission.place, 0);
    for (std::size_t i = 0; i < exercises.size(); ++i)
        answers[i] = search.fault.empty()
                         ? choose(search.found[i], exercises[i])
                         : HandedIn{submission.place, "the submission " + search.fault};
    // By another name, as platforms and browsers give them: it can only be the one.
    if (exercises.size() == 1 && answers[0].file.empty() && search.others.size() == 1 &&
        !answers_another(search.others[0]))
        answers[0].file = search.others[0];
    return answers;
}

}  // namespace course
