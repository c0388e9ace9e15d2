#include "fair_ratio.hpp"

#include "property.hpp"

EXERCISE(fair_ratio);

namespace {

using Rounds = std::vector<std::array<double, 3>>;

// What the loop costs, and by how much more the solvers cost than the loop.
struct Costs {
    explicit Costs(Draw& draw) : loop(draw.log(1e-6, 1e-2)) {
        for (double& cost : solver) cost = loop * draw.log(0.02, 50);
    }

    double ratio() const { return solver[0] / solver[1]; }
    std::array<double, 3> quiet() const { return {loop + solver[0], loop + solver[1], loop}; }

    double loop;
    std::array<double, 2> solver{};
};

std::size_t draw_place(Draw& draw, std::size_t size) {
    return static_cast<std::size_t>(draw.integer(0, static_cast<int>(size) - 1));
}

// In each column all rounds but one are disturbed, by a little or by much. Every other time whole
// rounds are slow as well, but for the three that tell.
Rounds disturbed(Draw& draw, const std::array<double, 3>& quiet, int least, int most) {
    Rounds rounds(static_cast<std::size_t>(draw.integer(least, most)), quiet);
    std::array<std::size_t, 3> spared{};
    for (std::size_t& round : spared) round = draw_place(draw, rounds.size());
    const bool throttled = draw.sign() > 0;
    for (std::size_t round = 0; round < rounds.size(); ++round) {
        const double slow = throttled ? draw.real(1, 3) : 1;
        for (std::size_t i = 0; i < 3; ++i)
            if (round != spared[i]) rounds[round][i] *= slow * (1 + draw.log(1e-3, 10));
    }
    return rounds;
}

// How many rounds at most: a learner is shown the first that is wrong, and can check few by hand.
int most(int i) { return i < 20 ? 3 : 25; }

// A solver's own time is 0.002 of what is timed or more: that makes 500 times a time's roundoff.
// And a ratio found as one plus a difference, be it 0.0004, has some thousand times that.
constexpr double roundoff = 1e-9;

}  // namespace

PROPERTY("one round is enough where nothing disturbs, and more of them change nothing") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const Costs costs(draw);
        REQUIRE(close(learner({costs.quiet()}), costs.ratio(), roundoff));
        const Rounds rounds(static_cast<std::size_t>(draw.integer(2, 3)), costs.quiet());
        REQUIRE(close(learner(rounds), costs.ratio(), roundoff));
    }
}

PROPERTY("one disturbance changes nothing, be it in A, in B, in the empty loop, or in all") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Costs costs(draw);
        Rounds rounds(static_cast<std::size_t>(draw.integer(2, i < 20 ? 3 : 9)), costs.quiet());
        auto& round = rounds[i % 3 == 0 ? 0 : draw_place(draw, rounds.size())];
        if (i % 4 == 3)
            for (double& time : round) time *= 2;
        else
            round[static_cast<std::size_t>(i % 4)] *= 1 + draw.log(0.01, 100);
        REQUIRE(close(learner(rounds), costs.ratio(), roundoff));
    }
}

PROPERTY("where all rounds but one are disturbed, for each another one, the ratio stays") {
    Draw draw;
    for (int i = 0; i < 150; ++i) {
        const Costs costs(draw);
        REQUIRE(close(learner(disturbed(draw, costs.quiet(), 2, most(i))), costs.ratio(), roundoff));
    }
}

PROPERTY("it is right wherever the task allows: from nanoseconds to a thousand seconds, solvers nearly alike") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 300; ++i) {
        Costs costs(draw);
        costs.loop = draw.log(1e-9, i % 2 == 0 ? 1 : 400);
        // How much longer than the loop, but not a thousand times as long as the other: whoever finds a ratio as
        // one plus a difference loses as many digits.
        costs.solver[0] = std::min(costs.loop * draw.log(1e-3, 1e9), 500.0);
        costs.solver[1] = std::clamp(costs.solver[0] * draw.log(1e-3, 1e3), 1e-3 * costs.loop, 500.0);
        if (i % 4 == 0) costs.solver[1] = costs.solver[0] * (1 + draw.log(1e-6, 1e-2));
        Rounds rounds(static_cast<std::size_t>(draw.integer(1, i < 100 ? 3 : 40)), costs.quiet());
        const double most = std::max(costs.solver[0], costs.solver[1]) + costs.loop;
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t spared = draw_place(draw, rounds.size());
            for (std::size_t round = 0; round < rounds.size(); ++round)
                if (round != spared) rounds[round][column] *= 1 + std::min(draw.log(1e-9, 1e3), 999 / most - 1);
        }
        const auto [a, b, empty] = costs.quiet();
        all &= close(learner(rounds), (a - empty) / (b - empty), roundoff);
    }
    REQUIRE(all);
}

// In the first round, in the last or in any between, and the rounds that tell far apart.
PROPERTY("hundreds of rounds may be disturbed, all but the one that tells") {
    Draw draw;
    for (int i = 0; i < 24; ++i) {
        const Costs costs(draw);
        const int rounds = static_cast<int>(draw.spread(20, 1500, i, 8));
        REQUIRE(close(learner(disturbed(draw, costs.quiet(), rounds, rounds)), costs.ratio(), roundoff));
        Rounds last(static_cast<std::size_t>(rounds), costs.quiet());
        for (std::size_t round = 0; round + 1 < last.size(); ++round)
            for (double& time : last[round]) time *= 1 + draw.log(1e-3, 10);
        REQUIRE(close(learner(last), costs.ratio(), roundoff));
    }
}

PROPERTY("no time that the task allows is too short or too long for it") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 240; ++i) {
        Costs costs(draw);
        costs.loop = draw.spread(1e-9, 400, i, 15);
        for (double& cost : costs.solver) cost = costs.loop * draw.log(1e-3, 1);
        costs.solver[0] = std::min(costs.solver[1] * draw.spread(1, 1e3, i, 16), 500.0);
        const auto [a, b, empty] = costs.quiet();
        all &= close(learner({costs.quiet()}), (a - empty) / (b - empty), roundoff);
        all &= close(learner({{b, a, empty}}), (b - empty) / (a - empty), roundoff);
    }
    REQUIRE(all);
}
