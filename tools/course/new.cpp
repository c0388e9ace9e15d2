// course new chapter, course new exercise

#include <algorithm>
#include <cstdio>
#include <utility>

#include "build.hpp"
#include "chapters.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void give_up(const std::string& line) { throw Stop(Status::bad_use, line); }

// A file to be made from a template in tools/new, and what its author is to fill in.
struct Skeleton {
    std::string sample, place, fill_in;
};

// What stands in a template, and what takes its place.
using Replacements = std::vector<std::pair<std::string, std::string>>;

std::string filled(const std::string& sample, const Replacements& words) {
    std::string text = contents(paths().source / "tools/new" / sample);
    for (const auto& [word, by] : words) replace_all(text, word, by);
    return text;
}

// Files in the making: in the end all of them are there, or nothing has changed.
class InTheMaking {
public:
    InTheMaking() = default;
    ~InTheMaking() { undo(); }
    InTheMaking(const InTheMaking&) = delete;
    InTheMaking& operator=(const InTheMaking&) = delete;

    void write(const std::string& place, const std::string& text) {
        const fs::path file = paths().source / place;
        std::error_code error;
        if (fs::exists(fs::symlink_status(file, error))) give_up(place + " is there already; nothing was made");
        make_folder(file.parent_path());
        write_whole(file, text);
        made_.push_back(file);
    }
    void keep() {
        stop_if_interrupted();
        made_.clear();
    }
    void undo() {
        std::error_code ignored;  // a folder goes if it is empty
        for (auto path = made_.rbegin(); path != made_.rend(); ++path) fs::remove(*path, ignored);
        made_.clear();
    }

private:
    void make_folder(const fs::path& folder) {
        std::error_code error;
        if (fs::is_directory(folder, error)) return;
        make_folder(folder.parent_path());
        if (!fs::create_directory(folder, error)) give_up(folder.string() + ": cannot be made");
        made_.push_back(folder);
    }

    TidyEnd tidy_end_;  // the last to go
    std::vector<fs::path> made_;
};

