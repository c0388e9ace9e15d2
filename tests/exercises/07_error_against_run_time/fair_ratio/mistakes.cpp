#include "exercise.hpp"

// Says: You compare the means, or the sums, whose ratio is the same. One long disturbance is enough to spoil it.
// Hint: Disturbances only make times longer, and so a mean, too. Which of the times is the least spoilt?
namespace mean {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> sum{};
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += round[i];
    return (sum[0] - sum[2]) / (sum[1] - sum[2]);
}

}  // namespace mean

// Says: You compare the medians. They forgive a few disturbed rounds, but not more than half of them.
// Hint: All but one of the times may be disturbed. Which one is left?
namespace median {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> middle{};
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> times;
        for (const auto& round : rounds) times.push_back(round[i]);
        std::sort(times.begin(), times.end());
        middle[i] = times[times.size() / 2];
    }
    return (middle[0] - middle[2]) / (middle[1] - middle[2]);
}

}  // namespace median

// Says: You compare the slowest times. They tell most of all how long the longest disturbances were.
// Hint: Does a disturbance make a time longer or shorter? Then look at the other end.
namespace slowest {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> most = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], round[i]);
    return (most[0] - most[2]) / (most[1] - most[2]);
}

}  // namespace slowest

// Says: This is the mean of the ratios of the rounds. A disturbance hits A, B or the empty loop, seldom all
//       of them alike, and then that round's ratio is wrong.
// Hint: Find first what A costs, from all its rounds; then B. Divide at the end.
namespace mean_of_ratios {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    double sum = 0;
    for (const auto& [a, b, empty] : rounds) sum += (a - empty) / (b - empty);
    return sum / double(rounds.size());
}

}  // namespace mean_of_ratios

// Says: This is the median of the ratios of the rounds. Where most rounds are disturbed, most ratios are
//       wrong.
// Hint: The quiet round of A and the quiet round of B may be two. No ratio of one round is right then.
namespace median_of_ratios {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::vector<double> ratios;
    for (const auto& [a, b, empty] : rounds) ratios.push_back((a - empty) / (b - empty));
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

}  // namespace median_of_ratios

// Says: This is the least of the ratios of the rounds: the round where B was disturbed the most wins.
// Hint: A disturbance makes a time longer. But does it make a ratio larger? It depends on whom it hits.
namespace least_ratio {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, empty] : rounds) least = std::min(least, (a - empty) / (b - empty));
    return least;
}

}  // namespace least_ratio

// Says: You take all three times from the round in which A was fastest. B or the empty loop may have been
//       disturbed just then.
// Hint: Each column has a fastest round of its own.
namespace one_round_for_all {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> best = rounds[0];
    for (const auto& round : rounds)
        if (round[0] < best[0]) best = round;
    return (best[0] - best[2]) / (best[1] - best[2]);
}

}  // namespace one_round_for_all

// Says: You take all three times from the round whose sum is least, the quietest as a whole. In every round
//       something may have been disturbed.
// Hint: The quiet moment of A, that of B and that of the loop may be in three rounds. Look for each by
//       itself.
namespace least_sum {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    const auto sum = [](const std::array<double, 3>& round) {
        return round[0] + round[1] + round[2];
    };
    std::array<double, 3> best = rounds[0];
    for (const auto& round : rounds)
        if (sum(round) < sum(best)) best = round;
    return (best[0] - best[2]) / (best[1] - best[2]);
}

}  // namespace least_sum

// Says: You subtract the empty loop of the same round first, and then take the least. A round with a
//       disturbed loop makes a difference too small, even negative, and the least picks just that.
// Hint: Take the fastest of each column first. Subtract then.
namespace fastest_differences {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 2> least{};
    for (std::size_t i = 0; i < 2; ++i) {
        least[i] = std::numeric_limits<double>::infinity();
        for (const auto& round : rounds) least[i] = std::min(least[i], round[i] - round[2]);
    }
    return least[0] / least[1];
}

}  // namespace fastest_differences

// Says: The loop and the clock are still in both times, and pull the ratio towards one.
// Hint: What would A take if it did nothing? That much is not A's.
namespace loop_kept {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return fastest[0] / fastest[1];
}

}  // namespace loop_kept

// Says: You have taken the loop's time off A, but not off B.
// Hint: B was timed with the same loop and the same clock.
namespace loop_only_from_a {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return (fastest[0] - fastest[2]) / fastest[1];
}

}  // namespace loop_only_from_a

// Says: You subtract the loop's time once, from the quotient. That is a time taken from a number without a
//       unit.
// Hint: Subtract it from each time, before you divide. A minus sign needs brackets in a fraction.
namespace loop_from_ratio {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return fastest[0] / fastest[1] - fastest[2];
}

}  // namespace loop_from_ratio

// Says: A and B are judged by their fastest rounds, but the empty loop by its mean. It is disturbed as well.
// Hint: What you do with A, do with the empty loop.
namespace mean_of_the_loop {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    double sum = 0;
    for (const auto& round : rounds) {
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
        sum += round[2];
    }
    const double empty = sum / double(rounds.size());
    return (fastest[0] - empty) / (fastest[1] - empty);
}

}  // namespace mean_of_the_loop

// Says: The first round does not count: it is thrown away, for warming up, or a loop begins at 1. It may be the only
//       quiet one, or the only one there is.
// Hint: If you take the fastest, slow rounds need not be thrown away. And in C++ the first round has the place 0.
namespace first_left_out {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds.back();
    for (std::size_t round = 1; round < rounds.size(); ++round)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], rounds[round][i]);
    return (fastest[0] - fastest[2]) / (fastest[1] - fastest[2]);
}

}  // namespace first_left_out

// Says: Only the first round is looked at.
// Hint: One measurement is none. What do all the others tell?
namespace first_round {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    const auto [a, b, empty] = rounds[0];
    return (a - empty) / (b - empty);
}

}  // namespace first_round

// Says: This is how many times as long B takes as A.
// Hint: Ask of your answer: if A is slow, is it large?
namespace upside_down {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return (fastest[1] - fastest[2]) / (fastest[0] - fastest[2]);
}

}  // namespace upside_down

// Says: The times go through float, and the small difference of two of them is what is left of its seven
//       digits.
// Hint: Stay with double.
namespace single_precision {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<float, 3> fastest{1e6f, 1e6f, 1e6f};
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], float(round[i]));
    return (fastest[0] - fastest[2]) / (fastest[1] - fastest[2]);
}

}  // namespace single_precision

// Says: This is by how much longer A takes, as a share of B: one less than the ratio.
// Hint: A solver beside itself has the ratio 1. What do you return there?
namespace share_of_more {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return (fastest[0] - fastest[1]) / (fastest[1] - fastest[2]);
}

}  // namespace share_of_more

// Says: You have taken the loop's time off B, but not off A.
// Hint: Both times have the loop and the clock in them.
namespace loop_only_from_b {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return fastest[0] / (fastest[1] - fastest[2]);
}

}  // namespace loop_only_from_b

// Says: Whatever was measured, A takes twice as long for you, as in the example.
// Hint: Begin with the fastest time of A.
namespace example {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    return 2;
}

}  // namespace example
