#include "submissions.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

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

    bool too_much() const { return seen > most_entries; }
    void in(const fs::path& folder, int depth) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            if (++seen > most_entries) return;
            const std::string name = entry->path().filename().string();
            if (const auto at = wanted.find(name); at != wanted.end())
                found[at->second].push_back(entry->path());
            else if (!name.starts_with(".") && depth < deepest &&
                     fs::is_directory(entry->symlink_status(error)))
                in(entry->path(), depth + 1);
            error.clear();
        }
    }
};

// Why a file cannot be taken; "" where it can.
std::string fault_of(const fs::path& file) {
    std::error_code error;
    switch (fs::symlink_status(file, error).type()) {
    case fs::file_type::regular: break;
    case fs::file_type::symlink: return "is a link, and links are not followed";
    case fs::file_type::directory: return "is a folder";
    default: return "is no regular file";
    }
    if (fs::file_size(file, error) > 1 << 20) return "is larger than 1 MB";
    return {};
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
    const std::string fault = fault_of(files[0]);
    return {files[0], fault.empty() ? "" : name + " " + fault};
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

std::string in_one_line(const std::string& name) {
    std::string line;
    for (const char c : name) {
        char code[8] = {c, '\0'};
        if (c == '\n' || c == '\t')
            std::snprintf(code, sizeof code, "\\%c", c == '\n' ? 'n' : 't');
        else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
            std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(c));
        line += code;
    }
    return harmless(line);
}

std::vector<Submission> find_submissions(const fs::path& place,
                                         const std::vector<Exercise>& exercises, bool one) {
    std::error_code error;
    const fs::path whole = fs::canonical(place, error);
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use, in_one_line(place.string()) + ": " + why);
    };
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (!fs::is_directory(whole) && !fs::is_regular_file(whole))
        refuse("is neither a folder nor a file");
    if (one || fs::is_regular_file(whole)) return {{whole.filename().string(), whole}};

    std::vector<Submission> all;
    for (fs::directory_iterator entry(whole, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name == "exercises" || is_answer(entry->path(), exercises))
            return {{whole.filename().string(), whole}};
        if (!is_litter(name)) all.push_back({name, entry->path()});
    }
    if (error) refuse("cannot be read (" + error.message() + ")");
    if (all.empty()) refuse("holds no submission: it is empty");
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
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
            std::string fault = fault_of(submission.place);
            if (fault.empty() && submission.place.extension() != ".cpp")
                fault = "is neither a folder nor a .cpp file (archives are to be unpacked first)";
            answers[i] = {submission.place, fault.empty() ? "" : "the submission " + fault};
        }
        return answers;
    }
    std::map<std::string, std::size_t> wanted;
    for (std::size_t i = 0; i < exercises.size(); ++i) wanted[exercises[i].name + ".cpp"] = i;
    Search search{wanted, std::vector<std::vector<fs::path>>(exercises.size())};
    search.in(submission.place, 0);
    for (std::size_t i = 0; i < exercises.size(); ++i)
        answers[i] = search.too_much()
                         ? HandedIn{submission.place, "the submission holds more than " +
                                                          std::to_string(most_entries) +
                                                          " files and folders"}
                         : choose(search.found[i], exercises[i]);
    return answers;
}

}  // namespace course
