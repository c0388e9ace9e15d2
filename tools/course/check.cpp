// course check, course watch

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "build.hpp"
#include "chapters.hpp"
#include "commands.hpp"
#include "progress.hpp"
#include "stop.hpp"
#include "verdict_text.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

std::uint64_t seed_or_new(const std::optional<std::uint64_t>& seed) { return seed ? *seed : new_seed(); }

void bring_up_to_date(const std::vector<Exercise>& exercises) {
    ProgressLine progress;
    make_ready(exercises, progress);
}

// The first exercise after this one, round the course, that is still to be done.
std::optional<Exercise> next_after(const Exercise& exercise) {
    const auto progress = read_progress();
    const auto all = read_exercises();
    std::size_t at = 0;
    while (at < all.size() && all[at].name != exercise.name) ++at;
    for (std::size_t i = 1; i < all.size(); ++i) {
        const Exercise& candidate = all[(at + i) % all.size()];
        if (state_of(candidate, progress) != "passed") return candidate;
    }
    return {};
}

void remember_pass(const Exercise& exercise) {
    if (!read_progress()[exercise.name].passed)
        change_progress([&](auto& progress) { progress[exercise.name].passed = true; });
}

std::string told_and_marked(const Exercise& exercise, const Verdict& verdict, const fs::path& file) {
    return told(exercise, verdict, file) + marked(exercise, verdict, file);
}

// What to do next, below a verdict.
std::string way_on(const Exercise& exercise, const Verdict& verdict) {
    if (verdict.kind == "pass") {
        std::string text = "\n";
        if (exercise.has_solution())
            text += "  Your answer and the course's:  ./course solution " + exercise.name + "\n";
        const auto next = next_after(exercise);
        if (next)
            return text + "  Next:  " + next->place() + " " + next->title + "\n         " + shown(next->file()) + "\n";
        return text + "  That was the last one: you have passed them all.\n";
    }
    std::string text;
    if (verdict.kind != "not_started" && verdict.kind != "does_not_compile")
        text += "\n  The same numbers again:  ./course check " + exercise.name + " --seed " +
                std::to_string(verdict.seed) + "\n";
    return text + (text.empty() ? "\n" : "") + "  A hint, one step at a time:  ./course hint " + exercise.name + "\n";
}

// Every exercise that has been begun, of all or of one chapter, in one line each, and the first that is not right in
// full.
void check_all(const std::optional<Chapter>& chapter, bool json, const std::optional<std::uint64_t>& seed) {
    std::vector<Exercise> all = read_exercises();
    const std::string of_chapter = chapter ? " of chapter " + std::to_string(chapter->number()) : "";
    if (chapter) {
        std::erase_if(all, [&](const Exercise& exercise) { return exercise.chapter != chapter->folder; });
        if (all.empty())
            throw Stop(Status::bad_use, of_chapter.substr(4) + " has no exercises; ./course list shows them");
    }
    const auto progress = read_progress();
    std::string first_wrong, list;
    int checked = 0;
    bool course_error = false;
    std::vector<Exercise> begun;
    for (const auto& exercise : all)
        if (state_of(exercise, progress) != "not started") begun.push_back(exercise);
    if (!begun.empty()) bring_up_to_date(begun);
    for (const auto& exercise : begun) {
        const Verdict verdict = check_file(exercise, exercise.file(), seed_or_new(seed));
        list += (checked++ > 0 ? ",\n " : "") + as_json(exercise, verdict);
        course_error = course_error || verdict.kind == "course_error";
        if (verdict.kind == "pass")
            remember_pass(exercise);
        else if (first_wrong.empty())
            first_wrong = told_and_marked(exercise, verdict, exercise.file()) + way_on(exercise, verdict);
        if (!json)
            std::printf("%s %s\n", padded(exercise.place() + " " + exercise.name, 34).c_str(),
                        verdict.kind == "pass" ? "✓" : ("✗ " + headline(verdict.kind)).c_str());
    }
    if (json)
        std::printf("[%s]\n", list.c_str());
    else if (checked == 0)
        std::printf("No exercise%s has been begun. ./course list shows them; the first is\n  %s\n", of_chapter.c_str(),
                    shown(all.front().file()).c_str());
    else
        std::printf("\n%s", first_wrong.c_str());
    flush();
    if (!first_wrong.empty() || checked == 0) throw Stop(course_error ? Status::missing : Status::wrong, "");
}

}  // namespace

