#include "sort_by_kind.hpp"

#include "property.hpp"

EXERCISE(sort_by_kind);

namespace {

struct Bodies {
    Bodies(Draw& draw, int n, int count) : count(count) {
        for (int i = 0; i < n; ++i) kinds.push_back(draw.integer(0, count - 1));
    }
    int size() const { return static_cast<int>(kinds.size()); }

    std::vector<int> kinds;
    int count;
};

// Few at first, which can be sorted by hand.
Bodies draw_bodies(Draw& draw, int i) {
    if (i < 12) return Bodies(draw, 2 + i / 3, draw.integer(2, 3));
    const int n = static_cast<int>(draw.log(20, 400)), count = static_cast<int>(draw.log(2, 15));
    return Bodies(draw, n, count);
}

bool all_there(const Bodies& bodies, std::vector<int> order) {
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i] != static_cast<int>(i)) return false;
    return order.size() == bodies.kinds.size();
}

// begins must tell groups that follow one another and hold all the bodies, each its own kind.
bool groups_hold(const Bodies& bodies, const std::array<std::vector<int>, 2>& answer) {
    const auto& [order, begins] = answer;
    if (!all_there(bodies, order) || static_cast<int>(begins.size()) != bodies.count + 1) return false;
    if (begins.front() != 0 || begins.back() != bodies.size()) return false;
    for (int k = 0; k < bodies.count; ++k) {
        if (begins[k] > begins[k + 1] || begins[k + 1] > bodies.size()) return false;
        for (int place = begins[k]; place < begins[k + 1]; ++place)
            if (bodies.kinds[order[place]] != k) return false;
    }
    return true;
}

bool in_order(const Bodies& bodies, const std::vector<int>& order) {
    if (!all_there(bodies, order)) return false;
    for (std::size_t place = 1; place < order.size(); ++place) {
        const int before = order[place - 1], here = order[place];
        if (bodies.kinds[before] == bodies.kinds[here] && before > here) return false;
    }
    return true;
}

}  // namespace

PROPERTY("every body is there, and none twice") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Bodies bodies = draw_bodies(draw, i);
        REQUIRE(all_there(bodies, learner(bodies.kinds, bodies.count)[0]));
    }
}

PROPERTY("each group holds its own kind, from where it begins to where the next begins") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Bodies bodies = draw_bodies(draw, i);
        REQUIRE(groups_hold(bodies, learner(bodies.kinds, bodies.count)));
    }
}

PROPERTY("bodies of one kind stay in the order they had") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Bodies bodies = draw_bodies(draw, i);
        REQUIRE(in_order(bodies, learner(bodies.kinds, bodies.count)[0]));
    }
}

// Mostly more kinds than bodies, so that most groups are empty, also the first or the last; or one
// kind. No body, one that is alone, or few.
PROPERTY("a kind without a body begins where the next one does, and all do where no body is") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const int n = i % 3 < 2 ? i % 3 : static_cast<int>(draw.log(2, 20));
        const Bodies bodies(draw, n, i % 5 == 1 ? 1 : draw.integer(2, 100));
        const auto answer = learner(bodies.kinds, bodies.count);
        REQUIRE(groups_hold(bodies, answer));
        REQUIRE(in_order(bodies, answer[0]));
    }
}

PROPERTY("bodies that are sorted stay where they are, also ten thousand of them") {
    Draw draw;
    for (int i = 0; i < 10; ++i) {
        Bodies bodies = draw_bodies(draw, i < 5 ? 2 * i : 12);
        if (i == 8) bodies = Bodies(draw, 10000, 100);
        const int many_kinds = draw.integer(1, 100);
        if (i == 9) bodies = Bodies(draw, static_cast<int>(draw.log(400, 10000)), many_kinds);
        const auto many = learner(bodies.kinds, bodies.count);
        REQUIRE(groups_hold(bodies, many));
        REQUIRE(in_order(bodies, many[0]));
        std::sort(bodies.kinds.begin(), bodies.kinds.end());
        const auto [order, begins] = learner(bodies.kinds, bodies.count);
        REQUIRE(std::is_sorted(order.begin(), order.end()));
        REQUIRE(begins == many[1]);
    }
}

PROPERTY("it is right wherever the task allows: any kinds, all of one kind, none of the first or the last kinds") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 120; ++i) {
        const int count = i % 4 == 0 ? 100 : draw.integer(1, 100);
        const int n = static_cast<int>(draw.log(1, i < 5 ? 10001 : 200)) - 1;
        const int first = i % 3 == 0 ? draw.integer(0, count - 1) : 0;
        Bodies bodies(draw, n, i % 2 == 0 ? count - first : draw.integer(1, count - first));
        for (int& kind : bodies.kinds) kind += first;
        bodies.count = count;
        if (i % 6 == 5) std::reverse(bodies.kinds.begin(), bodies.kinds.end());
        const auto answer = learner(bodies.kinds, bodies.count);
        all &= groups_hold(bodies, answer) && in_order(bodies, answer[0]);
    }
    REQUIRE(all);
}

PROPERTY("thousands of bodies, of a few kinds or of a hundred, are sorted alike") {
    Draw draw;
    for (int i = 0; i < 12; ++i) {
        const int n = i == 0 ? 10000 : static_cast<int>(draw.spread(200, 10001, i, 6));
        const Bodies bodies(draw, n, static_cast<int>(draw.spread(1, 101, i, 5)));
        const auto answer = learner(bodies.kinds, bodies.count);
        REQUIRE(groups_hold(bodies, answer));
        REQUIRE(in_order(bodies, answer[0]));
    }
}
