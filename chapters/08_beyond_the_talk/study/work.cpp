// Error against time for three bodies and three spins, and what to take.

#include "work.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "sections.hpp"

using namespace timestep;
using contest::Point;

namespace {

struct Shape {
    const char *id, *words;
    Body inertia;
};
struct Pace {
    const char *id, *words;
    double spin;
};

using Points = std::vector<Point>;

constexpr double lost = 0.5;  // radians: a body that is off by more points elsewhere

std::string digits(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// To two digits, as long as that is a plain number.
std::string plain(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return digits("%g", std::round(value / unit) * unit);
}

// The point of a method at a rate, or at its shortest step: from there on it is exact to roundoff.
const Point& at(const Points& points, const std::string& id, double rate) {
    const Point* found = nullptr;
    for (const Point& p : points)
        if (p.entry->id == id && p.rate <= rate * 1.001) found = &p;
    return *found;
}

// The fastest of the chapter's methods that is as accurate, at this rate and at all above.
const Point* cheapest(const Points& points, double accuracy) {
    const Point *best = nullptr, *good = nullptr;
    for (std::size_t i = points.size(); i-- > 0;) {
        const bool last = i + 1 == points.size() || points[i + 1].entry != points[i].entry;
        if (last) good = nullptr;
        const bool before_is_good = last || good == &points[i + 1];
        if (points[i].entry->ours && before_is_good && points[i].error <= accuracy) {
            good = &points[i];
            if (!best || good->time < best->time) best = good;
        }
    }
    return best;
}

// Is every rule of the appendix among the points, with one inside of the picture's axes?
bool all_grey(const Points& points) {
    std::set<std::string> drawn;
    for (const Point& p : points)
        if (!p.entry->ours) drawn.insert(p.entry->id);
    bool all = true;
    for (const Method& m : others()) all = all && drawn.count(m.key) == 1;
    return all;
}

std::string in_words(const Point* p) {
    if (!p) return "none of these";
    return p->entry->name + ", " + digits("%.0f", p->rate) + "\u00a0Hz, " + plain(p->time * 1e6) + "\u00a0µs";
}

}  // namespace

void work(const Settings&, lab::Findings& out) {
    out.section("Error against time");
    const Shape shapes[] = {{"near", "nearly symmetric", {1, 1.02, 0.7}},
                            {"box", "box 1:2:3", box(12.0, 1.0, 2.0, 3.0)},
                            {"needle", "needle", {1, 1.01, 0.02}}};
    const Pace paces[] = {{"slow", "slow", 1}, {"game", "game", 10}, {"fast", "fast", 100}};
    const double rate = 60;

    auto& best = out.table("cheapest.tsv", {"body", "spin", "1 %", "one millionth"});
    std::map<std::string, Points> all;
    std::map<std::string, std::vector<contest::Entry>> kept;
    bool grey = true;
    for (const Shape& shape : shapes)
        for (const Pace& pace : paces) {
            const std::string id = std::string(shape.id) + "_" + pace.id;
            const Spin start = spinning(pace.spin / 3 * Vector(1, 2, 2));
            kept[id] = contest::entries(shape.inertia, start);
            const Points& points = all[id] = contest::measure(kept[id]);
            grey = grey && all_grey(points);
            auto& table = out.table("work_" + id + ".tsv", {"method", "ours", "rate", "error", "us"});
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Point& p = points[i];
                if (i > 0 && points[i - 1].entry != p.entry) table.gap();
                table.row({p.entry->id, double(p.entry->ours), p.rate, p.error, p.time * 1e6});
            }
            const Point *percent_1 = cheapest(points, 0.01), *millionth = cheapest(points, 1e-6);
            best.row(
                {std::string(shape.words), digits("%.0f rad/s", pace.spin), in_words(percent_1), in_words(millionth)});
            std::printf("  %-17s %3.0f rad/s  to 1 %%: %s\n", shape.words, pace.spin, in_words(percent_1).c_str());
        }

