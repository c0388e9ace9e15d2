// course new chapter, course new exercise

#include <algorithm>
#include <cstdio>
#include <utility>

#include "read_json.hpp"

#include "chapters.hpp"
#include "commands.hpp"
#include "build.hpp"
#include "exercises.hpp"
#include "process.hpp"
#include "new_name.hpp"
#include "paths.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void give_up(const std::string& line) { throw Stop(Status::bad_use, line); }

// What stands in the files of tools/new, and what takes its place.
using Replacements = std::vector<std::pair<std::string, std::string>>;

// A file that is made from one of tools/new, and what is to be filled in there.
struct Skeleton {
    std::string sample, place, fill_in;
};

std::string filled(const std::string& sample, const Replacements& words) {
    const fs::path file = paths().source / "tools/new" / sample;
    std::string text = contents(file);
    for (const auto& [word, by] : words) replace_all(text, word, by);
    const auto left = text.find("NEW_");
    if (left != std::string::npos) {
        const auto end = text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_", left);
        give_up(shown(file) + ": nothing stands for " + text.substr(left, end - left));
    }
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
        undo_.emplace_back(file, std::nullopt);
    }
    void change(const std::string& place, const std::string& text) {
        const fs::path file = paths().source / place;
        std::string before = contents(file);
        write_whole(file, text);
        undo_.emplace_back(file, std::move(before));
    }
    void keep() {
        stop_if_interrupted();
        undo_.clear();
    }
    void undo() {
        for (auto step = undo_.rbegin(); step != undo_.rend(); ++step) step->second ? restore(*step) : remove(*step);
        undo_.clear();
    }

private:
    using Step = std::pair<fs::path, std::optional<std::string>>;  // what to bring back; nothing: was not there
    static void remove(const Step& step) {
        std::error_code ignored;
        fs::remove(step.first, ignored);  // a folder, where it is empty
    }
    static void restore(const Step& step) {
        try {
            write_whole(step.first, *step.second);
        } catch (const Stop&) {  // it is not to be written to any more
        }
    }
    void make_folder(const fs::path& folder) {
        std::error_code error;
        if (fs::is_directory(folder, error)) return;
        make_folder(folder.parent_path());
        if (!fs::create_directory(folder, error)) give_up(folder.string() + ": cannot be made");
        undo_.emplace_back(folder, std::nullopt);
    }

    TidyEnd tidy_end_;  // over when all else is
    std::vector<Step> undo_;
};

// velocity_now: Velocity now
std::string title_from(std::string name) {
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// README.md with this line at the end of its table of chapters.
std::string readme_with(const std::string& line) {
    std::string text = contents(paths().source / "README.md");
    const auto last = text.rfind("](chapters/");
    const auto end = last == std::string::npos ? last : text.find('\n', last);
    if (end == std::string::npos) give_up("README.md has no table of chapters, where the new one belongs");
    return text.insert(end + 1, line + "\n");
}

// The build must take it; else it is not made, and the build is what it was. CMake may have written what Ninja cannot
// read, and who cannot read it does not ask CMake again: so we do.
void try_out(const std::string& name, InTheMaking& unfinished) {
    std::string why;
    try {
        configure();
        why = why_unbuildable();
        if (why.empty()) return;
    } catch (const Stop& stop) {
        if (stop.status() != Status::bad_use) throw;
        why = stop.what();
    }
    unfinished.undo();
    try {
        configure();
    } catch (const Stop& stop) {  // as before
        if (stop.status() != Status::bad_use) throw;
    }
    give_up("'" + name + "' was not made: " + why);
}

void tell(const std::vector<Skeleton>& parts, const std::string& next) {
    std::size_t width = 0;
    for (const auto& part : parts) width = std::max(width, part.place.size());
    for (const auto& part : parts) std::printf("  %s  %s\n", padded(part.place, width).c_str(), part.fill_in.c_str());
    std::printf("\n%s", next.c_str());
}

}  // namespace

