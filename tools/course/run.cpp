// course run

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <system_error>

#include <unistd.h>

#include "build.hpp"
#include "chapters.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// The folder that the reader wants the run in. The run is made in a folder inside it and moved up when it is whole;
// otherwise nothing of it stays.
class Destination {
public:
    explicit Destination(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
        std::error_code error;
        for (fs::path path = folder_; !fs::exists(path, error) && path.has_relative_path(); path = path.parent_path())
            made_.push_back(path);
        try {
            fs::create_directories(folder_);
            unfinished_.emplace(folder_);
        } catch (const fs::filesystem_error& refused) {
            tidy();
            throw Stop(Status::bad_use,
                       "--out " + folder.string() + ": cannot write there (" + refused.code().message() + ")");
        }
    }
    ~Destination() { tidy(); }
    Destination(const Destination&) = delete;
    Destination& operator=(const Destination&) = delete;

    const fs::path& work() const { return unfinished_->path(); }

    // File by file. Moving within one file system takes no space: a full disk cannot stop it.
    void keep() {
        fs::remove(work() / "done");  // the build's mark
        for (const auto& file : fs::directory_iterator(work()))
            fs::rename(file.path(), folder_ / file.path().filename());
    }

    // Names the files as the reader knows them, not where they were being made.
    std::string in_readers_words(std::string text) const {
        const std::string inner = (work() / ".unfinished_run_").string();
        for (auto at = text.find(inner); at != std::string::npos; at = text.find(inner)) {
            auto end = at + inner.size();  // a random word follows
            while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end]))) ++end;
            text.replace(at, end - at, folder_.string());
        }
        return text;
    }

private:
    void tidy() {
        unfinished_.reset();
        std::error_code ignored;
        for (const auto& path : made_) fs::remove(path, ignored);
    }

    fs::path folder_;
    std::vector<fs::path> made_;  // folders that were not there before, innermost first
    std::optional<UnfinishedFolder> unfinished_;
};

std::string read(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A study names its own --help; the reader gets that through ./course.
std::string with_our_help(std::string text, const Chapter& chapter, const std::string& name) {
    const std::string help = chapter.program + " --help lists";
    const auto at = text.find(help);
    if (at != std::string::npos) text.replace(at, help.size(), "./course run " + name + " --study -- --help lists");
    return text;
}

// A list for CMake.
std::string cmake_list(const std::vector<std::string>& words) {
    std::string list;
    for (const auto& word : words) {
        if (!list.empty()) list += ';';
        for (const char c : word) list += c == ';' ? std::string("\\;") : std::string(1, c);
    }
    return list;
}

// What went wrong with a run, or what its program printed on standard error.
struct Complaint {
    Status status;
    std::string text;
};

std::string trimmed(std::string text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    return text;
}

// CMake's own error, in one line, without the place in our scripts.
std::string cmake_error(const std::string& error) {
    std::istringstream lines(error);
    std::string words;
    for (std::string line; std::getline(lines >> std::ws, line);) {
        if (line.starts_with("CMake Error at")) continue;
        if (!words.empty()) words += ' ';
        words += trimmed(line);
    }
    return words;
}

fs::path built(const std::string& program) { return paths().build / "chapters" / program; }

// Runs program, study and plots by the script that the build uses.
Complaint make_run(const Chapter& chapter, bool study, const fs::path& folder,
                   const std::vector<std::string>& options) {
    const fs::path source = paths().source;
    const fs::path file = paths().build / ("complaint_" + std::to_string(getpid()));
    std::string said;
    const int status =
        listen({paths().cmake, "-DPROGRAM=" + built(chapter.program).string(),
                "-DSTUDY=" + (study ? built(chapter.study()).string() : ""), "-DOUT=" + folder.string(),
                "-DROOM=" + chapter.sources().string(), "-DSTYLE=" + (source / "tools/figures/style.gp").string(),
                "-DGNUPLOT=gnuplot", "-DQUIET=ON", "-DARGUMENTS=" + cmake_list(options), "-DCOMPLAINT=" + file.string(),
                "-P", (source / "tools/cmake/run.cmake").string()},
               [&](std::string_view text) { said += text; });

    std::istringstream complaint(read(file));
    std::error_code ignored;
    fs::remove(file, ignored);
    int given = 0;
    complaint >> given >> std::ws;
    const std::string text{std::istreambuf_iterator<char>(complaint), {}};
    if (status == 0) return {Status::fine, trimmed(text)};
    if (given == 0) return {Status::bad_use, cmake_error(said)};  // CMake could not write a file
    return {static_cast<Status>(given), trimmed(text)};
}

}  // namespace

void run(const std::string& name, bool study, const std::optional<std::string>& out,
         const std::vector<std::string>& options) {
    const Chapter chapter = find_chapter(name);
    if (!study && !options.empty())
        throw Stop(Status::bad_use, "'" + options.front() + "': the numbers to change stand at the top of " +
                                        chapter.source() + "; the study takes options: ./course run " + name +
                                        " --study -- " + options.front());
    if (study && !chapter.has_study()) throw Stop(Status::bad_use, "--study: " + chapter.folder + " has no study");
    ProgressLine progress;
    std::vector<std::string> programs{chapter.program};
    if (study) programs.push_back(chapter.study());
    build(programs, progress);
    for (const auto& option : options) {
        if (option == "--help" || option == "-h") {
            listen({built(chapter.study()).string(), "--help"},
                   [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); });
            return;
        }
        if (option.empty()) throw Stop(Status::bad_use, "'': there is an empty word after the --");
        if (option.starts_with("--out"))
            throw Stop(Status::bad_use,
                       "--out belongs before the --: ./course run " + name + " --study --out DIR -- OPTIONS");
    }

    const fs::path folder = out ? fs::path(*out) : paths().build / "runs" / chapter.folder;
    if (folder.empty()) throw Stop(Status::bad_use, "--out '': must be the name of a folder");
    Destination destination(folder);
    const Complaint complaint = make_run(chapter, study, destination.work(), options);
    if (complaint.status != Status::fine)
        throw Stop(complaint.status, with_our_help(destination.in_readers_words(complaint.text), chapter, name));
    try {
        destination.keep();
    } catch (const fs::filesystem_error& error) {
        throw Stop(Status::bad_use, error.what());
    }
    std::printf("%s", read(folder / (study ? "run.txt" : "program.txt")).c_str());
    if (study)
        std::printf("\nData, numbers and figures: %s\n", fs::canonical(folder).c_str());
    else
        std::printf("\nIts picture: %s\nThe program: %s\n", (fs::canonical(folder) / chapter.picture).c_str(),
                    chapter.source().c_str());
    std::fflush(stdout);
    if (!complaint.text.empty()) std::fprintf(stderr, "%s\n", complaint.text.c_str());
}

}  // namespace course
