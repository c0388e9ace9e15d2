// course hint, course solution, course reset

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "commands.hpp"
#include "build.hpp"
#include "paths.hpp"
#include "progress.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// The code without the task above it and without the marks round the answer.
std::vector<std::string> code_of(const fs::path& file) {
    std::vector<std::string> code;
    std::istringstream lines(sanitized(contents(file)));
    for (std::string line; std::getline(lines, line);)
        if (line.find("// [answer]") == std::string::npos) code.push_back(line);
    const auto begin = std::find_if(code.begin(), code.end(), [](const std::string& line) {
        return !line.empty() && !line.starts_with("//") && !line.starts_with("#");
    });
    code.erase(code.begin(), begin);
    return code;
}

// Has somebody who works on the course changed the solution since?
bool made_from_an_older_solution(const Exercise& exercise) {
    if (is_kit()) return false;  // whose stubs come made
    const auto solution = written_at(exercise.solution()), stub = written_at(exercise.stub());
    return solution && (!stub || *stub < *solution);
}

// Makes the file what it was. What is in it is kept: somebody may have meant another exercise.
void begin_again(const Exercise& exercise) {
    if (untouched(exercise)) return;
    const fs::path file = exercise.file();
    const std::string stub = contents(exercise.stub());
    std::error_code error, ignored;
    if (fs::exists(fs::symlink_status(file, error))) {
        const fs::path kept = paths().source / ".progress" / "answers";
        fs::create_directories(kept, error);
        fs::path copy;
        for (int i = 1; copy.empty() || fs::exists(copy, ignored); ++i)
            copy = kept / (exercise.name + "_" + std::to_string(i) + ".cpp");
        if (fs::is_regular_file(file, ignored))
            fs::copy_file(file, copy, error);
        else  // a folder, a link that leads nowhere: out of the way
            fs::rename(file, copy, error);
        if (error) {
            fs::remove(copy, ignored);
            throw Stop(Status::bad_use, copy.string() + ": " + error.message() + "; nothing was reset");
        }
        std::printf("Your answer is kept in %s\n", shown(copy).c_str());
    }
    fs::create_directories(file.parent_path(), ignored);
    write_whole(file, stub);
}

/// A hint as a terminal shows it: without the marks that make formulas of it on a page.
std::string without_marks(std::string hint) {
    std::erase_if(hint, [](char c) { return c == '$' || c == '\\'; });
    return hint;
}

}  // namespace

void hint(const std::string& name) {
    const Exercise exercise = find_exercise(name);
    const int known = static_cast<int>(exercise.hints.size());
    change_progress([&](auto& progress) {
        int& shown_so_far = progress[exercise.name].hints;
        shown_so_far = std::min(std::min(shown_so_far, known) + 1, known);
        std::printf("%s\n", bold(exercise.place() + " " + exercise.name + ", " + exercise.title).c_str());
        for (int i = 0; i < shown_so_far; ++i)
            std::printf("\n  Hint %d of %d\n%s", i + 1, known,
                        wrapped(without_marks(exercise.hints[static_cast<std::size_t>(i)]), 6).c_str());
        if (shown_so_far == known)
            std::printf("\n  There are no more hints.%s\n",
                        exercise.has_solution() ? (" After a pass:  ./course solution " + exercise.name).c_str() : "");
        flush();  // a hint that nobody gets is not counted
    });
}

void solution(const std::string& name) {
    const Exercise exercise = find_exercise(name);
    if (is_kit() && !exercise.has_solution())
        throw Stop(Status::bad_use,
                   "this is the learner's edition: it has no solutions; what an exercise teaches is told "
                   "when your answer passes:  ./course check " +
                       exercise.name);
    if (!read_progress()[exercise.name].passed)
        throw Stop(Status::wrong,
                   "the solution is shown when your own answer has passed:  ./course check " + exercise.name);
    const auto yours = code_of(exercise.file()), ours = code_of(exercise.solution());  // a refusal comes alone
    std::printf("%s\n\n", bold(exercise.place() + " " + exercise.name + ", " + exercise.title).c_str());
    for (const auto& [whose, answer] : {std::pair{"Yours", yours}, {"The course's", ours}}) {
        std::printf("%s\n\n", whose);
        for (const auto& line : answer) std::printf("    %s\n", line.c_str());
        std::printf("\n");
    }
    std::printf("%s", wrapped(exercise.learned, 2).c_str());
}

void reset(const std::string& name, bool all) {
    if (name.empty() != all)
        throw Stop(Status::bad_use, "reset takes an EXERCISE, or --all for all of them (./course reset --help)");
    const std::vector<Exercise> exercises = all ? read_exercises() : std::vector{find_exercise(name)};
    if (std::any_of(exercises.begin(), exercises.end(), made_from_an_older_solution)) configure();
    int changed = 0, passes = 0;
    change_progress([&](auto& progress) {
        for (const Exercise& exercise : exercises) {
            if (!untouched(exercise)) ++changed;
            begin_again(exercise);
            passes += progress[exercise.name].passed;
            progress.erase(exercise.name);
        }
    });
    if (all)
        std::printf("The %zu files of exercises/ are as they were at the beginning; %d of them were not.\n",
                    exercises.size(), changed);
    else
        std::printf("%s is as it was at the beginning.\n", shown(exercises.front().file()).c_str());
    if (passes > 0)
        std::printf("%s no longer as passed, until an answer passes again.\n",
                    passes == 1 ? "One exercise counts" : (std::to_string(passes) + " exercises count").c_str());
}

}  // namespace course
