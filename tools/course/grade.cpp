// course grade

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "build.hpp"
#include "commands.hpp"
#include "grades.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "sandbox.hpp"
#include "stop.hpp"
#include "submissions.hpp"
#include "verdict_text.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// What grades depend on apart from the answers: this program, which makes verdicts and words; the hidden tests; and
// what answers are compiled and linked with, apart from the precompiled headers, which are large.
std::string edition(const std::vector<Exercise>& exercises) {
    std::set<fs::path> parts{"/proc/self/exe", paths().build / "exercises/commands.json",
                             paths().source / "include/timestep/state.hpp",
                             paths().source / "include/timestep/real.hpp"};
    std::error_code ignored;
    for (const auto& header : fs::directory_iterator(paths().source / "tools/checker/learner", ignored))
        parts.insert(header.path());
    for (const auto& exercise : exercises) {
        for (const auto& part : parts_of_check(exercise))
            if (part.parent_path().filename() != "ready") parts.insert(part);
        parts.insert({exercise.about(), exercise.declared(), exercise.told()});
    }
    std::string all;
    for (const auto& part : parts) {
        std::ifstream stream(part, std::ios::binary);
        all += std::string(std::istreambuf_iterator<char>(stream), {});
    }
    return mark_of(all);
}

// The folder for the grades. It must not be inside the folder that is graded, which is the learners'.
fs::path desk_for(const Grading& grading) {
    std::error_code ignored;
    const fs::path place = fs::canonical(grading.place, ignored);
    const fs::path desk = grading.out ? fs::path(*grading.out) : fs::path(place.filename().string() + ".grades");
    if (desk.empty()) throw Stop(Status::bad_use, "--out '': must be the name of a folder");
    const fs::path way = fs::relative(fs::weakly_canonical(fs::absolute(desk, ignored), ignored), place, ignored);
    if (!way.empty() && *way.begin() != "..")
        throw Stop(Status::bad_use, in_one_line(desk.string()) +
                                        ": the grades would lie among the submissions; --out takes "
                                        "another folder");
    std::error_code error;
    fs::create_directories(desk, error);
    if (error || !fs::is_directory(desk))
        throw Stop(Status::bad_use,
                   in_one_line(desk.string()) + ": cannot be written" + (error ? " (" + error.message() + ")" : ""));
    if (Lock::is_held(desk / "lock"))
        throw Stop(Status::bad_use,
                   in_one_line(desk.string()) + ": another grading writes there; --out takes another folder");
    return desk;
}

std::vector<Exercise> asked_for(const Grading& grading) {
    if (grading.exercises.empty()) return read_exercises();
    std::vector<Exercise> exercises;
    for (const std::string& name : grading.exercises) {
        const Exercise exercise = find_exercise(name);
        if (std::none_of(exercises.begin(), exercises.end(),
                         [&](const Exercise& other) { return other.name == exercise.name; }))
            exercises.push_back(exercise);
    }
    return exercises;
}

// All answers, one row per submission.
struct Pile {
    std::vector<Exercise> exercises;
    std::vector<Submission> submissions;
    std::vector<HandedIn> answers = {};
    std::set<std::string> left_out = {};  // names of files that are no submission

    const Submission& submission(std::size_t i) const { return submissions[i / exercises.size()]; }
    const Exercise& exercise(std::size_t i) const { return exercises[i % exercises.size()]; }
};

// Leaves out the exercises that nobody has handed in, unless they were asked for.
Pile gather(const Grading& grading) {
    const std::vector<Exercise> exercises = asked_for(grading);
    const Submissions found = find_submissions(grading.place, exercises, grading.one);
    Pile pile{{}, found.all, {}, {found.left_out.begin(), found.left_out.end()}};
    std::vector<Answers> rows;
    for (const Submission& submission : pile.submissions) {
        rows.push_back(collect_answers(submission, exercises));
        pile.left_out.insert(rows.back().left_out.begin(), rows.back().left_out.end());
    }
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < exercises.size(); ++i)
        if (!grading.exercises.empty() || std::any_of(rows.begin(), rows.end(), [&](const Answers& row) {
                return !row.all[i].file.empty() && !row.all[i].whole;
            }))
            columns.push_back(i);
    for (const std::size_t i : columns) pile.exercises.push_back(exercises[i]);
    for (const Answers& row : rows)
        for (const std::size_t i : columns) pile.answers.push_back(row.all[i]);
    if (pile.exercises.empty() && !grading.one)
        throw Stop(Status::bad_use, in_one_line(grading.place) +
                                        ": holds no answer: no file has the name of an exercise, like "
                                        "velocity_now.cpp (--exercise says what other files answer)");
    return pile;
}

