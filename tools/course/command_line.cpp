#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "question.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

struct Asked {
    std::string engine;  // of bench engines
    bool yes = false, all = false, study = false, json = false, open = false, pdf = false, sanitize = false;
    bool with_solutions = false, release = false;
    std::string chapter, exercise, kit, name;
    std::string seed, file, out;  // an empty word is a value, too; see `given`
    std::vector<std::string> chapter_options;
    timestep::Question question;
    Contest contest;
    Grading grading;
};

// Further options of `advise` for springs.
template <class Number>
void declare_springs(CLI::App& advise, timestep::Question& question, const Number& number) {
    advise.add_option("--kind", question.kind, "spring, chain, cloth, tether (it only pulls) or hinge")
        ->type_name("NAME");
    number("--springs", question.springs, "N",
           "number of springs on the body, or at each point of a chain (default 2) or a cloth (default 4)");
    number("--arm", question.arm, "M", "from its centre of mass to where they take hold, with --turning");
    number("--turning", question.turning, "KG*M^2", "the body's least moment of inertia");
    number("--other-mass", question.other_mass, "KG", "a hinge's other body; none given: like the first");
    number("--other-arm", question.other_arm, "M", "its arm");
    number("--other-turning", question.other_turning, "KG*M^2", "its least moment of inertia");
    advise.add_flag("--kicks", question.kicks, "impulses come between the steps");
    advise.add_flag("--keep-size", question.keep_size, "an oscillation faster than the frame must not die");
}

void declare_advise(CLI::App& app, Asked& asked) {
    const auto advise = app.add_subcommand("advise", "will it blow up? Every method on your numbers");
    timestep::Question& question = asked.question;
    const auto number = [&](const char* flag, auto& value, const char* unit, const char* words) {
        advise->add_option(flag, value, words)->type_name(unit)->check([](const std::string& word) {
            return word.empty() ? "'' is no number" : "";  // CLI11 takes it for a missing word
        });
    };
    number("--omega", question.omega, "RAD/S", "angular frequency of a spring, or:");
    number("--stiffness", question.stiffness, "N/M", "its stiffness, with --mass");
    number("--mass", question.mass, "KG", "the mass on it");
    number("--zeta", question.zeta, "RATIO", "damping ratio; none given: no damper; or:");
    number("--damping", question.damping, "N*S/M",
           "the damper, with --stiffness and --mass; with --mass only: a damper alone");
    const auto three = [&](const char* flag, auto& value, const char* unit, const char* words) {
        advise->add_option(flag, value, words)->type_name(unit)->delimiter(',')->expected(3);
    };
    three("--inertia", question.inertia, "A,B,C", "a spinning body's three moments, kg m², with --spin");
    three("--spin", question.spin, "X,Y,Z", "its angular velocity, rad/s");
    number("--step", question.step, "S", "the time step, or:");
    number("--rate", question.rate, "HZ", "steps per second; neither given: 60");
    advise->add_option("--frames", question.frames, "or frames of uneven length: the shortest and the longest, s")
        ->type_name("SHORTEST,LONGEST")
        ->delimiter(',')
        ->expected(2);
    number("--accuracy", question.accuracy, "PERCENT",
           "recommend the cheapest method with at most this error in the first period; without it the list decides, "
           "and the table uses 1");
    declare_springs(*advise, question, number);
    // For a body.
    number("--count", question.count, "NUMBER", "so many bodies like this one (1)");
    advise->add_flag("--contacts", question.contacts, "it touches others");
    advise->add_flag("--callback", question.callback, "all you can change is its spin, before the engine's step");
    advise->add_flag("--json", asked.json, "as JSON, for programs");
}

