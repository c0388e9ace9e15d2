// course run

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
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
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

const char* const unfinished = ".unfinished_run_";  // so run.cmake calls the folder where it makes a run

// Removes what a run that failed or was ended has left, and the folder itself if nothing else is in it.
void tidy(const fs::path& folder) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename().string().starts_with(unfinished)) fs::remove_all(entry.path(), ignored);
    fs::remove(folder, ignored);
}

// A study names its own --help, and files where they were being made; the reader gets both as ./course has them.
std::string in_readers_words(std::string text, const Chapter& chapter, const std::string& name,
                             const fs::path& folder) {
    replace_all(text, chapter.program + " --help lists", "./course run " + name + " --study -- --help lists");
    for (auto at = text.find(unfinished); at != std::string::npos; at = text.find(unfinished)) {
        const auto begin = text.rfind(folder.string(), at), end = text.find('/', at);
        if (begin == std::string::npos || end == std::string::npos) return text;
        text.replace(begin, end - begin, folder.string());
    }
    return text;
}

// A list for CMake.
std::string cmake_list(const std::vector<std::string>& words) {
    std::string list;
    for (std::string word : words) {
        replace_all(word, ";", "\\;");
        list += (list.empty() ? "" : ";") + word;
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

    if (out && out->empty()) throw Stop(Status::bad_use, "--out '': must be the name of a folder");
    const fs::path folder = fs::absolute(out ? fs::path(*out) : paths().build / "runs" / chapter.folder);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || access(folder.c_str(), W_OK) != 0)
        throw Stop(Status::bad_use, "--out " + shown(folder) + ": cannot write there (" +
                                        (error ? error.message() : "no right to") + ")");
    Complaint complaint;
    try {
        complaint = make_run(chapter, study, folder, options);
    } catch (const Stop&) {
        tidy(folder);
        throw;
    }
    if (complaint.status != Status::fine) {
        tidy(folder);
        throw Stop(complaint.status, in_readers_words(complaint.text, chapter, name, folder));
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