// Checks a copy: a submission is read only once.
Grade check_one(const Submission& submission, const Exercise& exercise, const std::string& answer, std::uint64_t seed,
                const Sandbox* sandbox, int patience) {
    Grade grade{submission.name, exercise.name, "course_error", "", seed, 0, true};
    try {
        const TemporaryFolder temporary;
        const fs::path copy = temporary.folder() / (exercise.name + ".cpp");
        write_whole(copy, answer);
        const Verdict verdict = check_file(exercise, copy, seed, {.sandbox = sandbox, .patience = patience});
        grade.verdict = verdict.kind;
        grade.says = told(exercise, verdict, copy);
        for (const std::string& place : {copy.string(), shown(copy)})
            replace_all(grade.says, place, exercise.name + ".cpp");
        grade.seconds = verdict.seconds;
        grade.in_time = verdict.in_time;
    } catch (const Stop& stop) {
        if (stop.status() == Status::interrupted) throw;
        grade.says = in_one_line(stop.what());
    } catch (const std::exception& error) {  // of one check; the others go on
        grade.says = in_one_line(error.what());
    }
    return grade;
}

void print(const Pile& pile, const std::vector<Grade>& grades) {
    const std::size_t width = pile.exercises.size();
    std::size_t longest = 10;
    for (const Submission& submission : pile.submissions) longest = std::max(longest, width_of(submission.name));
    for (std::size_t i = 0; i < grades.size(); ++i) {
        const std::string place = pile.exercise(i).place() + " " + pile.exercise(i).name;
        if (i % width == 0) {
            const auto begin = grades.begin() + static_cast<std::ptrdiff_t>(i);
            const auto end = begin + static_cast<std::ptrdiff_t>(width);
            const auto passed = std::count_if(begin, end, [](const Grade& grade) { return grade.passed(); });
            const auto missing =
                std::count_if(begin, end, [](const Grade& grade) { return grade.verdict == "missing"; });
            std::printf("%s  %td of %zu%s\n", padded(pile.submission(i).name, longest).c_str(), passed, width,
                        missing > 0 ? (", " + std::to_string(missing) + " missing").c_str() : "");
        }
        if (!pile.answers[i].beside.empty()) std::printf("    %s\n", pile.answers[i].beside.c_str());
        if (grades[i].verdict == "refused")
            std::printf("    %s\n", grades[i].says.c_str());
        else if (!grades[i].passed() && grades[i].verdict != "missing")
            std::printf("    %s %s\n", padded(place, 32).c_str(), grades[i].verdict.c_str());
    }
}

// Does `work` for each of these, in at most `most` threads, and passes the grades to `done`, one at a time, as they
// come.
void in_parallel(const std::vector<std::size_t>& which, std::size_t most, const std::function<Grade(std::size_t)>& work,
                 const std::function<void(std::size_t, const Grade&)>& done) {
    const TidyEnd tidy_end;
    std::atomic<std::size_t> next = 0;
    std::mutex one_at_a_time;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < which.size(); i = next++) {
                stop_if_interrupted();
                const Grade grade = work(which[i]);
                const std::lock_guard lock(one_at_a_time);
                done(which[i], grade);
            }
        } catch (...) {
            const std::lock_guard lock(one_at_a_time);
            failure = std::current_exception();
            next = which.size();
        }
    };
    std::vector<std::thread> threads;
    while (threads.size() < std::min(most, which.size())) threads.emplace_back(run);
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
}

