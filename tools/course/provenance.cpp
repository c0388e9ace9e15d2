// course where

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "chapters.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "paths.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// A run, and the folder of its sources.
struct Run {
    std::string folder;
    fs::path sources, place;
};

// The run of this folder, or all runs.
std::vector<Run> runs_meant(const std::string& folder) {
    std::vector<Run> runs;
    for (const char* beside : {"instructions", "programs"})
        if (folder.empty() || folder == beside)
            runs.push_back(
                {beside, paths().source / "tools/instruction_counts", paths().build / "chapters" / beside / "run"});
    if (!folder.empty() && !runs.empty()) return runs;
    for (const auto& chapter : folder.empty() ? read_chapters() : std::vector{find_chapter(folder)})
        runs.push_back({chapter.folder, chapter.sources(), chapter.run()});
    return runs;
}

// The rows of a table of at least four columns, without its head.
std::vector<std::vector<std::string>> rows_of(const fs::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream lines(file);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
        rows.back().resize(std::max<std::size_t>(rows.back().size(), 4));
    }
    return rows;
}

// "file:number" of each line with this name in the files below `folder` with this ending. The name stands alone there,
// and `is_used` agrees with the file and the line.
template <class IsUsed>
std::vector<std::string> lines_with(const std::string& name, const fs::path& folder, const char* ending,
                                    const IsUsed& is_used) {
    std::vector<std::string> found;
    std::error_code none;  // a learner's edition lacks some
    const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (const auto& entry : fs::recursive_directory_iterator(folder, none)) {
        if (entry.path().extension() != ending) continue;
        std::ifstream lines(entry.path());
        int number = 1;
        for (std::string line; std::getline(lines, line); ++number) {
            const auto at = line.find(name);
            if (at == std::string::npos || (at > 0 && is_of_name(line[at - 1])) ||
                is_of_name((line + " ")[at + name.size()]) || !is_used(entry.path(), line))
                continue;
            found.push_back(fs::relative(entry.path(), paths().source).generic_string() + ":" + std::to_string(number));
        }
    }
    return found;
}

// Where a page's directive names it, or a plot reads it.
std::vector<std::string> uses_of(const std::string& name, const Run& run) {
    std::vector<std::string> uses = lines_with(name, run.sources, ".gp", [](const auto&, const auto&) { return true; });
    for (const char* folder : {"chapters", "docs", "engines"})
        for (const auto& use : lines_with(name, paths().source / folder, ".md", [&](const auto&page, const auto&line) {
                 const bool own = page.string().starts_with(run.sources.string() + "/");
                 return (line.find("{{") != std::string::npos || line.find("}}") != std::string::npos) &&
                        (own || line.find(run.folder + "/" + name) != std::string::npos);
             }))
            uses.push_back(use);
    return uses;
}

// Prints each number, check, data file and figure of this name, and returns the names of all.
std::vector<std::string> print_named(const std::string& name, const Run& run) {
    std::map<std::string, std::string> words;
    for (const auto& row : rows_of(run.place / "numbers.tsv"))
        words["number " + row[0]] = " = " + (row[1].empty() ? "not measured here" : row[1]) +
                                    (row[2].empty() ? "" : " " + row[2]) + ": " + row[3];
    for (const auto& row : rows_of(run.place / "checks.tsv")) words["check " + row[0]] = ": " + row[1];
    std::vector<std::string> names;
    const auto print = [&](const std::string& place, const std::string& kind) {
        const auto known = words.find(kind + " " + name);
        std::printf("%s\n  %s %s/%s%s\n", place.c_str(), kind.c_str(), run.folder.c_str(), name.c_str(),
                    known == words.end() ? "" : known->second.c_str());
        for (const std::string& use : uses_of(name, run))
            if (use != place) std::printf("  used at %s\n", use.c_str());
    };
    for (const auto& row : rows_of(run.place / "places.tsv")) {
        names.push_back(row[0]);
        if (row[0] == name) print(row[2], row[1]);
    }
    // No run says which line wrote a figure, or the data of a chapter's program: it is the first that names it.
    for (const auto& entry : fs::directory_iterator(run.place)) {
        const fs::path ending = entry.path().extension();
        const bool is_figure = ending == ".svg" || ending == ".gif";
        if (!is_figure && ending != ".dat") continue;
        names.push_back(entry.path().filename().string());
        if (names.back() != name) continue;
        const auto lines = lines_with("\"" + name + "\"", run.sources, is_figure ? ".gp" : ".cpp",
                                      [](const auto&, const auto&) { return true; });
        if (!lines.empty()) print(lines[0], is_figure ? "figure" : "data");
    }
    return names;
}

}  // namespace

void where(const std::string& asked) {
    std::string name = asked;
    if (name.starts_with("{{") && name.ends_with("}}")) name = name.substr(2, name.size() - 4);
    if (name.ends_with(".value")) name.resize(name.size() - 6);
    const auto slash = name.rfind('/');
    const std::vector<Run> runs = runs_meant(slash == std::string::npos ? "" : name.substr(0, slash));
    name.erase(0, slash + 1);
    if (name.empty())
        throw Stop(Status::bad_use, "'" + sanitized_line(asked) + "' names nothing; a name is 03/energy_mean, say");
    std::vector<std::string> names;
    std::string not_made;
    for (const Run& run : runs) {
        if (!fs::exists(run.place / "done")) {
            not_made += (not_made.empty() ? "" : ", ") + run.folder;
            continue;
        }
        for (const std::string& known : print_named(name, run)) names.push_back(known);
    }
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    if (!not_made.empty())
        throw Stop(Status::missing, "'" + sanitized_line(asked) +
                                        "': no run that was made here has that name; ./course tour makes those of " +
                                        not_made);
    const std::string near = nearest(name, names);
    throw Stop(Status::bad_use, "'" + sanitized_line(asked) +
                                    "': no run has a number, check, data file or figure of that name" +
                                    (near.empty() ? "" : "; near to it: " + near));
}

}  // namespace course
