#include "submissions.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>

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

// Is it named after an exercise, of which we know that it is not the one looked for?
bool answers_another(const fs::path& file) {
    static const std::vector<Exercise> all = read_exercises();
    return std::any_of(all.begin(), all.end(),
                       [&](const Exercise& exercise) { return exercise.name == file.stem(); });
}

// Names are bytes: those that are no UTF-8 as %FF, so that no two names become one.
std::string name_of(const fs::path& place) {
    const std::string bytes = place.filename().string();
    std::string name;
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t size = character_at(bytes, i);
        char code[4];
        std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(bytes[i]));
        name += size > 0 ? bytes.substr(i, size) : code;
        i += std::max<std::size_t>(size, 1);
    }
    return name;
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

// What versions, file managers and archives leave beside the submissions.
bool is_litter(const std::string& name) {
    return name == ".git" || name == ".DS_Store" || name == "__MACOSX";
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
    for (const char c : name) {
        char code[8] = {c, '\0'};
        if (c == '\\')
            std::snprintf(code, sizeof code, "\\\\");
        else if (c == '\n' || c == '\t')
            std::snprintf(code, sizeof code, "\\%c", c == '\n' ? 'n' : 't');
        else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
            std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(c));
        line += code;
    }
    return sanitized(line);
}

namespace {

bool holds_answers(const Submission& submission, const std::vector<Exercise>& exercises) {
    const auto answers = answers_in(submission, exercises);
    return std::any_of(answers.begin(), answers.end(),
                       [](const HandedIn& answer) { return !answer.file.empty(); });
}

}  // namespace

std::vector<Submission> find_submissions(const fs::path& place,
                                         const std::vector<Exercise>& exercises, bool one) {
    std::error_code error;
    const fs::path whole = fs::canonical(place, error);
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use,
                   (place.empty() ? "''" : in_one_line(place.string())) + ": " + why);
    };
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (!fs::is_directory(whole) && !fs::is_regular_file(whole))
        refuse("is neither a folder nor a file");
    if (one || fs::is_regular_file(whole)) return {{name_of(whole), whole}};

    std::vector<Submission> all;
    bool own = false;  // answers
    for (fs::directory_iterator entry(whole, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name == "exercises") return {{name_of(whole), whole}};
        own = own || is_answer(entry->path(), exercises);
        if (!is_litter(name)) all.push_back({name_of(entry->path()), entry->path()});
    }
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (all.empty()) refuse("holds no submission: it is empty");
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    if (own) {
        for (const Submission& inner : all)
            if (fs::is_directory(fs::symlink_status(inner.place, error)) &&
                holds_answers(inner, exercises))
                refuse("holds answers itself, and so does '" + in_one_line(inner.name) +
                       "' in it: --one says that it is one submission");
        return {{name_of(whole), whole}};
    }
    return all;
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