std::vector<Grade> grade_all(const Pile& pile, const Grading& grading, Journal& journal, std::uint64_t seed,
                             const Sandbox* sandbox) {
    ProgressLine progress;
    std::vector<Grade> grades(pile.answers.size());
    std::vector<std::string> texts(grades.size());
    std::size_t taken_over = 0;
    std::vector<std::size_t> to_do, once_more;
    for (std::size_t i = 0; i < grades.size(); ++i) {
        const HandedIn& answer = pile.answers[i];
        const std::string& name = pile.exercise(i).name;
        grades[i] = {pile.submission(i).name, name, "missing", name + ": nothing was handed in", seed, 0, true};
        if (answer.file.empty()) continue;
        try {
            texts[i] = text_of(answer);
        } catch (const Stop& stop) {
            grades[i].verdict = "refused";
            grades[i].says = name + ": refused: " + stop.what();
            continue;
        }
        const Grade* const known = journal.find(grades[i].submission, name, texts[i]);
        const bool other_numbers = known != nullptr && grading.seed && known->seed != *grading.seed;
        if (known != nullptr && !grading.again && !other_numbers) {
            grades[i] = *known;
            ++taken_over;
        } else {
            to_do.push_back(i);
        }
    }
    if (taken_over > 0) progress.say("  " + std::to_string(taken_over) + " were graded before");

    std::size_t done = 0;
    const auto work = [&](int patience) {
        return [&, patience](std::size_t i) {
            return check_one(pile.submission(i), pile.exercise(i), texts[i], seed, sandbox, patience);
        };
    };
    const auto keep = [&](std::size_t i, const Grade& grade) {
        grades[i] = grade;
        journal.keep(grade, texts[i]);
    };
    const std::size_t jobs = grading.jobs > 0 ? static_cast<std::size_t>(grading.jobs)
                                              : std::max<std::size_t>(1, std::thread::hardware_concurrency());
    in_parallel(to_do, jobs, work(1), [&](std::size_t i, const Grade& grade) {
        if (!grade.in_time)
            once_more.push_back(i);  // its neighbours may have slowed it down, or the machine is slow
        else
            keep(i, grade);
        progress.now("[" + std::to_string(++done) + "/" + std::to_string(to_do.size()) + "] " + grade.submission + " " +
                     grade.exercise + ": " + grade.verdict);
    });
    if (!once_more.empty())
        progress.say("  " + std::to_string(once_more.size()) + (once_more.size() == 1 ? " was" : " were") +
                     " not done in time; once more, one at a time and with more of it");
    in_parallel(once_more, 1, work(3), keep);
    for (std::size_t i = 0; i < grades.size(); ++i)
        if (!pile.answers[i].beside.empty()) grades[i].says += "\n" + pile.answers[i].beside;
    return grades;
}

}  // namespace

void grade(const Grading& grading) {
    const Pile pile = gather(grading);
    const fs::path desk = desk_for(grading);
    const Lock one_at_a_time(desk / "lock");
    std::error_code ignored;
    fs::remove(desk / "results.json", ignored);  // if it is there at the end, it is of this run
    std::optional<Sandbox> sandbox;
    if (!grading.trust) sandbox.emplace();
    {
        ProgressLine progress;
        make_ready(pile.exercises, progress);
    }
    const fs::path journal_file = desk / "journal.jsonl";
    const std::string mark = edition(pile.exercises) + (grading.trust ? "_trusted" : "");
    // A new seed each time: the inputs of an earlier grading tell nothing about this one.
    const std::uint64_t seed = grading.seed ? *grading.seed : new_seed();
    Journal journal(journal_file, mark);
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Grade> grades = grade_all(pile, grading, journal, seed, sandbox ? &*sandbox : nullptr);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;

    const bool single = pile.submissions.size() == 1;
    write_grades(desk, pile.exercises, grades, single);
    if (!single) print(pile, grades);
    if (single)
        for (const Grade& grade : grades) std::printf("%s\n", grade.says.c_str());
    const auto passed = std::count_if(grades.begin(), grades.end(), [](const Grade& grade) { return grade.passed(); });
    std::string left_out;
    for (const std::string& name : pile.left_out) left_out += (left_out.empty() ? "" : ", ") + name;
    if (!left_out.empty()) std::printf("\nLeft out: %s\n", left_out.c_str());
    if (pile.exercises.empty()) std::printf("No file has the name of an exercise, like velocity_now.cpp.\n");
    std::printf(
        "\n%td of %zu right, %zu submission%s, in %.1f s, seed %llu%s; in %s:\n"
        "  grades.csv, grades.json, junit.xml%s\n",
        passed, grades.size(), pile.submissions.size(), single ? "" : "s", taken.count(),
        static_cast<unsigned long long>(seed), grading.trust ? ", without isolation" : "",
        in_one_line(shown(desk)).c_str(), single ? ", results.json" : "");
    flush();
    const bool failed =
        std::any_of(grades.begin(), grades.end(), [](const Grade& grade) { return grade.could_not_be_checked(); });
    if (failed)
        throw Stop(Status::missing,
                   "some could not be checked; the same command tries them again, three times in "
                   "all, and --again once more");
    if (static_cast<std::size_t>(passed) < grades.size() || grades.empty()) throw Stop(Status::wrong, "");
}

}  // namespace course
