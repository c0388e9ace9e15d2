// A thousand throws of four bodies at 60 Hz: what to take must not hang on one of them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <timestep/rigid/ball_and_remainder.hpp>

#include "random_body.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

constexpr int throws_of_each = 1000, seconds = 2, marks = 30;

// A direction that is off the axis of the middle moment by a hundredth to a ten-thousandth.
Vector near_middle_axis(const Body& inertia, RandomBody& random) {
    int r = 0;
    for (int i = 1; i < 3; ++i)
        if (inertia.ratio[(i + 1) % 3] * inertia.ratio[(i + 2) % 3] > 0) r = i;
    const Vector any = random.direction();
    return (Vector::Unit(r) + std::pow(10, -3 + any.x()) * random.direction()).normalized();
}

// L²/2E: the moment that the body seems to have. About its middle axis, and all the way there, it
// is the middle one.
double seeming_moment(const Body& inertia, const Vector& omega) {
    return inertia.momentum(omega).squaredNorm() / (2 * kinetic_energy(inertia, omega));
}

// A direction that starts far from the middle axis and ends on it, as nearly as numbers can say: on
// either side of it the body turns about another axis.
Vector towards_middle_axis(const Body& inertia) {
    Vector least = Vector::Constant(0.3), most = least;
    int low, high;
    inertia.moments.minCoeff(&low), inertia.moments.maxCoeff(&high);
    least[low] = most[high] = 1;
    const double middle = inertia.moments.sum() - inertia.moments[low] - inertia.moments[high];
    for (int i = 0; i < 60; ++i) {
        const Vector between = (least + most) / 2;
        (seeming_moment(inertia, between) < middle ? least : most) = between;
    }
    return most.normalized();
}

// One body, thrown with one spin in any direction or about its middle axis, and where it then is.
class Throws {
public:
    enum class About { any, middle, nearly_there };
    Throws(const Body& inertia, double spin, About about = About::any) : inertia_(inertia) {
        RandomBody random(3);
        const int count = about == About::nearly_there ? 1 : throws_of_each;
        for (int n = 0; n < count; ++n) {
            const Vector direction = about == About::nearly_there ? towards_middle_axis(inertia)
                                     : about == About::middle     ? near_middle_axis(inertia, random)
                                                                  : random.direction();
            starts_.push_back(spinning(spin * direction));
            const Exact exact(inertia, starts_.back());
            for (int k = 1; k <= marks; ++k) truth_.push_back(exact(double(k * seconds) / marks).q);
        }
    }
    // The largest error of each throw.
    std::vector<double> errors(const std::string& key, int rate = 60) const {
        const Steps steps = method(key).made(inertia_);
        std::vector<double> all;
        auto true_q = truth_.begin();
        for (Spin s : starts_) {
            double worst = 0;
            for (int k = 0; k < marks; ++k) {
                s = steps(s, 1.0 / rate, seconds * rate / marks);
                const double error = apart(s.q, *true_q++);
                if (!(error <= worst)) worst = std::isnan(error) ? 9 : error;
            }
            all.push_back(worst);
        }
        return all;
    }

    const std::vector<Spin>& starts() const { return starts_; }

private:
    Body inertia_;
    std::vector<Spin> starts_;
    std::vector<Quaternion<double>> truth_;
};

struct Errors {
    double worst = 0;  // of all throws
    double wrong = 0;  // % of them that are off by more than 1 %
    double lost = 0;   // % that are off by more than half a radian
};

Errors summed_up(const std::vector<double>& errors) {
    Errors sum;
    for (const double e : errors) {
        sum.worst = std::max(sum.worst, e);
        sum.wrong += (e > 0.01) * 100.0 / throws_of_each;
        sum.lost += (e > 0.5) * 100.0 / throws_of_each;
    }
    return sum;
}

// How close a throw comes to a steady turn about the middle axis, of moments p < r < q: there
// L²/2E is r, at the other two axes p and q. 0 is there, 1 a turn about another axis.
double from_middle(const Body& inertia, const Vector& omega) {
    Vector I = inertia.moments;
    std::sort(I.begin(), I.end());
    const double seeming = seeming_moment(inertia, omega);
    return seeming > I[1] ? (seeming - I[1]) / (I[2] - I[1]) : (I[1] - seeming) / (I[1] - I[0]);
}

std::string in_words(const Errors& e) {
    if (e.worst < 1e-6) return "below 0.0001\u00a0%";
    char text[48];
    if (e.worst > 0.5)
        std::snprintf(text, sizeof text, "%.0f of %d lost", e.lost * throws_of_each / 100, throws_of_each);
    else
        std::snprintf(text, sizeof text, "%.2g\u00a0%%", 100 * e.worst);
    return text;
}

}  // namespace

