// course kit

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "build.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "process.hpp"
#include "paths.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// What is handed out unchanged: folders without their tests, and how the names of their files end.
struct Part {
    const char* folder;
    std::vector<std::string> endings;
};
const std::vector<Part> parts{
    {"chapters", {".cpp", ".hpp", ".gp", ".md", ".json", "CMakeLists.txt"}},
    {"docs/library", {".cpp"}},
    {"engines", {".cpp", ".hpp", ".h", ".c", ".cmake", ".patch", "CMakeLists.txt"}},
    {"include", {".hpp", ".h"}},
    {"tools/advise", {".cpp", ".hpp", ".cmake", ".txt"}},
    {"tools/bench", {".cpp", ".hpp", ".cmake", "CMakeLists.txt"}},
    {"tools/checker/learner", {".hpp"}},
    {"tools/cmake", {".cmake", ".sh"}},
    {"tools/course", {".cpp", ".hpp", "CMakeLists.txt"}},
    {"tools/figures", {".gp"}},
    {"tools/lab", {".cpp", ".hpp", "CMakeLists.txt"}},
    {"tools/live", {".hpp", ".md"}},
};
const std::vector<std::string> single_files{".gitignore", "CMakeLists.txt",       "CMakePresets.json",
                                            "LICENSE",    "tools/CMakeLists.txt", "tools/set_up.sh",
                                            "course"};

// The kit in the making, beside the folder that is wanted.
class Kit {
public:
    explicit Kit(const fs::path& wanted) : wanted_(wanted), folder_(wanted.parent_path()) {}

    /// Where `place` is to be; its folder is made.
    fs::path at(const fs::path& place) const {
        stop_if_interrupted();
        fs::create_directories((folder_.path() / place).parent_path());
        return folder_.path() / place;
    }
    void copy(const fs::path& from, const fs::path& place) const { fs::copy_file(from, at(place)); }
    void write(const fs::path& place, const std::string& text) const { write_whole(at(place), text); }
    void keep() const { fs::rename(folder_.path(), wanted_); }

private:
    TidyEnd tidy_end_;  // the last to go
    fs::path wanted_;
    UnfinishedFolder folder_;
};

// Every file below `folder`, relative to it, without tests, hidden files (an editor's) and links (which lead
// elsewhere).
std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator entry(folder), end; entry != end; ++entry) {
        const std::string name = entry->path().filename().string();
        const bool hidden = name.starts_with(".");
        if ((hidden || name == "tests") && entry->is_directory()) entry.disable_recursion_pending();
        if (!hidden && !entry->is_symlink() && entry->is_regular_file())
            files.push_back(fs::relative(entry->path(), folder));
    }
    return files;
}

// The about.json for learners.
std::string told_of(const Exercise& exercise) {
    return nlohmann::ordered_json{{"number", exercise.number},
                                  {"title", exercise.title},
                                  {"level", exercise.level},
                                  {"practises", exercise.practises},
                                  {"declaration", exercise.declaration},
                                  {"eigen", exercise.eigen},
                                  {"hints", exercise.hints},
                                  {"learned", exercise.learned}}
               .dump(2) +
           "\n";
}

// Copies a built file without the names and lines of its sources.
void copy_stripped(const fs::path& from, const fs::path& to, const std::string& what_to_strip) {
    const Outcome outcome = run_within({"strip", what_to_strip, "-o", to.string(), from.string()}, {60});
    if (outcome.status != 0)
        throw Stop(Status::bad_use,
                   to.string() + ": cannot be written (" + outcome.said.substr(0, outcome.said.find('\n')) + ")");
}