void declare_bench(CLI::App& app, Asked& asked) {
    const auto bench =
        app.add_subcommand("bench", "error against run time (work–precision diagrams), every method in every scene");
    Contest& contest = asked.contest;
    bench->add_flag("--quick", contest.quick, "a minute in all");
    bench->add_option("--scene", contest.scenes, "only this scene; repeatable")
        ->type_name("NAME")
        ->allow_extra_args(false);
    bench->add_option("--out", asked.out, "leave results (CSV) and figures in this folder")->type_name("DIR");
    bench->require_subcommand(0, 1);
    const auto table = [&](const char* name, const char* words) {
        return bench->add_subcommand(name, words)->footer("");  // the footer of bench itself is for bench alone
    };
    table("loops", "the library beside loops written by hand");
    table("many", "springs and bodies by the thousand, beside plain loops, Boost.odeint and Bullet");
    const auto engines =
        table("engines", "gyroscopic rules inside Bullet, ODE, Box3D and Jolt, before and after: two minutes");
    engines->add_flag("--quick", contest.quick, "fewer throws and shorter flights: half a minute");
    engines->add_option("--scene", contest.scenes, "only alone, top, throws, piles or cost; repeatable")
        ->type_name("NAME")
        ->allow_extra_args(false);
    engines->add_option("--engine", asked.engine, "engines only whose name begins so")->type_name("NAME");
    engines->add_option("--out", asked.out, "leave the numbers (TSV) in this folder")->type_name("DIR");
}

void declare_grade(CLI::App& app, Asked& asked) {
    const auto grade = app.add_subcommand("grade", "grade a submission, or a folder of them, in isolation");
    Grading& grading = asked.grading;
    grade->add_option("DIR", grading.place, "a submission, or a folder with one in each entry")->required();
    grade->add_option("--exercise", grading.exercises, "grade only this exercise; repeatable")
        ->type_name("NAME")
        ->allow_extra_args(false);
    grade->add_option("--out", asked.out, "leave the grades in this folder (NAME.grades)")->type_name("DIR");
    grade->add_option("--seed", asked.seed, "draw the inputs from this seed")->type_name("NUMBER");
    grade->add_option("--jobs", grading.jobs, "submissions at the same time (default: the number of cores)")
        ->check(CLI::Range(1, 256));
    grade->add_flag("--one", grading.one, "DIR is one submission, whatever is in it");
    grade->add_flag("--trust", grading.trust, "without isolation: only for files that you would run yourself");
    grade->add_flag("--again", grading.again, "also submissions that have been graded before");
    grade->footer(
        "A submission is a folder that holds exercises/CHAPTER/NAME.cpp or NAME.cpp, or a single file.\n"
        "A run that was stopped goes on where it was. Exit status 1: graded, and not all is right.");
}

void declare_new(CLI::App& app, Asked& asked) {
    const auto make =
        app.add_subcommand("new", "add a chapter or an exercise to the course: a small example, to fill in");
    make->require_subcommand(1);
    const auto chapter = make->add_subcommand("chapter", "page, program and picture");
    chapter->add_flag("--all", asked.all, "and what is optional: a study, a panel and tests");
    chapter->add_option("NAME", asked.name, "small letters, digits and _")->required();
    const auto exercise = make->add_subcommand("exercise", "task, answer and hidden tests");
    exercise->add_option("CHAPTER", asked.chapter, "number or name, as ./course list shows them")->required();
    exercise->add_option("NAME", asked.name, "of the function: small letters, digits and _")->required();
}

