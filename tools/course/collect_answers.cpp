// What a submission holds.

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "stop.hpp"
#include "submissions.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

const std::size_t most_entries = 20'000;
const int deepest = 32;

std::string in_small_letters(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

bool is_folder(const fs::directory_entry& entry) {
    std::error_code error;
    return fs::is_directory(entry.symlink_status(error));
}

// Why a file named after an exercise is no answer to it; "" if it is not meant as one.
std::string why_not(const fs::path& file, const std::string& exercise) {
    static const std::set<std::string> texts{"", ".c", ".h", ".hh", ".hpp", ".txt"};
    if (is_source(file)) return "must be named " + exercise + ".cpp, in exactly these letters: rename it";
    if (texts.contains(in_small_letters(file.extension().string())))
        return "does not have the name of a C++ file: rename it to " + exercise + ".cpp";
    return "";
}

// A file with an answer's name that is not graded, and why.
struct Aside {
    fs::path file;
    std::string why;
    bool in_left_out = false;  // its folder is listed as left out
    bool operator<(const Aside& other) const { return file < other.file; }
};

// All files with an answer's name, at any depth.
struct Search {
    const std::map<std::string, std::size_t>& wanted;  // exercise -> place in `found`
    fs::path root;
    std::vector<std::vector<fs::path>> found;
    std::vector<std::vector<Aside>> aside = std::vector<std::vector<Aside>>(found.size());
    std::size_t seen = 0, seen_aside = 0;
    std::string fault = {};             // why the search stopped
    std::vector<fs::path> others = {};  // files of C++ by other names
    std::vector<std::string> left_out = {};

    std::string below_root(const fs::path& place) const { return in_one_line(place.lexically_relative(root).string()); }

    void in(const fs::path& folder, int depth) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
            if (++seen > most_entries) {
                fault = "holds more than " + std::to_string(most_entries) + " files and folders";
                return;
            }
            const std::string name = entry->path().filename().string();
            if (is_ignored(name) || (name.starts_with(".") && is_folder(*entry))) {
                if (!is_of_the_course(entry->path())) left_out.push_back(below_root(entry->path()));
                if (is_folder(*entry)) in_left_out(entry->path(), entry->path(), depth + 1);
                continue;
            }
            const std::string stem = entry->path().stem().string();
            const auto at = wanted.find(in_small_letters(stem));
            if (at != wanted.end() && at->first == stem && is_source(name))
                found[at->second].push_back(entry->path());
            else if (is_folder(*entry)) {
                if (depth < deepest)
                    in(entry->path(), depth + 1);
                else
                    fault = "holds folders more than " + std::to_string(deepest) + " deep";
            } else {
                if (at != wanted.end())
                    if (const std::string why = why_not(entry->path(), at->first); !why.empty())
                        aside[at->second].push_back({entry->path(), why});
                if (is_source(entry->path())) others.push_back(entry->path());
            }
            error.clear();
        }
        if (error) fault = "holds a folder that cannot be read (" + error.message() + ")";
    }

    // Nothing is graded there, but a learner whose only answer is there is told. `top` is the folder that is left out.
    void in_left_out(const fs::path& top, const fs::path& folder, int depth) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end && ++seen_aside <= most_entries;
             entry.increment(error)) {
            const auto at = wanted.find(in_small_letters(entry->path().stem().string()));
            if (at != wanted.end() && is_source(entry->path()))
                aside[at->second].push_back(
                    {entry->path(), "lies where nothing is graded, in '" + below_root(top) + "': move it", true});
            else if (is_folder(*entry) && depth < deepest)
                in_left_out(top, entry->path(), depth + 1);
        }
    }
};

bool is_at_its_place(const fs::path& file, const Exercise& exercise) {
    const fs::path folder = file.parent_path();
    return folder.filename() == exercise.chapter && folder.parent_path().filename() == "exercises";
}

HandedIn choose(Search& search, std::size_t at, const Exercise& exercise) {
    auto& found = search.found[at];
    if (found.empty()) return {};
    std::sort(found.begin(), found.end());
    std::vector<fs::path> files = found;
    if (files.size() > 1) std::erase_if(files, [&](const fs::path& file) { return !is_at_its_place(file, exercise); });
    if (files.size() != 1)
        return {found[0], std::to_string(found.size()) + " files answer it, " +
                              (found.size() > 2 ? "among them " : "") + search.below_root(found[0]) + " and " +
                              search.below_root(found[1]) + ", and exercises/" + exercise.chapter +
                              " does not hold exactly one of them: keep only one"};
    for (const fs::path& file : found)
        if (file != files[0]) search.aside[at].push_back({file, ""});
    return {files[0], ""};
}

}  // namespace

const std::vector<Exercise>& all_exercises() {
    static const std::vector<Exercise> all = read_exercises();
    return all;
}

