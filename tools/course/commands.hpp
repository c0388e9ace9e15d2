#pragma once
/// \file
/// What the course program can do, one function a command. Each throws Stop when it cannot.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace course {

/// The chapters and their exercises: for people, or as JSON for programs.
void list(bool json);

/// Builds everything, runs every chapter, makes the site, and closes with a table.
void tour();

/// Which tests: those that are over in minutes, all that CI runs, or all that there are, before a release.
enum class Tests { quick, all, of_release };

/// Builds and runs the tests. But for the quick ones, a skipped check counts as a failure.
void test(Tests which);

/// Runs a chapter's program and leaves what it writes and its picture in the folder `out` (none given: in the
/// build folder). With `study` all else that the chapter measures, too; `options` go to the study.
void run(const std::string& chapter, bool study, const std::optional<std::string>& out,
         const std::vector<std::string>& options);

/// Says which line wrote a number, check, data file or figure, what it is, and which pages use it: `03/energy_mean`,
/// or `energy_mean` for all that are called so. Throws Stop(bad_use) naming what is called nearly so.
void where(const std::string& name);

/// Checks answers: of one exercise (`file` instead of the learner's own, which is then not counted
/// as done), or of all that have been begun, in a chapter (`5`) or in the course. With `sanitize`, errors count that do
/// not show in the numbers. Throws Stop(wrong) where one is not right.
void check(const std::string& exercise, const std::optional<std::string>& file, bool json,
           const std::optional<std::uint64_t>& seed, bool sanitize);

/// What is asked of `grade`.
struct Grading {
    std::string place;                   ///< a submission, or a folder of them
    std::vector<std::string> exercises;  ///< none given: all that anybody has handed in
    std::optional<std::string> out;      ///< none given: NAME.grades where one is
    std::optional<std::uint64_t> seed;   ///< none given: drawn anew
    int jobs = 0;                        ///< at a time; 0: as many as there are cores
    bool one = false;                    ///< `place` is one submission, whatever it holds
    bool trust = false;                  ///< without isolation
    bool again = false;                  ///< also what has been graded
};

/// Grades submissions, each shut away from the machine and from the others. Throws Stop(wrong)
/// where one is not right.
void grade(const Grading& grading);

/// Checks an exercise (none given: the first that has not been passed) whenever its file is saved,
/// and goes on to the next after a pass.
void watch(const std::string& exercise);

/// Shows one hint more than the last time.
void hint(const std::string& exercise);

/// After a pass, the course's answer beside the learner's.
void solution(const std::string& exercise);

/// Makes the learner's file, or `all` of them, what it was at the beginning; the answer is kept.
void reset(const std::string& exercise, bool all);

/// Adds a chapter, or an exercise to a chapter: an example that builds, to be filled in. With `all` the chapter also
/// has a study, a panel and tests. Makes nothing if it cannot make all of it.
void new_chapter(const std::string& name, bool all);
void new_exercise(const std::string& chapter, const std::string& name);

/// What is asked of `bench`: which scenes, how hard to try, where the results go.
struct Contest {
    bool quick = false, json = false;
    std::optional<std::string> out;   ///< a folder; none given: in the build folder
    std::vector<std::string> scenes;  ///< none given: all
};

/// Every method in every scene, error against run time.
void bench(const Contest& contest);

/// What the library costs over a loop written by hand, and over Boost.odeint's.
void bench_loops();

/// What a spring and a body cost among many, in lanes and otherwise.
void bench_many();

/// Gyroscopic rules inside physics engines; of those only whose name begins with `engine`.
void bench_engines(const Contest& contest, const std::optional<std::string>& engine);

/// What is asked of `advise`: a spring or a spinning body, and a step. What was not given is empty.
struct Question {
    std::optional<double> omega, stiffness, mass, damping, zeta;  ///< rad/s, N/m, kg, N s/m, no unit
    std::optional<double> step, rate;                             ///< s, 1/s
    std::vector<double> inertia, spin;                            ///< kg m², rad/s
    std::optional<double> accuracy;  ///< percent; not given: nothing asked, and 1 in the table
    std::vector<double> frames;      ///< the shortest and the longest, s, where they differ

    // Of a body.
    std::optional<double> count;  ///< of bodies like this one; 1 where not given
    bool contacts = false;        ///< does it touch others?
    bool callback = false;        ///< and can it only be changed before the engine's step?

    // More kinds of springs than one.
    std::string kind = "spring";                                 ///< or chain, cloth, tether, hinge
    std::optional<double> springs, arm, turning;                 ///< how many, m, kg m²
    std::optional<double> other_mass, other_arm, other_turning;  ///< of a hinge's other body
    bool kicks = false, keep_size = false;                       ///< impulses; a fast oscillation that is to stay
};

/// What every method makes of it: will it blow up, what does it cost, how wrong is it?
void advise(const Question& question, bool json);

/// Writes the learner's edition of the course into `folder`, which is new or empty; with the solutions, which it shows
/// after a pass, if they are asked for.
void kit(const std::string& folder, bool with_solutions);

/// Brings the site up to date and says where it is; `open` shows it in the browser; `pdf` prints it as a book instead.
void site(bool open, bool pdf);

/// In a learner's edition: configures it, which says what does not fit this machine.
void setup_kit();

}  // namespace course
