#pragma once
/// \file
/// The commands of the course program, one function each. Each throws Stop if it fails.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stop.hpp"

namespace timestep {
struct Question;
}

namespace course {

/// Reads the command line and does what it asks. Throws Stop where it cannot.
Status obey(int argc, char** argv);

/// The chapters and their exercises: for people, or as JSON for programs.
void list(bool json);

/// Builds everything, runs every chapter, makes the site, and closes with a table.
void tour();

/// Which tests: the quick ones, all that CI runs, or all that run before a release.
enum class Tests { quick, all, of_release };

/// Builds and runs the tests. Unless only the quick ones run, a skipped test counts as a failure.
void test(Tests which);

/// Runs a chapter's program and leaves its data and its picture in the folder `out` (default: in the build folder).
/// With `study` it runs the study, too, with these `options`.
void run(const std::string& chapter, bool study, const std::optional<std::string>& out,
         const std::vector<std::string>& options);

/// Prints which line wrote a number, check, data file or figure, what it is, and which pages use it. The name is
/// `03/energy_mean`, or `energy_mean` for those of all runs. Throws Stop(bad_use) with the nearest name if there is
/// none.
void where(const std::string& name);

/// Checks answers: to one exercise (in `file`, which does not count as done, or in the learner's own), or to all that
/// have been begun, in a chapter (`5`) or in the course. With `sanitize`, errors count that do not show in the numbers.
/// Throws Stop(wrong) if one is not right.
void check(const std::string& exercise, const std::optional<std::string>& file, bool json,
           const std::optional<std::uint64_t>& seed, bool sanitize);

/// The options of `grade`.
struct Grading {
    std::string place;                   ///< a submission, or a folder of submissions
    std::vector<std::string> exercises;  ///< none: all that were handed in
    std::optional<std::string> out;      ///< default: NAME.grades beside `place`
    std::optional<std::uint64_t> seed;   ///< default: a random one
    int jobs = 0;                        ///< at the same time; 0: the number of cores
    bool one = false;                    ///< `place` is one submission, whatever is in it
    bool trust = false;                  ///< without isolation
    bool again = false;                  ///< also those that have been graded before
};

/// Grades submissions, each isolated from the machine and from the others. Throws Stop(wrong) if one is not right.
void grade(const Grading& grading);

/// Checks an exercise (default: the first that has not been passed) whenever its file is saved,
/// and goes on to the next after a pass.
void watch(const std::string& exercise);

/// Shows one more hint than the last time.
void hint(const std::string& exercise);

/// After a pass, shows the learner's answer and the course's.
void solution(const std::string& exercise);

/// Sets the learner's file, or `all` files, back to the beginning; the answer is kept beside.
void reset(const std::string& exercise, bool all);

/// Adds a chapter, or an exercise to a chapter: an example that builds, to be filled in. With `all` the chapter also
/// has a study, a panel and tests. Makes nothing if it cannot make all of it.
void new_chapter(const std::string& name, bool all);
void new_exercise(const std::string& chapter, const std::string& name);

/// The options of `bench`: which scenes, how thorough, where the results go.
struct Contest {
    bool quick = false;
    std::optional<std::string> out;   ///< a folder; default: in the build folder
    std::vector<std::string> scenes;  ///< none: all
};

/// Every method in every scene, error against run time.
void bench(const Contest& contest);

/// What the library costs over a loop written by hand, and over Boost.odeint's.
void bench_loops();

/// What a spring and a body cost among many, in SIMD lanes and without.
void bench_many();

/// Gyroscopic rules inside physics engines: those whose name begins with `engine`, or all.
void bench_engines(const Contest& contest, const std::optional<std::string>& engine);

/// Prints for every method: will it blow up, what does it cost, how large is its error?
void advise(const timestep::Question& question, bool json);

/// Writes the learner's edition of the course into `folder`, which is new or empty; `with_solutions` packs the
/// solutions.
void kit(const std::string& folder, bool with_solutions);

/// Brings the site up to date and prints its address; `open` opens it in the browser; `pdf` prints it as a book
/// instead.
void site(bool open, bool pdf);

/// Configures a learner's edition, which says what does not fit this machine.
void setup_kit();

}  // namespace course