void declare(CLI::App& app, Asked& asked) {
    app.require_subcommand(1);
    app.fallthrough();
    app.add_flag("-y,--yes", asked.yes, "do not ask before installing what is missing");

    app.add_subcommand("tour", "build everything, run every chapter, make the site");
    const auto test = app.add_subcommand("test", "build everything and run the tests");
    test->add_flag(
        "--all", asked.all,
        "also tests that take longer; installs all optional packages first; a skipped test counts as failed");
    test->add_flag("--release", asked.release, "like --all, and also other platforms and long tests, for a release");
    app.add_subcommand("list", "the chapters and the exercises")
        ->add_flag("--json", asked.json, "as JSON, for programs");
    const auto run = app.add_subcommand("run", "run a chapter's program, and draw its picture");
    run->add_option("CHAPTER", asked.chapter, "number or name, as ./course list shows them")->required();
    run->add_flag("--study", asked.study, "also run the study, which measures the page's numbers and figures");
    run->add_option("--out", asked.out, "leave data, numbers and figures in this folder")->type_name("DIR");
    run->footer(
        "The words after -- go to the chapter's study. Its options:\n"
        "  ./course run 3 --study -- --help");
    app.add_subcommand("where", "the line that wrote a number, check, data file or figure of a page")
        ->add_option("NAME", asked.name, "as in the page's source, with its chapter: 03/energy_mean")
        ->required();
    const auto with_exercise = [&](const char* name, const char* words,
                                   const char* which = "name, number (1.1) or file of the exercise") {
        const auto command = app.add_subcommand(name, words);
        const auto option = command->add_option("EXERCISE", asked.exercise, which);
        option->check(
            [](const std::string& word) { return word.empty() ? "'' is no exercise; ./course list shows them" : ""; });
        return std::pair(command, option);
    };
    const auto check =
        with_exercise("check", "check your answer to an exercise, or to all begun, of a chapter or of the course",
                      "name, number (1.1) or file of the exercise; or of a chapter: number (1) or name")
            .first;
    check->add_option("--file", asked.file, "check this file instead of yours; a pass does not count")
        ->type_name("FILE");
    check->add_option("--seed", asked.seed, "draw the same inputs as the check that named this seed")
        ->type_name("NUMBER");
    check->add_flag("--sanitize", asked.sanitize, "also find memory errors and undefined behaviour");
    check->add_flag("--json", asked.json, "as JSON, for programs");
    with_exercise("watch", "check again whenever you save, and go on after a pass");
    with_exercise("hint", "the next hint to an exercise").second->required();
    with_exercise("solution", "your answer and the course's, after a pass").second->required();
    with_exercise("reset", "make your file what it was at the beginning")
        .first->add_flag("--all", asked.all, "all files of exercises/; what you have written is kept");
    declare_new(app, asked);
    declare_grade(app, asked);
    declare_bench(app, asked);
    // The front door of a learner's edition calls this after it has installed what is missing.
    app.add_subcommand("setup", "")->group("")->add_flag("--all", asked.all, "");
    declare_advise(app, asked);
    const auto kit = app.add_subcommand("kit", "write the learner's edition: no tests, no solutions");
    kit->add_option("DIR", asked.kit, "a new or empty folder")->required();
    kit->add_flag("--with-solutions", asked.with_solutions,
                  "with them, as text; ./course solution shows one after a pass");
    const auto site = app.add_subcommand("site", "bring the site up to date and say where it is");
    const auto open = site->add_flag("--open", asked.open, "open it in the browser");
    site->add_flag("--pdf", asked.pdf, "print all of it as a book: build/site/timestep.pdf")->excludes(open);
}

// The word after an option, '' included, which CLI11's own optional takes for none.
std::optional<std::string> given(const CLI::App& app, const char* option, const std::string& word) {
    return app.get_option(option)->count() > 0 ? std::optional(word) : std::nullopt;
}

std::optional<std::uint64_t> seed_from(const std::optional<std::string>& given) {
    if (!given) return {};
    const std::string& word = *given;
    std::uint64_t seed = 0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, seed);
    if (read.ec != std::errc() || read.ptr != end)
        throw Stop(Status::bad_use, "--seed '" + word + "': must be a whole number from 0 to 2^64 - 1");
    return seed;
}

