#include "replay_fits.hpp"

#include "property.hpp"

EXERCISE(replay_fits);

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A scene, and the truth at its marks.
struct Flight {
    // At most so many: at first few, which can be worked out by hand.
    static int most_marks(int i) { return i < 12 ? 4 : 40; }

    Flight(Draw& draw, int most_marks, int least_marks = 1, double least_accuracy = 1e-9)
        : size(draw.log(1e-3, 1e4)), accuracy(draw.log(least_accuracy, 1)) {
        const int marks = draw.integer(least_marks, most_marks);
        for (int mark = 0; mark < marks; ++mark) exact.push_back(size * draw.real(-3, 3));
    }

    // The truth, off by `much` of what is allowed, at every mark to a side of its own.
    std::vector<double> off(Draw& draw, double much) const {
        std::vector<double> x = exact;
        for (double& height : x) height += draw.sign() * much * accuracy * size;
        return x;
    }

    std::vector<double> exact;
    double size, accuracy;
};

// The first mark, the last, or any.
std::size_t draw_mark(Draw& draw, int i, std::size_t marks) {
    const int last = static_cast<int>(marks) - 1;
    return static_cast<std::size_t>(i % 3 == 0 ? 0 : i % 3 == 1 ? last : draw.integer(0, last));
}

}  // namespace

PROPERTY("a perfect replay is within any accuracy, also within zero") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Flight flight(draw, Flight::most_marks(i));
        REQUIRE(learner(flight.exact, flight.exact, flight.size, flight.accuracy));
        REQUIRE(learner(flight.exact, flight.exact, flight.size, 0));
    }
}

PROPERTY("one mark that is very far off is enough, where all others are perfect") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Flight flight(draw, Flight::most_marks(i), 4, 1e-3);
        std::vector<double> x = flight.exact;
        const double much = 1.5 * std::sqrt(static_cast<double>(x.size()));
        x[draw_mark(draw, i, x.size())] += draw.sign() * much * flight.accuracy * flight.size;
        REQUIRE(!learner(x, flight.exact, flight.size, flight.accuracy));
    }
}

PROPERTY("one mark a bit too far off is enough, the first, the last or any, to either side") {
    Draw draw;
    for (int i = 0; i < 150; ++i) {
        const Flight flight(draw, Flight::most_marks(i), 2);
        std::vector<double> x = flight.off(draw, i % 2 == 0 ? 0 : draw.real(0, 0.9));
        const std::size_t bad = draw_mark(draw, i, x.size());
        const double more = draw.sign() * draw.log(1.001, 3) * flight.accuracy * flight.size;
        x[bad] = flight.exact[bad] + more;
        REQUIRE(!learner(x, flight.exact, flight.size, flight.accuracy));
    }
}

PROPERTY("a replay with a height that is infinite is not within any accuracy") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Flight flight(draw, Flight::most_marks(i));
        std::vector<double> x = flight.off(draw, draw.real(0, 0.9));
        x[draw_mark(draw, i, x.size())] = draw.sign() * infinity;
        REQUIRE(!learner(x, flight.exact, flight.size, flight.accuracy));
        REQUIRE(!learner(x, flight.exact, flight.size, 0));
    }
}

PROPERTY("a replay that is NaN at one mark, whichever it is, is not within any accuracy") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Flight flight(draw, Flight::most_marks(i));
        std::vector<double> x = flight.off(draw, draw.real(0, 0.9));
        x[draw_mark(draw, i, x.size())] = not_a_number;
        REQUIRE(!learner(x, flight.exact, flight.size, flight.accuracy));
        x[draw_mark(draw, i, x.size())] += flight.size;
        REQUIRE(!learner(x, flight.exact, flight.size, flight.accuracy));
    }
}

PROPERTY("a replay that broke off is not within, however well it fits as far as it goes") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const Flight flight(draw, Flight::most_marks(i));
        std::vector<double> x = flight.off(draw, draw.real(0, 0.9));
        x.resize(i % 4 == 0 ? 0 : draw_mark(draw, i, x.size()));
        REQUIRE(!learner(x, flight.exact, flight.size, flight.accuracy));
    }
}

