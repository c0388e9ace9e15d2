// course where

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "chapters.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "terminal.hpp"
#include "paths.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// A number, check, data file or figure, and the line that wrote it.
struct Thing {
    std::string kind, folder, name, file, words;
    int line = 0;
};

// A run, and the folder of its sources.
struct Run {
    std::string folder;
    fs::path sources, place;
    std::vector<Thing> things;
};

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, '\t');) cells.push_back(cell);
    cells.resize(std::max<std::size_t>(cells.size(), 4));
    return cells;
}

// The rows of a table, without its head.
std::vector<std::vector<std::string>> rows_of(const fs::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream lines(file);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) rows.push_back(cells_of(line));
    return rows;
}

std::string first_line_of(const fs::path& file) {
    std::ifstream lines(file);
    std::string line;
    std::getline(lines, line);
    std::replace(line.begin(), line.end(), '\t', ' ');
    return line;
}

std::string from_root(const fs::path& file) { return fs::relative(file, paths().source).generic_string(); }

// The data of a chapter's program, and figures: no run says which line wrote them, so the line is the first that names
// them.
void find_named(Run& run, const std::string& kind, const std::string& name, const char* ending) {
    std::error_code none;  // a learner's edition lacks some
    for (const auto& entry : fs::recursive_directory_iterator(run.sources, none)) {
        if (entry.path().extension() != ending) continue;
        std::ifstream lines(entry.path());
        int number = 1;
        for (std::string line; std::getline(lines, line); ++number)
            if (line.find("\"" + name + "\"") != std::string::npos) {
                run.things.push_back({kind, run.folder, name, from_root(entry.path()), "", number});
                return;
            }
    }
}

void read_things(Run& run) {
    std::map<std::string, std::string> numbers, checks;
    for (const auto& row : rows_of(run.place / "numbers.tsv"))
        numbers[row[0]] = " = " + (row[1].empty() ? "not measured here" : row[1]) +
                          (row[2].empty() ? "" : " " + row[2]) + ": " + row[3];
    for (const auto& row : rows_of(run.place / "checks.tsv")) checks[row[0]] = ": " + row[1];
    for (const auto& row : rows_of(run.place / "places.tsv")) {
        Thing thing{row[1], run.folder, row[0], row[2].substr(0, row[2].rfind(':')), ""};
        thing.line = std::atoi(row[2].c_str() + std::min(thing.file.size() + 1, row[2].size()));
        if (thing.kind == "number") thing.words = numbers[thing.name];
        if (thing.kind == "check") thing.words = checks[thing.name];
        if (thing.kind == "data") thing.words = ": " + first_line_of(run.place / thing.name);
        run.things.push_back(thing);
    }
    for (const auto& entry : fs::directory_iterator(run.place)) {
        const std::string name = entry.path().filename().string();
        const fs::path ending = entry.path().extension();
        if (ending == ".svg" || ending == ".gif") find_named(run, "figure", name, ".gp");
        if (ending == ".dat") find_named(run, "data", name, ".cpp");
    }
}

// The run of this folder, or all runs.
std::vector<Run> runs_meant(const std::string& folder) {
    std::vector<Run> runs;
    const fs::path all = paths().build / "chapters";
    for (const char* beside : {"instructions", "programs"})
        if (folder.empty() || folder == beside)
            runs.push_back({beside, paths().source / "tools/instruction_counts", all / beside / "run", {}});
    if (!folder.empty() && runs.empty()) {
        const Chapter chapter = find_chapter(folder);
        return {{chapter.folder, chapter.sources(), chapter.run(), {}}};
    }
    if (folder.empty())
        for (const auto& chapter : read_chapters())
            runs.push_back({chapter.folder, chapter.sources(), chapter.run(), {}});
    return runs;
}

std::string near_name(const std::vector<Run>& runs, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& run : runs)
        for (const auto& thing : run.things) names.push_back(thing.name);
    const std::string near = nearest(name, names);
    return near.empty() ? "" : "; near to it: " + near;
}