bool is_ignored(const std::string& name) {
    static const std::set<std::string> names{".git",         ".svn",        ".hg",
                                             ".DS_Store",    "__MACOSX",    ".Spotlight-V100",
                                             ".Trashes",     ".fseventsd",  "@eaDir",
                                             "Thumbs.db",    "desktop.ini", ".directory",
                                             "$RECYCLE.BIN", "lost+found",  "System Volume Information"};
    return names.contains(name) || name.starts_with("._");
}

// The parts of a checkout.
bool is_of_the_course(const fs::path& entry) {
    static const std::set<std::string> parts{"chapters",       "docs",
                                             "engines",        "exercises",
                                             "include",        "kit",
                                             "site",           "solutions",
                                             "tests",          "tools",
                                             "build",          "course",
                                             "CMakeLists.txt", "CMakePresets.json",
                                             "LICENSE",        "README.md",
                                             ".gitignore",     ".progress",
                                             ".github",        ".ci",
                                             ".clang-format"};
    std::error_code error;
    const fs::path folder = entry.parent_path();
    return parts.contains(entry.filename().string()) && fs::exists(folder / "include/timestep", error) &&
           fs::exists(folder / "chapters", error) && fs::is_regular_file(folder / "course", error);
}

bool is_source(const fs::path& file) {
    static const std::set<std::string> endings{".cpp", ".cc", ".cxx", ".c++"};
    return endings.contains(in_small_letters(file.extension().string()));
}

bool answers_another(const fs::path& file) {
    const auto& all = all_exercises();
    return std::any_of(all.begin(), all.end(), [&](const Exercise& exercise) { return exercise.name == file.stem(); });
}

// Opened once, and checked by its descriptor: the file behind the name may change.
std::string text_of(const HandedIn& answer) {
    const std::size_t most = 1 << 20;
    const std::string name = in_one_line(answer.file.filename().string());
    const auto refuse = [&](const std::string& why) { throw Stop(Status::bad_use, name + " " + why); };
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

Answers collect_answers(const Submission& submission, const std::vector<Exercise>& exercises) {
    Answers answers{std::vector<HandedIn>(exercises.size())};
    std::error_code error;
    const auto type = fs::symlink_status(submission.place, error).type();
    std::map<std::string, std::size_t> wanted;
    for (std::size_t i = 0; i < exercises.size(); ++i) wanted[exercises[i].name] = i;
    if (type != fs::file_type::directory) {
        const std::string name = submission.place.filename().string(), stem = submission.place.stem().string();
        const auto at = wanted.find(in_small_letters(stem));
        if (exercises.size() == 1)
            answers.all[0] = {submission.place, is_source(submission.place) || type != fs::file_type::regular
                                                    ? ""
                                                    : "it is neither a folder nor a C++ file, .cpp (archives are to be "
                                                      "unpacked first)"};
        else if (at != wanted.end()) {
            const bool right = is_source(name) && at->first == stem;
            const std::string why = right ? "" : why_not(name, at->first);
            if (right || !why.empty())
                answers.all[at->second] = {submission.place, right ? "" : in_one_line(name) + " " + why};
        }
        return answers;
    }
    Search search{wanted, submission.place, std::vector<std::vector<fs::path>>(exercises.size())};
    search.in(submission.place, 0);
    std::sort(search.left_out.begin(), search.left_out.end());
    answers.left_out = search.left_out;
    for (std::size_t i = 0; i < exercises.size(); ++i)
        answers.all[i] = search.fault.empty() ? choose(search, i, exercises[i])
                                              : HandedIn{submission.place, "the submission " + search.fault, true};
    const auto is_only = [&] {
        return exercises.size() == 1 && search.others.size() == 1 && !answers_another(search.others[0]);
    };
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        HandedIn& answer = answers.all[i];
        auto& aside = search.aside[i];
        if (!answer.file.empty()) {
            std::string others;
            int count = 0;
            for (const Aside& other : aside)
                if (!other.in_left_out && answer.refused.empty())
                    others += (count++ > 0 ? ", " : "") + search.below_root(other.file);
            if (count > 0)
                answer.beside = exercises[i].name + ": " + search.below_root(answer.file) + " is graded, " + others +
                                (count == 1 ? " is" : " are") + " left out";
            continue;
        }
        std::sort(aside.begin(), aside.end());
        // The only C++ file counts under any name: platforms and browsers rename files.
        if (is_only() && (aside.empty() || (aside.size() == 1 && aside[0].file == search.others[0])))
            answer.file = search.others[0];
        else if (!aside.empty())
            answer = {aside[0].file, search.below_root(aside[0].file) + " " + aside[0].why};
    }
    return answers;
}

}  // namespace course