    out.check("work_grey", grey, "all nine panels show every rule of the appendix");

    const auto& ns = step_times();
    const auto cost = [&](const std::string& key, const std::string& name) {
        out.number("ns_" + name, ns.at(key), "ns", "time of a step", 3);
        out.number("cost_" + name, ns.at(key) / ns.at("implicit"), "", "over that of the talk's", 3);
    };
    const std::string magnus = "magnus_taylor_4";
    for (const Method& method : methods()) cost(method.key, method.key);
    cost("calm_twice", "calm_twice"), cost(magnus, "magnus"), cost("implicit_midpoint", "midpoint");
    out.number("rk4_price", ns.at("remainder_4") / ns.at("runge_kutta_4"), "",
               "time of a step of ball and remainder 4 over that of Runge-Kutta 4", 2);
    out.number("magnus_price", 100 * ns.at(magnus) / ns.at("remainder_2"), "%",
               "time of a step of Magnus and Taylor over that of ball and remainder 2", 2);
    out.number("work_seconds", contest::seconds, "s", "how long every body is watched");
    out.text("processor", lab::processor(), "what the times were measured on");
    out.text("compiler", lab::compiler(), "what made the program");

    // Errors and rates, which no other machine changes.
    bool nearer = true;
    for (const auto& [id, points] : all)
        if (!id.ends_with("_fast"))
            nearer = nearer && at(points, magnus, rate).error <= std::max(at(points, "remainder_2", rate).error, 1e-9);
    out.check("magnus_nearer", nearer,
              "at 60 Hz, up to 10 rad/s, Magnus and Taylor are nearer than ball and remainder 2");
    bool alike = true;  // up to 10 rad/s, of box and nearly symmetric body
    for (const char* id : {"near_slow", "near_game", "box_slow", "box_game"}) {
        const double ratio = at(all[id], "cayley", rate).error / at(all[id], "half_step", rate).error;
        alike = alike && ratio > 0.9 && ratio < 1.15;
    }
    out.check("cayley_alike", alike,
              "at 60 Hz, up to 10 rad/s, box and nearly symmetric body: Cayley's error is that of "
              "the half-step "
              "Jacobian, within 15 %");
    const double of_needle =
        at(all["needle_game"], "cayley", rate).error / at(all["needle_game"], "half_step", rate).error;
    out.check("cayley_needle", of_needle > 2,
              "needle, 10 rad/s, 60 Hz: Cayley's error is more than twice the half-step Jacobian's");
    out.number("cayley_price", ns.at("cayley") / ns.at("half_step"), "",
               "time of a step of Cayley over that of the half-step Jacobian", 2);
    bool alone = true, thrice = true;
    for (const Shape& shape : shapes) {
        const Points& fast = all[std::string(shape.id) + "_fast"];
        for (const char* k : {"implicit", "passive", "half_step", "cayley", "strang", "runge_kutta_4"})
            alone = alone && at(fast, k, rate).error > lost;
        alone = alone && at(fast, "remainder_4", rate).error < 0.02;
        if (std::string(shape.id) != "near") alone = alone && at(fast, "remainder_2", rate).error > lost;
    }
    for (const auto& [id, points] : all) {
        const contest::Entry& other = *at(points, "runge_kutta_4", rate).entry;
        for (const Point& p : points)
            if (p.entry->id == "remainder_4" && p.error < 0.1 && p.error > 1e-11)
                thrice = thrice && p.error < other.error(std::lround(3 * p.rate * contest::seconds));
    }
    out.check("fast_alone", alone,
              "100 rad/s at 60 Hz, the figure's throw: ball and remainder 4 is off by less than 2 "
              "% with all three bodies, all others by more than half a radian, but ball and "
              "remainder 2 with the nearly symmetric one");
    out.check("third_of_the_rate", thrice,
              "ball and remainder 4 is nearer than Runge-Kutta 4 at three times its rate, on all "
              "three bodies at all three spins of the figure");
}