// Does the directive {{words}} of this page show the thing? `own` is the run of the page's chapter.
bool shows(const std::string& words, const std::string& own, const Thing& thing) {
    std::istringstream text(words.substr(0, words.find(':')));
    std::string first, reference;
    text >> first;
    const bool named = first == "check" || first == "figure" || first == "table" || first == "where";
    if (!named)
        reference = first;
    else
        text >> reference;
    if ((first == "check") != (thing.kind == "check")) return false;
    if (reference.ends_with(".value")) reference.resize(reference.size() - 6);
    const bool far = reference.find('/') != std::string::npos;
    return (far ? reference : own + "/" + reference) == thing.folder + "/" + thing.name;
}

// The lines of pages and plots that use it, by file.
std::map<std::string, std::set<std::ptrdiff_t>> uses_of(const Thing& thing) {
    std::map<std::string, std::set<std::ptrdiff_t>> uses;
    std::error_code none;
    for (const char* folder : {"chapters", "docs", "engines"})
        for (const auto& entry : fs::recursive_directory_iterator(paths().source / folder, none)) {
            const bool page = entry.path().extension() == ".md";
            const bool drawing = entry.path().extension() == ".gp" && thing.kind == "data";
            if (!page && !drawing) continue;
            const std::string text = contents(entry.path()), file = from_root(entry.path());
            const std::string own = fs::relative(entry.path(), paths().source / "chapters").begin()->string();
            if (drawing && own != thing.folder) continue;
            const std::string mark = page ? "{{" : thing.name;
            for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
                const auto end = std::min(text.find("}}", at), text.size());
                const bool quoted = at > 0 && std::string("\"'").find(text[at - 1]) != std::string::npos;
                if (page ? !shows(text.substr(at + 2, end - std::min(end, at + 2)), own, thing) : !quoted) continue;
                uses[file].insert(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
            }
        }
    return uses;
}

// Has the source changed since the run, so that the line may have moved?
bool has_changed(const Thing& thing, const Run& run) {
    const auto done = written_at(run.place / "done"), written = written_at(paths().source / thing.file);
    return done && (!written || *written > *done);
}

const char* words_before(const std::string& kind) {
    return kind == "check" ? "check " : kind == "data" ? "data file " : kind == "figure" ? "figure " : "";
}

void print(const Thing& thing, const Run& run) {
    std::printf("%s:%d\n  %s%s/%s%s\n", thing.file.c_str(), thing.line, words_before(thing.kind), thing.folder.c_str(),
                thing.name.c_str(), thing.words.c_str());
    for (const auto& [file, lines] : uses_of(thing))
        for (const auto line : lines) std::printf("  used at %s:%td\n", file.c_str(), line);
    if (has_changed(thing, run))
        std::printf("  (that file has changed since the run: ./course tour brings the run up to date)\n");
}

}  // namespace

void where(const std::string& asked) {
    std::string name = asked;
    if (name.starts_with("{{") && name.ends_with("}}")) name = name.substr(2, name.size() - 4);
    if (name.ends_with(".value")) name.resize(name.size() - 6);
    const auto slash = name.rfind('/');
    std::vector<Run> runs = runs_meant(slash == std::string::npos ? "" : name.substr(0, slash));
    if (slash != std::string::npos) name.erase(0, slash + 1);
    if (name.empty()) throw Stop(Status::bad_use, "'" + asked + "' names nothing; a name is 03/energy_mean, say");
    const auto made =
        std::stable_partition(runs.begin(), runs.end(), [](const Run& run) { return fs::exists(run.place / "done"); });
    std::vector<Run> missing(made, runs.end());
    runs.erase(made, runs.end());
    bool found = false;
    for (auto& run : runs) {
        read_things(run);
        for (const auto& thing : run.things) {
            if (thing.name != name) continue;
            if (found) std::printf("\n");
            print(thing, run);
            found = true;
        }
    }
    if (found) return;
    std::string not_made;
    for (const auto& run : missing) not_made += (not_made.empty() ? "" : ", ") + run.folder;
    if (!not_made.empty())
        throw Stop(
            Status::missing,
            "'" + asked + "': no run that was made here has that name; ./course tour makes those of " + not_made);
    throw Stop(Status::bad_use,
               "'" + asked + "': no run has a number, check, data file or figure of that name" + near_name(runs, name));
}

}  // namespace course
