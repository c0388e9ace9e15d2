// Chapter 7: which method reaches the accuracy that I need in the least time?

#include <cmath>

#include "sections.hpp"

int main(int argc, char** argv) {
    long rounds = contest::page.rounds, longest = std::lround(contest::page.longest_run * 1e6);
    lab::Program program("error_against_run_time", "every method in every scene: what does accuracy cost?");
    program.option("--rounds", rounds, 1, 25, "how often every run is timed");
    program.option("--longest", longest, 100, 4000, "a run that takes longer gets no shorter steps, µs");
    return program.run(argc, argv, [&](lab::Findings& out) {
        contest::Effort effort = contest::page;
        effort.rounds = int(rounds);
        effort.longest_run = double(longest) * 1e-6;
        claims(diagrams(effort, out), out);
        fooled(out);
        sleeping(out);
    });
}
