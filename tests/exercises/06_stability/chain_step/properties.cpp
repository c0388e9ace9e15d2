#include "chain_step.hpp"

#include "property.hpp"

EXERCISE_WITHIN(chain_step, checker::many_are_right);  // the equations are held to their digits below

namespace {

using Masses = std::vector<State<double>>;

// x in metres, v in metres a step: then h² k/m is all that tells one chain from another.
struct Chain {
    double m, h, stiff;  // stiff = h² k/m
    Masses s;

    Chain(Draw& draw, int masses, double stiff) : m(draw.log(1e-3, 1e3)), h(draw.log(1e-3, 1)), stiff(stiff) {
        const double t = draw.real(0, 1), speed = draw.sign() > 0 ? 1 : 1 + std::sqrt(stiff);
        for (int i = 0; i < masses; ++i) s.push_back({t, away(draw), speed * away(draw) / h});
    }
    // Not near zero: whoever adds up the patterns of a chain has the roundoff of the others there.
    static double away(Draw& draw) { return draw.sign() * draw.real(0.1, 1); }
    double k() const { return stiff * m / (h * h); }
    Masses answer() const {
        const Masses next = learner(s, m, k(), h);
        REQUIRE(next.size() == s.size());
        return next;
    }
    // How much longer a link is than at rest, the one above mass i.
    static double longer(const Masses& s, std::size_t i) {
        return i == s.size() ? 0 : s[i].x - (i > 0 ? s[i - 1].x : 0);
    }
    // Over m/h².
    double energy(const Masses& s) const {
        double sum = 0;
        for (std::size_t i = 0; i < s.size(); ++i) sum += h * s[i].v * h * s[i].v + stiff * longer(s, i) * longer(s, i);
        return sum / 2;
    }
    // The largest of x and of h v.
    double size() const {
        double size = 0;
        for (const auto& [t, x, v] : s) size = std::max({size, std::fabs(x), std::fabs(h * v)});
        return size;
    }
    // Does each mass obey the equations? What is missing is small beside the terms: x2 is the
    // difference of two numbers of the size of x1 and is multiplied by 4 h² k/m.
    bool is_step(const Masses& next) const {
        const double largest = size();
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double force = longer(next, i + 1) - longer(next, i);
            const double change = h * (next[i].v - s[i].v);  // over m/h², as the force
            if (!close(change, stiff * force, 0, 1e-10 * (1 + 4 * stiff) * largest)) return false;
            if (!close(next[i].x, s[i].x + h * next[i].v, 0, 1e-12 * largest)) return false;
            if (!close(next[i].t, s[i].t + h, 0, 1e-14)) return false;
        }
        return true;
    }
};

double draw_stiff(Draw& draw) { return draw.log(1e-3, 1e6); }

}  // namespace

PROPERTY("in no time nothing happens, and without stiffness all masses fly on") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Chain chain(draw, draw.integer(1, 8), draw_stiff(draw));
        const Masses same = learner(chain.s, chain.m, chain.k(), 0);
        REQUIRE(same.size() == chain.s.size());
        for (std::size_t j = 0; j < same.size(); ++j) {
            REQUIRE(same[j].t == chain.s[j].t);
            REQUIRE(close(same[j].x, chain.s[j].x, 1e-12));
            REQUIRE(close(same[j].v, chain.s[j].v, 1e-12));
        }
        const Chain free(draw, draw.integer(1, 8), 0);
        REQUIRE(free.is_step(free.answer()));
    }
}

PROPERTY("one mass alone is a spring") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Chain chain(draw, 1, draw_stiff(draw));
        const auto [t, x, v] = chain.s[0];
        const State<double> next = chain.answer()[0];
        const double kick = -chain.stiff * x / chain.h;
        REQUIRE(close(next.v, (v + kick) / (1 + chain.stiff), 0, 1e-12 * chain.size() / chain.h));
        REQUIRE(close(next.x, x + chain.h * next.v, 0, 1e-12 * chain.size()));
        REQUIRE(close(next.t, t + chain.h, 0, 1e-14));
    }
}

PROPERTY("of two masses to five, each obeys the equations at the end of the step") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const Chain chain(draw, draw.integer(2, 5), draw_stiff(draw));
        REQUIRE(chain.is_step(chain.answer()));
    }
}

PROPERTY("no step adds energy") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Chain chain(draw, draw.integer(1, 30), draw_stiff(draw));
        REQUIRE(chain.energy(chain.answer()) <= chain.energy(chain.s) * (1 + 1e-9));
    }
}

PROPERTY("it is right wherever the task allows: one mass or sixty, soft or stiff links, short and long steps") {
    Draw draw;
    Every all;
    for (int i = 0; i < 200; ++i) {
        Chain chain(draw, i % 4 == 0 ? draw.integer(1, 2) : draw.integer(1, 60), draw.any_of(0, 1e6, {0, 1e-6, 1e6}));
        const double longer = draw.any_of(1e-6, 1e6, {1e-6, 1e6});  // the same chain, at another rate
        chain.m *= draw.any_of(1e-3, 1e3, {1});
        chain.h *= longer;
        for (auto& [t, x, v] : chain.s) v /= longer;
        all &= chain.is_step(chain.answer());
        if (i % 4 == 0) {
            for (auto& [t, x, v] : chain.s) x = v = 0;
            for (const auto& [t, x, v] : chain.answer()) all &= (x == 0 && v == 0);
        }
    }
    REQUIRE(bool(all));
}

PROPERTY("no mass, no link and no step is too small or too large for it, in a chain of any length") {
    Draw draw;
    Every all;
    for (int i = 0; i < 240; ++i) {
        Chain chain(draw, 1 + (i * 7) % 60, draw.spread(1e-9, 1e6, i, 16));
        const double longer = draw.spread(1e-9, 1e9, i, 17) / chain.h;
        chain.m = draw.spread(1e-12, 1e12, i, 19);
        chain.h *= longer;
        for (auto& [t, x, v] : chain.s) t = 0, v /= longer;
        const double size = draw.spread(1e-9, 1e9, i, 13);
        for (auto& [t, x, v] : chain.s) x *= size, v *= size;
        Masses next = chain.answer();
        for (auto& [t, x, v] : next) all &= close(t, chain.h, 1e-14), t = chain.h;
        all &= chain.is_step(next);
    }
    REQUIRE(bool(all));
}
