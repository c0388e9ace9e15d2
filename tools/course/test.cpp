// course test

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
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

// "100% tests passed, 0 tests failed out of 12" begins ctest's closing summary.
bool begins_summary(const std::string& line) {
    const auto end = line.find_first_not_of("0123456789");
    return end != std::string::npos && std::string_view(line).substr(end).starts_with("% tests passed");
}

// "\t  5 - the pages open in a browser (Skipped)" stands in the summary for a test that was
// skipped.
std::vector<std::string> skipped(const std::string& summary) {
    const std::string mark = " (Skipped)";
    std::vector<std::string> names;
    std::istringstream lines(summary);
    for (std::string line; std::getline(lines, line);) {
        const auto name = line.find(" - ");
        if (name != std::string::npos && line.ends_with(mark))
            names.push_back(line.substr(name + 3, line.size() - name - 3 - mark.size()));
    }
    return names;
}

// Prints which tests are left to another `command`. ctest lists them: "  Test #3: headers stand alone".
void print_left_out(const char* label, const char* command) {
    std::string list;
    listen({paths().ctest, "--test-dir", paths().build.string(), "-N", "-L", label},
           [&](std::string_view text) { list += text; });
    std::vector<std::string> names;
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        const auto number = line.find("Test"), name = line.find(": ");
        if (number != std::string::npos && line.find('#') != std::string::npos && name != std::string::npos)
            names.push_back(line.substr(name + 2));
    }
    if (names.empty()) return;
    std::printf("\n%s also runs %zu tests that take longer, among them\n", command, names.size());
    // One of each kind: the first word of its name is the kind.
    std::set<std::string> kinds;
    for (const auto& name : names) {
        const std::string words = name.substr(0, name.find_first_of(":("));
        const std::string kind = words.substr(0, words.find(' '));
        if (kinds.insert(kind).second) std::printf("  %s\n", name.c_str());
    }
}

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

    // ctest's output passes through at once. Its closing summary waits, so that it comes after our list of skipped
    // tests.
    std::string summary;
    Lines lines([&](const std::string& line) {
        if (!summary.empty() || begins_summary(line)) {
            summary += line + "\n";
        } else {
            std::printf("%s\n", line.c_str());
            std::fflush(stdout);
        }
    });
    // One more than there are processors: some tests only wait.
    const std::string jobs = std::to_string(1 + std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::string> command{
        paths().ctest, "--test-dir", paths().build.string(), "--output-on-failure", "--no-tests=error",
        "--parallel",  jobs};
    if (which == Tests::quick) command.insert(command.end(), {"--label-exclude", "long|release"});
    if (which == Tests::all) command.insert(command.end(), {"--label-exclude", "release"});
    const int status = listen(command, std::ref(lines));

    const auto left_out = skipped(summary);
    if (!left_out.empty()) {
        std::printf("\nSkipped, because this machine lacks what they need:\n");
        for (const auto& name : left_out) std::printf("  %s\n", name.c_str());
        std::printf("This command installs what they need: ./course setup --all\n");
    }
    if (which == Tests::quick) print_left_out("long", "./course test --all");
    if (which != Tests::of_release) print_left_out("release", "./course test --release");
    std::printf("\n%s", summary.c_str());
    flush();
    if (status != 0) throw Stop(Status::wrong, "");
    if (strict && !left_out.empty())
        throw Stop(Status::wrong, std::to_string(left_out.size()) + " skipped, which " +
                                      (which == Tests::all ? "--all" : "--release") + " counts as failed");
}

}  // namespace course