void check(const std::string& name, const std::optional<std::string>& file, bool json,
           const std::optional<std::uint64_t>& seed, bool sanitize) {
    const TellWaits told_what_is_waited_for;
    const auto one = name.empty() ? std::nullopt : exercise_of(name);
    const auto chapter = name.empty() || one ? std::nullopt : chapter_of(name);
    if (name.empty() || chapter) {
        if (file) throw Stop(Status::bad_use, "check --file needs the exercise that the file answers");
        if (sanitize) throw Stop(Status::bad_use, "check --sanitize needs the exercise to check");
        return check_all(chapter, json, seed);
    }
    if (!one && name.find_first_not_of("0123456789") == std::string::npos)
        throw Stop(Status::bad_use,
                   "'" + shortened(name, 100) + "' is no chapter and no exercise; ./course list shows them");
    const Exercise exercise = one ? *one : find_exercise(name);
    if (file && file->empty()) throw Stop(Status::bad_use, "--file '': must be the name of a file");
    const fs::path answer = file ? fs::path(*file) : exercise.file();
    answer_in(exercise, answer);  // or one clear line, before anything is built
    bring_up_to_date({exercise});
    Verdict verdict = sanitize ? check_sanitized(exercise, answer, seed_or_new(seed))
                               : check_file(exercise, answer, seed_or_new(seed));
    verdict.watched = sanitize;
    if (verdict.kind == "pass" && !file) remember_pass(exercise);
    if (json)
        std::printf("%s\n", as_json(exercise, verdict).c_str());
    else
        std::printf("%s%s", told_and_marked(exercise, verdict, answer).c_str(),
                    file && verdict.kind == "pass" ? "" : way_on(exercise, verdict).c_str());
    flush();
    if (verdict.kind != "pass") throw Stop(verdict.kind == "course_error" ? Status::missing : Status::wrong, "");
}

// Begins with the exercise, or the first that has not passed; whichever is saved is checked. Looks at the files ten
// times a second, which every system and every editor's way of saving can bear.
void watch(const std::string& name) {
    const TellWaits told_what_is_waited_for;
    std::optional<Exercise> exercise;
    const auto all = read_exercises();
    const auto progress = read_progress();
    if (!name.empty())
        exercise = find_exercise(name);
    else
        for (const auto& candidate : all)
            if (!exercise && state_of(candidate, progress) != "passed") exercise = candidate;
    if (!exercise) {
        std::printf("There is nothing left to watch: you have passed them all.\n");
        return;
    }
    const auto saved = [&] {
        std::vector<fs::file_time_type> times;
        std::error_code error;
        for (const auto& watched : all) times.push_back(fs::last_write_time(watched.file(), error));
        return times;
    };
    while (exercise) {
        bring_up_to_date({*exercise});
        const auto seen = saved();  // before the check: what is saved during it counts
        if (on_terminal()) std::printf("\033[2J\033[H");
        try {
            const Verdict verdict = check_file(*exercise, exercise->file(), new_seed());
            std::printf("%s%s", told_and_marked(*exercise, verdict, exercise->file()).c_str(),
                        way_on(*exercise, verdict).c_str());
            if (verdict.kind == "pass") {
                remember_pass(*exercise);
                exercise = next_after(*exercise);
                if (exercise) std::printf("\nWatching %s now; Ctrl-C ends.\n", shown(exercise->file()).c_str());
            } else {
                std::printf("\nWatching %s; it, or another, is checked whenever you save it; Ctrl-C ends.\n",
                            shown(exercise->file()).c_str());
            }
        } catch (const Stop& stop) {  // a file that is just being saved, or is not there
            if (stop.status() == Status::interrupted) throw;
            std::printf("%s\n", stop.what());
        }
        flush();
        while (exercise) {
            const auto now = saved();
            const auto changed = std::mismatch(now.begin(), now.end(), seen.begin()).first;
            if (changed != now.end()) {
                exercise = all[static_cast<std::size_t>(changed - now.begin())];
                break;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }
}

}  // namespace course
