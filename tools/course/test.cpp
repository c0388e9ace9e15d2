// course test

#include <algorithm>
#include <cstdio>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "build.hpp"
#include "commands.hpp"
#include "places.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

// "\t  5 - the pages open in a browser (Skipped)" in ctest's closing summary.
std::vector<std::string> skipped(const std::string& summary) {
    const std::regex entry(R"(\n\s+\d+ - ([^\n]*) \(Skipped\))");
    std::vector<std::string> names;
    for (std::sregex_iterator it(summary.begin(), summary.end(), entry), end; it != end; ++it)
        names.push_back((*it)[1]);
    return names;
}

}  // namespace

void test(bool strict) {
    Progress progress;
    progress.say("Building everything that is tested:");
    build({"all", "docs"}, progress);

    // ctest's words pass through as they come; only its closing summary waits for what we have to
    // add about skipped checks, so that the summary comes last.
    const std::regex summary_begins("[0-9]+% tests passed.*");
    std::string summary;
    Lines lines([&](const std::string& line) {
        if (!summary.empty() || std::regex_match(line, summary_begins)) {
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
    std::fflush(stdout);
    if (status != 0) throw Stop(Status::wrong, "");
    if (strict && !left_out.empty())
        throw Stop(Status::wrong,
                   std::to_string(left_out.size()) + " skipped, which --all counts as failed");
}

}  // namespace course