// CLI11's first line, and where there is more; for a study's option without -- before it, what to type instead.
std::string refusal(const CLI::ParseError& error, const CLI::App& app, const std::string& chapter) {
    const std::vector<std::string> words = app.remaining(true);
    if (app.got_subcommand("run") && !chapter.empty() && !words.empty() && words.front().starts_with("--")) {
        std::string line = "./course run " + chapter + " --study --";
        for (const auto& word : words) line += " " + word;
        return "run has no option " + words.front() + "; those of the chapter's study go after --: " + line;
    }
    std::string command = "./course";
    for (auto named = app.get_subcommands(); !named.empty(); named = named.front()->get_subcommands())
        command += " " + named.front()->get_name();
    const std::string said = error.what();
    return said.substr(0, said.find('\n')) + " (" + command + " --help)";
}

void bench_or_table(const CLI::App& bench, Asked& asked) {
    const auto others = bench.get_subcommands();
    if (others.empty()) {
        asked.contest.out = given(bench, "--out", asked.out);
        course::bench(asked.contest);
        return;
    }
    const std::string name = others.front()->get_name();
    for (const char* option : {"--quick", "--scene", "--out"})
        if (bench.get_option(option)->count() > 0)
            throw Stop(Status::bad_use,
                       std::string(option) + ": bench " + name + " does not take it (./course bench --help)");
    if (name == "loops") bench_loops();
    if (name == "many") bench_many();
    if (name == "engines") {
        asked.contest.out = given(*others.front(), "--out", asked.out);
        bench_engines(asked.contest, given(*others.front(), "--engine", asked.engine));
    }
}

}  // namespace

Status obey(int argc, char** argv) {
    // The words after -- are for the chapter's study.
    const auto end = std::find(argv + 1, argv + argc, std::string("--"));
    Asked asked;
    if (end != argv + argc) asked.chapter_options.assign(end + 1, argv + argc);

    CLI::App app("Timestep: numerical methods for game physics, by building them.", "./course");
    declare(app, asked);
    try {
        app.parse(static_cast<int>(end - argv), argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw Stop(Status::bad_use, refusal(error, app, asked.chapter));
        app.exit(error);  // --help
        return Status::fine;
    }

    if (!app.got_subcommand("run") && !asked.chapter_options.empty())
        throw Stop(Status::bad_use, "only run takes options for a chapter's program after --");
    if (app.got_subcommand("tour")) tour();
    if (app.got_subcommand("test")) test(asked.release ? Tests::of_release : asked.all ? Tests::all : Tests::quick);
    if (app.got_subcommand("list")) list(asked.json);
    if (app.got_subcommand("where")) where(asked.name);
    if (const auto command = app.get_subcommand("run"); *command)
        run(asked.chapter, asked.study, given(*command, "--out", asked.out), asked.chapter_options);
    if (const auto command = app.get_subcommand("check"); *command)
        check(asked.exercise, given(*command, "--file", asked.file), asked.json,
              seed_from(given(*command, "--seed", asked.seed)), asked.sanitize);
    if (const auto command = app.get_subcommand("grade"); *command) {
        asked.grading.out = given(*command, "--out", asked.out);
        asked.grading.seed = seed_from(given(*command, "--seed", asked.seed));
        grade(asked.grading);
    }
    if (app.got_subcommand("watch")) watch(asked.exercise);
    if (app.got_subcommand("hint")) hint(asked.exercise);
    if (app.got_subcommand("solution")) solution(asked.exercise);
    if (app.got_subcommand("reset")) reset(asked.exercise, asked.all);
    if (const auto command = app.get_subcommand("new"); *command) {
        if (command->got_subcommand("chapter")) new_chapter(asked.name, asked.all);
        if (command->got_subcommand("exercise")) new_exercise(asked.chapter, asked.name);
    }
    if (const auto command = app.get_subcommand("bench"); *command) bench_or_table(*command, asked);
    if (app.got_subcommand("advise")) advise(asked.question, asked.json);
    if (app.got_subcommand("setup")) setup_kit();
    if (app.got_subcommand("kit")) kit(asked.kit, asked.with_solutions);
    if (app.got_subcommand("site")) site(asked.open, asked.pdf);
    flush();
    return Status::fine;
}

}  // namespace course
