// What `./course advise` says of spinning bodies, and how often it is right.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "body_questions.hpp"
#include "sections.hpp"

using namespace timestep;

void advice_bodies(const Settings&, lab::Findings& out) {
    out.section("Advice on bodies");
    const questions::Tally said = questions::verdicts(2'000, 1);
    for (const auto& line : said.missed) std::printf("  missed: %s\n", line.c_str());
    std::printf("  never %ld, bounded %ld, one step can %ld, too close to call %ld: %ld wrong\n", said.never,
                said.bounded, said.can, said.close, said.wrong);
    const double decided = double(said.asked - said.close);
    out.number("body_questions", double(said.asked), "", "random questions about a spinning body");
    out.check("body_advice_right",
              double(said.wrong) <= 0.001 * decided && double(said.close) <= 0.03 * double(said.asked),
              "whether a solver can add energy to a spinning body: at least 99.9 % of the verdicts are "
              "right, and at "
              "most 3 % of the questions too close to call");

    // What to take, for throws in free flight up to ten radians a frame, half of them near the
    // middle axis.
    const double fastest = 10;
    auto& table =
        out.table("advice_bodies.tsv", {"line", "questions", "off by 1 %", "lost", "worst, %", "another was nearer"});
    double worst = 0;
    long asked = 0, beaten = 0, wrong = 0;
    for (const auto& line : questions::recommended(300, 7, fastest)) {
        table.row({line.name, double(line.asked), double(line.wrong), double(line.lost), 100 * line.worst,
                   double(line.beaten)});
        std::printf(
            "  %-16s %5ld asked, %4ld off by 1 %%, %3ld lost, worst %.2g %%; another of its price "
            "was nearer in "
            "%ld\n",
            line.name.c_str(), line.asked, line.wrong, line.lost, 100 * line.worst, line.beaten);
        if (line.name.starts_with("many")) continue;  // must be cheap, or keep the energy, and is not near
        asked += line.asked, beaten += line.beaten, wrong += line.wrong;
        worst = std::max(worst, line.worst);
    }
    out.number("take_questions", double(asked), "", "throws of one body in free flight");
    out.number("take_fastest", fastest, "", "h|omega| of the fastest of them, in a frame");
    out.number("take_worst", 100 * worst, "%", "how far the recommended line was off at most in two seconds", 2);
    out.number("take_seen", 100 * right_orientation, "%", "up to which an orientation is right", 2);
    out.check("take_right", wrong == 0 && worst < 1e-3 && beaten == 0,
              "one body in free flight, up to ten radians a frame: the recommended line is off by "
              "less than 0.1 % in "
              "two seconds, and in no throw in which it is off by more than 0.01 % another solver "
              "of its price is nearer");

    // Uneven frames.
    const auto four = questions::uneven_throws(ball_and_remainder_4, fair_turn, 4, 100);
    const auto kutta = questions::uneven_throws(RungeKuttaSpin{}, fair_uneven_turn, 4, 100);
    std::printf(
        "  uneven frames near the intermediate axis: ball and remainder 4 loses %.2g %%, "
        "Runge-Kutta 4 is off by %.2g %%\n",
        100 * four.lost, 100 * kutta.worst);
    out.number("uneven_4_lost", 100 * four.lost, "%",
               "of the throws near the intermediate axis that ball and remainder 4 loses by uneven "
               "frames, a quarter of a radian",
               2);
    out.check("uneven_frames", four.lost > 0.1 && kutta.worst < 0.01,
              "by frames of uneven length ball and remainder 4 loses more than a tenth of the "
              "throws near the middle "
              "axis; Runge-Kutta 4, a twelfth of a radian a step, is off by less than 1 %");

    // Two moments that are all but equal.
    const double axis = questions::nearer_declared(nearly_equal, true),
                 any = questions::nearer_declared(nearly_equal, false),
                 far_axis = questions::nearer_declared(4 * nearly_equal, true),
                 far = questions::nearer_declared(4 * nearly_equal, false);
    std::printf(
        "  5 %% apart, declared equal is nearer than passive in %.0f %% about the axis, %.0f %% "
        "any way; 20 %% apart "
        "in %.0f and %.0f %%\n",
        100 * axis, 100 * any, 100 * far_axis, 100 * far);
    out.check("nearly_equal", axis > 0.95 && any > 0.55 && far < 0.5,
              "two moments 5 % apart are better declared equal than stepped by passive, in most "
              "throws of any direction "
              "and in nearly all about the third axis; 20 % apart no longer in any direction");
}