// velocity_now: Velocity now
std::string title_from(std::string name) {
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// A name that a file, a target of CMake and a function can have. The build refuses the words of C++ and the names that
// it has already.
void check_name(const std::string& name) {
    const auto refuse = [&](const std::string& rule) {
        give_up("'" + shortened(sanitized_line(name), 60) + "': " + rule);
    };
    const bool plain = std::all_of(name.begin(), name.end(),
                                   [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
    if (!plain || name.empty() || name.front() < 'a' || name.back() == '_' || name.find("__") != std::string::npos)
        refuse("a name is small letters, digits and single _ between them, and begins with a letter");
    if (name.size() > 40) refuse("a name has at most 40 letters");
}

// Takes it back, and CMake's own files with it, unless it can be built.
void try_out(InTheMaking& unfinished, const std::string& name, const std::vector<std::string>& targets) {
    std::string why;
    try {
        configure();
        ProgressLine progress;
        build(targets, progress, "Building " + name + " once, to see that it can be built");
        return;
    } catch (const Stop& stop) {
        if (stop.status() == Status::interrupted) throw;
        why = stop.what();
    }
    unfinished.undo();
    try {
        configure();
    } catch (const Stop&) {  // nor could it be before
    }
    give_up("'" + name + "' was not made: " + why);
}

void print_parts(const std::vector<Skeleton>& parts) {
    std::size_t width = 0;
    for (const auto& part : parts) width = std::max(width, part.place.size());
    for (const auto& part : parts) std::printf("  %s  %s\n", padded(part.place, width).c_str(), part.fill_in.c_str());
}

}  // namespace

void new_chapter(const std::string& name, bool all) {
    if (is_kit()) give_up("this is the learner's edition: chapters are added to the whole course");
    check_name(name);
    int number = 1;
    for (const auto& chapter : read_chapters()) {
        if (chapter.program == name) give_up("'" + name + "': chapters/" + chapter.folder + " has that name");
        number = chapter.number() + 1;
    }
    if (number > 99) give_up("there are chapters up to 99, and a chapter's number has two digits");

    const std::string digits = (number < 10 ? "0" : "") + std::to_string(number), folder = digits + "_" + name;
    const Replacements words{{"NEW_NAME", name},
                             {"NEW_TITLE", title_from(name)},
                             {"NEW_NUMBER", std::to_string(number)},
                             {"NEW_DIGITS", digits},
                             {"NEW_CHAPTER", folder}};
    const std::string room = "chapters/" + folder + "/";
    std::vector<Skeleton> parts{
        {"about.json", room + "about.json", "title, question and picture"},
        {"chapter.md", room + "chapter.md", "the page"},
        {"program.cpp", room + name + ".cpp", "the program, with the numbers to change at its top"},
        {"figures.gp", room + "figures.gp", "its picture"}};
    std::vector<std::string> targets{name};
    if (all) {
        parts.push_back({"all/study.cpp", room + "study/study.cpp", "measures the page's numbers and checks"});
        parts.push_back({"all/figures.gp", room + "study/figures.gp", "figures of what the study measures"});
        parts.push_back({"all/live.cpp", room + "live/" + name + ".cpp", "a panel that moves on the page"});
        parts.push_back({"all/test.cpp", "tests/chapters/" + folder + ".cpp", "tests of claims that no study checks"});
        targets.push_back(name + "_study");
    }
    InTheMaking unfinished;
    for (const auto& part : parts) {
        std::string text = filled("chapter/" + part.sample, words);
        if (all && part.sample == "chapter.md") text += filled("chapter/all/sections.md", words);
        unfinished.write(part.place, text);
    }
    try_out(unfinished, name, targets);
    unfinished.keep();
    listen({paths().cmake, "-DROOT=" + paths().source.string(), "-P",
            (paths().source / "tools/cmake/readme_table.cmake").string()},
           [](std::string_view words_of_cmake) { std::fprintf(stderr, "%s", std::string(words_of_cmake).c_str()); });
    std::printf("Chapter %d, %s, is a small example that works. Put your own in its place, where FILL IN stands:\n\n",
                number, name.c_str());
    print_parts(parts);
    std::printf(
        "\nThe table of chapters in README.md lists it; cmake --build build --target readme\nwrites that table again "
        "when you have changed title or question.\n%s"
        "Next: ./course run %d, then ./course site; ./course new exercise %d NAME adds an exercise.\n",
        all ? "" : "A study, a panel and tests are optional: ./course new chapter NAME --all shows them.\n", number,
        number);
}

void new_exercise(const std::string& chapter_meant, const std::string& name) {
    if (is_kit()) give_up("this is the learner's edition: exercises are added to the whole course");
    check_name(name);
    const Chapter chapter = find_chapter(chapter_meant);
    int number = 1;
    for (const auto& exercise : read_exercises()) {
        if (exercise.name == name) give_up("'" + name + "': exercise " + exercise.place() + " has that name");
        if (exercise.chapter == chapter.folder) number = std::max(number, exercise.number + 1);
    }

    const Replacements words{{"NEW_NAME", name},
                             {"NEW_TITLE", title_from(name)},
                             {"NEW_PLACE", std::to_string(number)},
                             {"NEW_NUMBER", std::to_string(chapter.number())}};
    const std::string room = "tests/exercises/" + chapter.folder + "/" + name + "/",
                      file = chapter.folder + "/" + name + ".cpp";
    const std::vector<Skeleton> parts{
        {"solution.cpp", "solutions/" + file, "the task, and the course's answer between two lines // [answer]"},
        {"about.json", room + "about.json", "title, declaration, hints"},
        {"properties.cpp", room + "properties.cpp", "the hidden tests"},
        {"correct.cpp", room + "correct.cpp", "two or more right answers"},
        {"mistakes.diff", room + "mistakes.diff", "four or more wrong answers, and what is said of each"}};
    InTheMaking unfinished;
    for (const auto& part : parts) unfinished.write(part.place, filled("exercise/" + part.sample, words));
    try_out(unfinished, name, {"ready_" + name});  // which makes the learner's file from the solution
    Exercise exercise;
    exercise.name = name;
    unfinished.write("exercises/" + file, contents(exercise.stub()));
    unfinished.keep();
    std::printf(
        "Exercise %d.%d, %s, is a small example that works. Put your own in its place, where FILL IN stands:\n"
        "  grep -rn 'FILL IN' %s solutions/%s\n\n",
        chapter.number(), number, name.c_str(), room.c_str(), file.c_str());
    print_parts(parts);
    std::printf(
        "\nThe learner's file is exercises/%s;\n./course reset %s makes it again from the solution.\n"
        "Next: ./course check %s --file solutions/%s, and ./course test.\n",
        file.c_str(), name.c_str(), name.c_str(), file.c_str());
}

}  // namespace course