void write_exercises(const Kit& kit, bool with_solutions) {
    const fs::path built = paths().build / "exercises";
    for (const auto& exercise : read_exercises()) {
        const fs::path room = fs::path(exercise.chapter) / exercise.name;
        kit.write("kit/about" / room / "about.json", told_of(exercise));
        kit.copy(exercise.stub(), "exercises" / fs::path(room.string() + ".cpp"));
        if (with_solutions) kit.copy(exercise.solution(), "kit/solutions" / fs::path(room.string() + ".cpp"));
        kit.copy(exercise.stub(), "kit/generated" / exercise.stub().filename());
        kit.copy(exercise.declared(), "kit/generated" / exercise.declared().filename());
        kit.copy(exercise.told(), "kit/generated" / exercise.told().filename());
    }
    const auto commands = nlohmann::json::parse(contents(built / "commands.json"));
    copy_stripped(paths().build / "tools/course/kit_course", kit.at("kit/course"), "--strip-all");
    copy_stripped(built / "check", kit.at("kit/check"), "--strip-all");
    copy_stripped(std::string(commands.at("worker")), kit.at("kit/libtimestep_worker.a"), "--strip-debug");
    for (const auto& [name, object] : commands.at("workers").items())
        copy_stripped(std::string(object), kit.at("kit/workers/" + name + "_worker.o"), "--strip-debug");
    kit.copy(built / "machine.json", "kit/kit.json");
}

void write_kit(const Kit& kit, bool with_solutions) {
    const fs::path& source = paths().source;
    for (const auto& part : parts)
        for (const fs::path& file : files_in(source / part.folder))
            if (*file.begin() != "tests" &&
                std::any_of(part.endings.begin(), part.endings.end(),
                            [&](const auto& ending) { return file.filename().string().ends_with(ending); }))
                kit.copy(source / part.folder / file, part.folder / file);
    for (const auto& file : single_files) kit.copy(source / file, file);
    kit.copy(source / "tools/kit/README.md", "README.md");
    const fs::path site = paths().build / "site_kit/html";
    for (const fs::path& file : files_in(site)) kit.copy(site / file, "site" / file);
    write_exercises(kit, with_solutions);
}

// The absolute path of the folder, without links. Throws Stop if it cannot become a kit.
fs::path wanted(const std::string& name) {
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use, "kit: '" + sanitized_line(name) + "' " + why);
    };
    if (name.empty()) refuse("is no name of a folder");
    std::error_code error;
    fs::path folder = fs::weakly_canonical(fs::absolute(name), error);
    if (error) refuse("cannot be reached (" + error.message() + ")");
    if (!folder.has_filename()) folder = folder.parent_path();  // named with a / at its end
    if (fs::exists(fs::symlink_status(folder, error)) &&
        !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
        refuse("is there; a kit goes to a new or empty folder");
    if (!fs::is_directory(folder.parent_path(), error))
        refuse("cannot be made: the folder it is to be in is not there");
    const fs::path inside = folder.lexically_relative(fs::canonical(paths().source));
    if (!inside.empty() && *inside.begin() != ".." && *inside.begin() != "build")
        refuse("is in the course itself; a kit goes beside it");
    return folder;
}

}  // namespace

// Configures a learner's edition, which says what does not fit this machine.
void setup_kit() {
    if (!is_kit()) throw Stop(Status::bad_use, "run this command as ./course setup");
    {
        ProgressLine progress;
        build({}, progress);
    }
    std::fprintf(stderr, "course: everything that is needed is there. Next: ./course list\n");
}

void kit(const std::string& name, bool with_solutions) {
    if (is_kit()) throw Stop(Status::bad_use, "this is the learner's edition: it is itself what ./course kit makes");
    const fs::path folder = wanted(name);
    {
        ProgressLine progress;
        progress.say("Building what the learner's edition holds:");
        build({"kit"}, progress);
    }
    try {
        const Kit unfinished(folder);
        write_kit(unfinished, with_solutions);
        unfinished.keep();
    } catch (const fs::filesystem_error& error) {
        throw Stop(Status::bad_use, "kit: '" + name + "' cannot be written (" + error.code().message() +
                                        "; is the disk full?); nothing is left of it");
    }
    std::printf(
        "The learner's edition: %s\nIt holds no test's source%s. Hand it out as it is, for machines of this kind:\n"
        "the same system, processor and compiler.\n",
        folder.c_str(),
        with_solutions ? ". The solutions are in kit/solutions, as text for whoever looks there;\n"
                         "./course solution shows one after a pass"
                       : " and no solution");
}

}  // namespace course
