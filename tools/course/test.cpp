// course test

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "build.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "places.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

// "100% tests passed, 0 tests failed out of 12" begins ctest's closing summary.
bool begins_summary(const std::string& line) {
    const auto end = line.find_first_not_of("0123456789");
    return end != std::string::npos &&
           std::string_view(line).substr(end).starts_with("% tests passed");
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

}  // namespace

void test(bool strict) {
    if (is_kit())
        throw Stop(Status::bad_use, "this is the learner's edition: it has no tests; ./course check "
                                    "checks your answers");
    ProgressLine progress;
    progress.say("Building everything that is tested:");
    build({"all", "docs", "kit_site"}, progress);

    // ctest's words pass through as they come; only its closing summary waits for what we have to
    // add about skipped checks, so that the summary comes last.
    std::string summary;
    Lines lines([&](const std::string& line) {
        if (!summary.empty() || begins_summary(line)) {
            summary += line + "\n";
        } else {
            std::printf("%s\n", line.c_str());
            std::fflush(stdout);
        }
    });
    const std::string jobs = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
    const int status = listen({places().ctest, "--test-dir", places().build.string(),
                               "--output-on-failure", "--no-tests=error", "--parallel", jobs},
                              std::ref(lines));

    const auto left_out = skipped(summary);
    if (!left_out.empty()) {
        std::printf("\nSkipped, because this machine lacks what they need:\n");
        for (const auto& name : left_out) std::printf("  %s\n", name.c_str());
        std::printf("To add it: ./course setup --all\n");
    }
    std::printf("\n%s", summary.c_str());
    flush();
    if (status != 0) throw Stop(Status::wrong, "");
    if (strict && !left_out.empty())
        throw Stop(Status::wrong,
                   std::to_string(left_out.size()) + " skipped, which --all counts as failed");
}

}  // namespace course
