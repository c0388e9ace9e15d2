#include "despawn.hpp"

#include "property.hpp"

EXERCISE(despawn);

namespace {

using Spin = std::array<double, 3>;

struct Bodies {
    std::vector<Spin> spins;
    int width;

    int size() const { return static_cast<int>(spins.size()); }
    std::size_t numbers() const { return (spins.size() + width - 1) / width * width * 3; }

    std::vector<double> packs() const {
        std::vector<double> all(numbers());
        for (std::size_t at = 0; at < all.size(); ++at) {
            const std::size_t lane = at % width, row = at / width;
            all[at] = spins[std::min(row / 3 * width + lane, spins.size() - 1)][row % 3];
        }
        return all;
    }
    std::vector<double> without(int i) const { return learner(packs(), width, size(), i); }
    // Those that should be left.
    Bodies left(int i) const {
        Bodies others = *this;
        others.spins[i] = others.spins.back();
        others.spins.pop_back();
        return others;
    }
};

// What stands where body `b` should be.
Spin spin_at(const std::vector<double>& packs, int width, int b) {
    const std::size_t first = b / width * width * 3 + b % width;
    if (first + 2 * width >= packs.size()) return {};
    return {packs[first], packs[first + width], packs[first + 2 * width]};
}

Spin draw_spin(Draw& draw) {
    const double x = draw.real(-9, 9), y = draw.real(-9, 9), z = draw.real(-9, 9);
    return {x, y, z};
}

Bodies draw_bodies(Draw& draw, int n, int width) {
    Bodies bodies{{}, width};
    for (int i = 0; i < n; ++i) bodies.spins.push_back(draw_spin(draw));
    return bodies;
}

int draw_width(Draw& draw) { return 1 << draw.integer(0, 4); }

// Few bodies with the spins (1, 2, 3), (4, 5, 6) and so on: what becomes of them can be seen.
Bodies few_bodies(Draw& draw, int n) {
    Bodies bodies{{}, 1 << draw.integer(0, 2)};
    for (int b = 0; b < n; ++b) bodies.spins.push_back({3.0 * b + 1, 3.0 * b + 2, 3.0 * b + 3});
    return bodies;
}

// The packs are full, hold one body more, lack one, or lack several. At first, few bodies.
Bodies draw_any(Draw& draw, int i) {
    if (i < 16) return few_bodies(draw, 2 + i / 4);
    const int width = i % 8 == 7 ? 1 : draw_width(draw), more[] = {0, 1, width - 1, width / 2};
    return draw_bodies(draw, width * draw.integer(1, 6) + more[i % 4], width);
}

}  // namespace

PROPERTY("there are as many packs as the bodies that are left need, and no more") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Bodies bodies = draw_any(draw, i);
        const int gone = draw.integer(0, bodies.size() - 1);
        REQUIRE(bodies.without(gone).size() == bodies.left(gone).numbers());
    }
}

PROPERTY("every other body but the last one stays where it is") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Bodies bodies = draw_any(draw, i);
        const int gone = draw.integer(0, bodies.size() - 1);
        const std::vector<double> packs = bodies.without(gone);
        for (int b = 0; b + 1 < bodies.size(); ++b)
            if (b != gone) REQUIRE(spin_at(packs, bodies.width, b) == bodies.spins[b]);
    }
}

PROPERTY("the last body stands where the one was that has gone") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Bodies bodies = draw_any(draw, i);
        if (bodies.size() < 2) continue;
        const int gone = draw.integer(0, bodies.size() - 2);
        REQUIRE(spin_at(bodies.without(gone), bodies.width, gone) == bodies.spins.back());
    }
}

PROPERTY("the lanes left over are copies of the body that is the last now") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Bodies bodies = draw_any(draw, i);
        if (bodies.size() < 3) continue;
        const int gone = draw.integer(0, bodies.size() - 3);
        const std::vector<double> packs = bodies.without(gone);
        const Spin last = bodies.spins[bodies.size() - 2];
        for (int b = bodies.size() - 1; b % bodies.width != 0; ++b) REQUIRE(spin_at(packs, bodies.width, b) == last);
    }
}

PROPERTY("it is right wherever the task allows: each width, each number of bodies about it, and each of them goes") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (const int width : {1, 2, 4, 8, 16})
        for (int n = 1; n <= 2 * width + 2; ++n) {
            const Bodies bodies = draw_bodies(draw, n, width);
            for (int i = 0; i < n; i += width < 8 ? 1 : draw.integer(1, width / 2))
                all &= bodies.without(i) == bodies.left(i).packs();
            all &= bodies.without(n - 1) == bodies.left(n - 1).packs();
        }
    Bodies alike = draw_bodies(draw, draw.integer(2, 40), draw_width(draw));  // two of them equal
    alike.spins.back() = alike.spins.front();
    for (int i = 0; i < alike.size(); ++i) all &= alike.without(i) == alike.left(i).packs();
    REQUIRE(all);
}

PROPERTY("packs of hundreds of bodies, up to a thousand, are made by the same rules, whatever the numbers") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 40; ++i) {
        const int width = 1 << i % 5, n = i < 5 ? 1000 - i : static_cast<int>(draw.spread(30, 1001, i, 8));
        Bodies bodies = draw_bodies(draw, n, width);
        const double size = draw.spread(1e-300, 1e300, i, 13);
        for (Spin& spin : bodies.spins)
            for (double& number : spin) number *= size;
        const int gone = i % 4 == 0 ? n - 1 : i % 4 == 1 ? n - 2 : draw.integer(0, n - 1);
        all &= bodies.without(gone) == bodies.left(gone).packs();
    }
    REQUIRE(all);
}
