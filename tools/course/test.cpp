// course test

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "build.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

// "12/20 Test #12: the pages open in a browser ....***Skipped" is how ctest says that a test was skipped.
bool is_skipped(const std::string& line) { return line.find("***Skipped") != std::string::npos; }

}  // namespace

void test(Tests which) {
    const bool strict = which != Tests::quick;
    if (is_kit())
        throw Stop(Status::bad_use,
                   "this is the learner's edition: it has no tests; ./course check "
                   "checks your answers");
    ProgressLine progress;
    progress.say("Building everything that is tested:");
    if (strict)
        build({"all", "docs", "kit"}, progress);
    else
        build({"quick_tests", "docs"}, progress);

    int skipped = 0;
    Lines lines([&](const std::string& line) {
        skipped += is_skipped(line);
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    });
    // One more than there are processors: some tests only wait.
    const std::string jobs = std::to_string(1 + std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::string> command{
        paths().ctest, "--test-dir", paths().build.string(), "--output-on-failure", "--no-tests=error",
        "--parallel",  jobs};
    if (which == Tests::quick) command.insert(command.end(), {"--label-exclude", "long|release"});
    if (which == Tests::all) command.insert(command.end(), {"--label-exclude", "release"});
    const int status = listen(command, std::ref(lines));

    if (skipped > 0)
        std::printf("\nSkipped: %d, because this machine lacks what they need; ./course setup --all installs it\n",
                    skipped);
    if (which == Tests::quick) std::printf("\n./course test --all runs the tests that take longer, too\n");
    flush();
    if (status != 0) throw Stop(Status::wrong, "");
    if (strict && skipped > 0)
        throw Stop(Status::wrong, std::to_string(skipped) + " skipped, which " +
                                      (which == Tests::all ? "--all" : "--release") + " counts as failed");
}

}  // namespace course