void new_chapter(const std::string& name) {
    if (is_kit()) give_up("this is the learner's edition: chapters are added to the whole course");
    check_name(name);
    const auto chapters = read_chapters();
    int number = 1;
    for (const auto& chapter : chapters) {
        if (chapter.program == name || chapter.study() == name || chapter.program == name + "_study")
            give_up("'" + name + "': chapters/" + chapter.folder + " has a program of that name");
        number = chapter.number() + 1;
    }
    if (number > 99) give_up("there are chapters up to 99, and a chapter's number has two digits");
    check_chapter_is_new(name);

    const std::string digits = (number < 10 ? "0" : "") + std::to_string(number), folder = digits + "_" + name;
    const Replacements words{{"NEW_NAME", name},
                             {"NEW_TITLE", title_from(name)},
                             {"NEW_NUMBER", std::to_string(number)},
                             {"NEW_DIGITS", digits},
                             {"NEW_CHAPTER", folder}};
    const std::string room = "chapters/" + folder + "/";
    const std::vector<Skeleton> parts{
        {"chapter/about.json", room + "about.json", "title, question, claims of the talks, figures"},
        {"chapter/chapter.md", room + "chapter.md", "the page"},
        {"chapter/program.cpp", room + name + ".cpp",
         "the program: one short file, its numbers to play with at the top"},
        {"chapter/figures.gp", room + "figures.gp", "its picture"},
        {"chapter/live.cpp", room + "live/" + name + ".cpp",
         "a live panel: the same, in the reader's hand (or no folder live)"},
        {"chapter/study/study.cpp", room + "study/study.cpp", "what finds the page's numbers and checks"},
        {"chapter/study/figures.gp", room + "study/figures.gp", "more figures, from what the study finds"},
        {"chapter/test.cpp", "tests/chapters/" + folder + ".cpp", "what the chapter claims, as tests"}};
    InTheMaking unfinished;
    for (const auto& part : parts) unfinished.write(part.place, filled(part.sample, words));
    const auto about = read_json(filled("chapter/about.json", words));
    unfinished.change(
        "README.md", readme_with("| [" + std::to_string(number) + " " + std::string(about.at("title")) + "](chapters/" +
                                 folder + ") | " + std::string(about.at("question")) + " |"));
    try_out(name, unfinished);
    unfinished.keep();
    std::printf("Chapter %d, %s: a small example, whole. Put your own in its place, where FILL IN stands:\n\n", number,
                name.c_str());
    tell(parts,
         "Its title and question stand in README.md, too, in the table of chapters.\n"
         "Next: ./course run " +
             std::to_string(number) +
             ", ./course tour and ./course test; an exercise to it:\n"
             "./course new exercise " +
             std::to_string(number) + " NAME\n");
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
    check_exercise_is_new(name);

    const Replacements words{{"NEW_NAME", name},
                             {"NEW_TITLE", title_from(name)},
                             {"NEW_PLACE", std::to_string(number)},
                             {"NEW_NUMBER", std::to_string(chapter.number())}};
    const std::string room = "tests/exercises/" + chapter.folder + "/" + name + "/",
                      file = chapter.folder + "/" + name + ".cpp";
    const std::vector<Skeleton> parts{
        {"exercise/solution.cpp", "solutions/" + file,
         "the task, and the course's answer between two lines // [answer]"},
        {"exercise/about.json", room + "about.json", "title, declaration, hints"},
        {"exercise/properties.cpp", room + "properties.cpp", "the hidden tests"},
        {"exercise/correct.cpp", room + "correct.cpp", "two answers or more that are right"},
        {"exercise/mistakes.diff", room + "mistakes.diff", "four or more that are wrong, and what is said of each"}};
    InTheMaking unfinished;
    for (const auto& part : parts) unfinished.write(part.place, filled(part.sample, words));
    try_out(name, unfinished);  // makes the learner's file from the solution
    Exercise exercise;
    exercise.name = name;
    unfinished.write("exercises/" + file, contents(exercise.stub()));
    unfinished.keep();
    std::printf(
        "Exercise %d.%d, %s: a small example, whole. Put your own in its place, where FILL IN stands:\n"
        "  grep -rn 'FILL IN' %s solutions/%s\n\n",
        chapter.number(), number, name.c_str(), room.c_str(), file.c_str());
    tell(parts, "The learner's file is exercises/" + file + ";\n./course reset " + name +
                    " makes it again from the solution.\n"
                    "Next: ./course check " +
                    name + " --file solutions/" + file + ", and ./course test.\n");
}

}  // namespace course