// All are binary fractions: the error and the product of size and accuracy are not rounded.
PROPERTY("an error just as large as the accuracy is within, and one larger by a hair is not") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double size = std::ldexp(1, draw.integer(-9, 13));
        const double accuracy = std::ldexp(1, -draw.integer(0, 29)), error = size * accuracy;
        std::vector<double> exact(static_cast<std::size_t>(draw.integer(1, 20)));
        for (double& height : exact) height = draw.integer(-1000, 1000) * error;
        std::vector<double> x = exact;
        for (double& height : x) height += draw.integer(-1, 1) * error;
        const std::size_t mark = draw_mark(draw, i, x.size());
        const double side = draw.sign();
        x[mark] = exact[mark] + side * error;
        REQUIRE(learner(x, exact, size, accuracy));
        x[mark] = exact[mark] + side * error * (1 + 1e-9);
        REQUIRE(!learner(x, exact, size, accuracy));
    }
}

PROPERTY("it is right wherever the task allows: small and large scenes, flights high up, accuracies from 1e-9 on") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 500; ++i) {
        Flight flight(draw, Flight::most_marks(i));
        flight.size = draw.any_of(1e-4, 1e5, {1e-4, 1, 1e5});
        flight.accuracy = draw.log(1e-9, 1);
        flight.exact.resize(std::min<std::size_t>(flight.exact.size(), 5));
        const double up = flight.size * draw.any_of(0, 300, {0, 300}), part = draw.log(1e-3, 1);
        for (double& height : flight.exact) height = draw.sign() * up + flight.size * part * draw.real(-1, 1);
        // Beside the border, or clearly to one of its sides: by how much, an epsilon would have to be known.
        const double off = std::max(draw.log(1e-9, 1), 1e-12 / flight.accuracy);
        const bool within = i % 2 == 0;
        std::vector<double> x = flight.off(draw, within ? draw.real(0, 1) / (1 + off) : 0);
        const std::size_t mark = draw_mark(draw, i, x.size());
        const double side = draw.sign() * flight.accuracy * flight.size;
        x[mark] = flight.exact[mark] + side * (within ? 1 / (1 + off) : 1 + off);
        all &= learner(x, flight.exact, flight.size, flight.accuracy) == within;
        all &= learner(x, flight.exact, flight.size, 0) == (x == flight.exact);
    }
    REQUIRE(all);
}

// Heights and errors are binary fractions, so that the last bit is all that is too much.
PROPERTY("replays may have a thousand marks, of which one is too far off by the last bit") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 66; ++i) {
        const double size = std::ldexp(1, draw.integer(-13, 16));
        const double accuracy = i % 4 == 0 ? 0 : std::ldexp(1, -draw.integer(0, 29));
        const double error = size * accuracy, unit = accuracy > 0 ? error : size;
        std::vector<double> exact(static_cast<std::size_t>(draw.spread(1, 1001, i, 11)));
        for (double& height : exact) height = draw.integer(-1000, 1000) * unit;
        std::vector<double> x = exact;
        for (double& height : x) height += draw.integer(-1, 1) * error;
        const std::size_t mark = draw_mark(draw, i, x.size());
        exact[mark] = i % 4 == 2 ? 0 : draw.integer(1, 1000) * unit;  // at zero the last bit is that of the error
        const double side = draw.sign(), just = exact[mark] + side * error;
        x[mark] = just;
        all &= learner(x, exact, size, accuracy);
        x[mark] = std::nextafter(just, side * infinity);
        if (x[mark] - exact[mark] != side * error) all &= !learner(x, exact, size, accuracy);
        x[mark] = exact[mark] + side * (error + size * draw.log(1e-15, 1));
        if (std::fabs(x[mark] - exact[mark]) > error) all &= !learner(x, exact, size, accuracy);
        x[mark] = i % 3 == 0 ? not_a_number : side * infinity;
        all &= !learner(x, exact, size, accuracy);
        x.resize(x.size() - 1);
        all &= !learner(x, exact, size, accuracy);
    }
    REQUIRE(all);
}

PROPERTY("no size of a scene and no accuracy that the task allows is too small or too large for it") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 240; ++i) {
        Flight flight(draw, Flight::most_marks(i));
        flight.size = draw.spread(1e-4, 1e5, i, 15);
        flight.accuracy = i % 16 == 0 ? 1e-9 : i % 16 == 15 ? 1 : draw.spread(1e-9, 1, i, 16);
        flight.exact.resize(std::min<std::size_t>(flight.exact.size(), 3));
        for (double& height : flight.exact) height = flight.size * draw.real(-1, 1);
        all &= learner(flight.off(draw, 0.999), flight.exact, flight.size, flight.accuracy);
        all &= !learner(flight.off(draw, 1.001), flight.exact, flight.size, flight.accuracy);
    }
    REQUIRE(all);
}