void throws(const Settings&, lab::Findings& out) {
    out.section("A thousand throws");
    struct Case {
        const char *id, *words;
        Body inertia;
        double spin;
    };
    const Body near(1, 1.02, 0.7), brick = box(12.0, 1.0, 2.0, 3.0), needle(1, 1.01, 0.02),
                                   ruler = box(0.05, 1.0, 0.1, 0.02);
    const Case cases[] = {{"near", "nearly symmetric", near, 10}, {"box", "box", brick, 10},
                          {"needle", "needle", needle, 10},       {"ruler", "ruler", ruler, 10},
                          {"box_30", "box, 30 rad/s", brick, 30}, {"ruler_30", "ruler, 30 rad/s", ruler, 30}};
    std::vector<std::string> columns{"method"};
    std::vector<Throws> thrown;
    for (const Case& c : cases) columns.push_back(c.words), thrown.emplace_back(c.inertia, c.spin);
    auto& table = out.table("throws.tsv", columns);
    std::map<std::string, Errors> all;  // by method and case
    const auto throw_all = [&](const Method& method) {
        std::vector<lab::Cell> row{method.name};
        for (std::size_t i = 0; i < thrown.size(); ++i) {
            const Errors e = summed_up(thrown[i].errors(method.key));
            all[method.key + " " + cases[i].id] = e;
            row.push_back(in_words(e));
        }
        table.row(row);
    };
    for (const Method& method : methods()) throw_all(method);
    throw_all(method("magnus_taylor_4")),
        throw_all(method("implicit_midpoint"));  // of the appendix
    const auto of = [&](const std::string& method, const char* id) { return all[method + " " + id]; };
    bool four = true, half = true, rk4 = true;
    double worst_game = 0, half_worst = 0, rk4_worst = 0;
    for (const char* id : {"near", "box", "needle", "ruler"}) {
        worst_game = std::max(worst_game, of("remainder_4", id).worst);
        half_worst = std::max(half_worst, of("half_step", id).worst);
        rk4_worst = std::max(rk4_worst, of("runge_kutta_4", id).worst);
        rk4 = rk4 && of("runge_kutta_4", id).worst < of("remainder_2", id).worst &&
              of("remainder_4", id).worst < of("runge_kutta_4", id).worst;
    }
    // For about the time of ball and remainder 4: RK4 in three substeps.
    bool usually_farther = true, ruler_nearer = false;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto middle_of = [](std::vector<double> errors) {
            std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
            return errors[errors.size() / 2];
        };
        const std::vector<double> in_three = thrown[i].errors("runge_kutta_4", 180),
                                  in_one = thrown[i].errors("remainder_4");
        std::printf(
            "  %s: worst %.2g and middle %.2g of ball and remainder 4, %.2g and %.2g of RK4 in "
            "three substeps\n",
            cases[i].words, summed_up(in_one).worst, middle_of(in_one), summed_up(in_three).worst, middle_of(in_three));
        usually_farther = usually_farther && middle_of(in_three) > middle_of(in_one);
        if (cases[i].id == std::string("ruler")) ruler_nearer = summed_up(in_three).worst < summed_up(in_one).worst;
    }
    out.check("rk4_in_three", usually_farther && ruler_nearer,
              "10 rad/s at 60 Hz: Runge-Kutta 4 in three substeps has the ruler's worst throw "
              "nearer than ball and remainder 4, "
              "and the middle one of each body's throws farther off");
    four = worst_game < 1e-3, half = half_worst < 0.1;
    const double worst_30 = std::max(of("remainder_4", "box_30").worst, of("remainder_4", "ruler_30").worst);
    const Errors two = of("remainder_2", "ruler");
    bool near_middle = true;  // of the ruler's twenty worst throws
    std::vector<std::pair<double, double>> ruler_throws;
    const std::vector<double> by_2 = thrown[3].errors("remainder_2");
    for (std::size_t n = 0; n < by_2.size(); ++n)
        ruler_throws.push_back({by_2[n], from_middle(ruler, thrown[3].starts()[n].omega)});
    std::sort(ruler_throws.begin(), ruler_throws.end());
    for (std::size_t n = by_2.size() - 20; n < by_2.size(); ++n)
        near_middle = near_middle && ruler_throws[n].second < 0.02;
    // An hour in float: roundings of 13 turns a step add up.
    const RemainderInertia<float> single(box(0.05f, 1.0f, 0.1f, 0.02f));
    SpinState<float> hour{0, Quaternion<float>::Identity(), {10, 20, 20}};
    const auto length = [&] { return ruler.momentum(hour.omega.cast<double>()).norm(); };
    const double at_first = length();
    for (int n = 0; n < 60 * 60 * 60; ++n) hour = ball_and_remainder_4.step(single, hour, 1.0f / 60);
    out.number("float_hour", 100 * std::fabs(length() / at_first - 1), "%",
               "how far |L| is off after an hour of ball and remainder 4 in float", 2);
    const Vector& r = ruler.ratio;  // thrown about the axis y
    const Errors near_100 = summed_up(Throws(near, 100).errors("remainder_4")),
                 box_100 = summed_up(Throws(brick, 100).errors("remainder_4")),
                 ruler_100 = summed_up(Throws(ruler, 100).errors("remainder_4"));
    // About the middle axis, where errors grow fastest.
    double middle_15 = 0;
    for (const Body& body : {near, brick, needle, ruler})
        middle_15 = std::max(middle_15, summed_up(Throws(body, 15, Throws::About::middle).errors("remainder_4")).worst);
    const Throws fast_ruler(ruler, 30, Throws::About::middle);
    const Errors middle_30 = summed_up(fast_ruler.errors("remainder_4")),
                 middle_half = summed_up(fast_ruler.errors("remainder_4", 120));
    std::printf(
        "  of %d throws of a ruler at 10 rad/s, 60 Hz, ball and remainder 2 is off\n"
        "  by more than 1 %% in %.0f %%, ball and remainder 4 by %.2g %% at most;\n"
        "  at 30 rad/s by %.2g %%, and at 100 rad/s it loses %.0f %% of them\n",
        throws_of_each, two.wrong, 100 * of("remainder_4", "ruler").worst, 100 * worst_30, ruler_100.lost);
    out.number("throws", throws_of_each, "", "throws of each body");
    out.text("ruler", "a box of 1 × 0.1 × 0.02 m", "the fourth body");
    out.number("worst_game", 100 * worst_game, "%",
               "worst error of ball and remainder 4 in all throws at 10 rad/s, 60 Hz", 2);
    out.number("middle_15", 100 * middle_15, "%", "its worst error about the intermediate axis at 15 rad/s", 2);
    out.number("middle_30", middle_30.wrong, "%",
               "of the ruler's throws about the intermediate axis off by 1 % at 30 rad/s", 2);
    out.number("middle_30_lost", middle_30.lost, "%", "and lost", 2);
    out.number("middle_half", 100 * middle_half.worst, "%", "the worst of them at 120 Hz", 2);
    out.check("middle_15", middle_15 < 1e-3,
              "15 rad/s at 60 Hz, four bodies thrown about their intermediate axis: ball and remainder 4 "
              "is off by less than 0.1 %");
    const double never = Throws(ruler, 15, Throws::About::nearly_there).errors("remainder_4").front();
    out.check("nearly_there", never > 0.5,
              "15 rad/s at 60 Hz: the ruler's throw that ends on its intermediate axis is lost "
              "within two seconds");
    out.check("middle_30", middle_30.wrong > 50 && middle_30.lost > 5 && middle_half.worst < 0.01,
              "30 rad/s at 60 Hz: of the ruler's throws about its intermediate axis it has most off by "
              "more than 1 %, and loses some; at 120 Hz all are right to 1 %");
    out.number("worst_30", 100 * worst_30, "%", "its worst error at 30 rad/s", 2);
    out.number("box_100", box_100.wrong, "%", "of the box's throws off by 1 % at 100 rad/s", 2);
    out.number("ruler_100", ruler_100.wrong, "%", "of the ruler's throws off by 1 % there", 2);
    out.number("box_wrong", of("remainder_2", "box").wrong, "%",
               "of the box's throws that ball and remainder 2 has off by more than 1 %", 2);
    out.number("ruler_wrong", two.wrong, "%", "of the ruler's throws", 2);
    out.number("ruler_rate", std::sqrt(r.x() * r.z()), "",
               "the rate at which a ruler leaves its intermediate axis, over |omega|", 2);
    out.number("half_worst", 100 * half_worst, "%", "worst error of the half-step Jacobian", 2);
    double calm_worst = 0;
    for (const char* id : {"near", "box", "needle", "ruler"}) calm_worst = std::max(calm_worst, of("calm", id).worst);
    out.number("calm_worst", 100 * calm_worst, "%", "of the calm half-step", 2);
    out.number("rk4_worst", 100 * rk4_worst, "%", "worst error of Runge-Kutta 4", 2);
    out.number("rk4_ruler_30", 100 * of("runge_kutta_4", "ruler_30").worst, "%", "that of the ruler at 30 rad/s", 2);
    out.check("rk4_enough", rk4_worst < 1e-3,
              "10 rad/s at 60 Hz, every throw of four bodies: Runge-Kutta 4 is off by less than 0.1 %");
    out.number("ruler_cayley", of("cayley", "ruler").lost, "%", "of the ruler's throws that Cayley has lost", 2);
    out.number("ruler_strang", of("strang", "ruler").lost, "%", "that Strang has lost", 2);
    out.check("take_remainder_4", four,
              "10 rad/s at 60 Hz, every throw of four bodies: ball and remainder 4 is off by less "
              "than 0.1 %");
    out.check("worst_30", worst_30 < 0.05,
              "30 rad/s at 60 Hz, every throw of box and ruler: ball and remainder 4 is off by "
              "less than 5 %");
    out.check("fast_remainder_4", near_100.worst < 1e-3 && box_100.wrong > 1 && ruler_100.wrong > 50,
              "100 rad/s at 60 Hz: ball and remainder 4 has every throw of the nearly symmetric "
              "body, misses some of the box by more than 1 %, and most of the ruler");
    out.check("take_remainder_2",
              of("remainder_2", "near").worst < 1e-3 && of("remainder_2", "box").wrong < 5 && two.wrong > 20 &&
                  two.worst > 0.5,
              "10 rad/s at 60 Hz: ball and remainder 2 is off by less than 0.1 % in every throw of "
              "the nearly symmetric body, by more than 1 % in less than 5 % of the box's, in more "
              "than 20 % of the ruler's, and loses one");
    out.check("near_middle", near_middle,
              "the ruler's twenty worst throws by ball and remainder 2 come to within 2 % of a "
              "turn about its intermediate axis");
    out.check("take_half_step", half,
              "10 rad/s at 60 Hz, every throw of four bodies: the half-step Jacobian with the mean "
              "is off by less than 10 %");
    bool talk = true;
    for (const char* id : {"box", "needle", "ruler"})
        talk = talk && of("implicit", id).lost > 80 && of("passive", id).lost > 80;
    out.check("take_talk", talk,
              "10 rad/s at 60 Hz: one Newton step and passive lose more than four in five throws of "
              "box, needle and ruler");
    out.check("half_step_30", of("half_step", "box_30").lost > 99.95 && of("half_step", "ruler_30").lost > 99.95,
              "30 rad/s at 60 Hz: the half-step Jacobian loses every throw of box and ruler");
    out.check("take_cayley", of("cayley", "ruler").lost > 50 && of("strang", "ruler").lost > 20,
              "10 rad/s at 60 Hz: Cayley loses most throws of the ruler, Strang over 20 %");
    bool no_nearer = true;  // though it keeps energy and momentum
    for (const char* id : {"near", "box", "needle", "ruler"})
        no_nearer = no_nearer && of("implicit_midpoint", id).worst > 0.9 * of("half_step", id).worst &&
                    std::fabs(of("calm", id).worst / of("implicit_midpoint", id).worst - 1) < 0.1;
    out.number("midpoint_error", 100 * of("implicit_midpoint", "box").worst, "%",
               "implicit midpoint: the worst of the box's throws", 2);
    out.number("half_step_error", 100 * of("half_step", "box").worst, "%",
               "the half-step Jacobian: the worst of the box's throws", 2);
    out.check("midpoint_no_nearer", no_nearer,
              "10 rad/s at 60 Hz: the worst throw of each body is no nearer by implicit midpoint "
              "than by the half-step Jacobian, and by the calm half-step within a tenth of it");
    out.number("ruler_2_30", of("remainder_2", "ruler_30").lost, "%",
               "of the ruler's throws that ball and remainder 2 loses at 30 rad/s", 2);
    out.number("ruler_magnus_30", of("magnus_taylor_4", "ruler_30").lost, "%",
               "that Magnus and Taylor lose at 30 rad/s", 2);
    out.check("magnus_lost",
              of("magnus_taylor_4", "needle").worst > of("remainder_2", "needle").worst &&
                  of("magnus_taylor_4", "ruler_30").lost > 2 * of("remainder_2", "ruler_30").lost,
              "60 Hz: at 10 rad/s the worst throw of the needle by Magnus and Taylor is farther off "
              "than by ball and remainder 2, and at 30 rad/s they lose more than twice as many of "
              "the ruler's");
    out.check("rk4_nearer", rk4,
              "10 rad/s at 60 Hz: the worst throw of each body is nearer by Runge-Kutta 4 than by "
              "ball and remainder 2, and nearest by ball and remainder 4");
}
