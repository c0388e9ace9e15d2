// Tangent and chord, and how far the chord's slope is off, for steps h over sixteen decades. The
// step sweeps by itself until the reader takes it. The function has neither sine nor root: all bits
// are those of the shell. still: h=0.42 steps=0

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <timestep/differences.hpp>

#include "live.hpp"

using namespace timestep;

struct Bell {
    template <class Real>
    Real operator()(Real t) const {
        return 1 / (1 + t * t);
    }
};

// By hand: f′ to compare with, the others for the prediction.
double slope(double t) { return -2 * t / ((1 + t * t) * (1 + t * t)); }
double second(double t) { return (6 * t * t - 2) / ((1 + t * t) * (1 + t * t) * (1 + t * t)); }
double third(double t) {
    const double q = 1 + t * t;
    return 24 * t * (1 - t * t) / (q * q * q * q);
}
double fifth(double t) {
    const double q = 1 + t * t;
    return -240 * t * (3 - 10 * t * t + 3 * t * t * t * t) / (q * q * q * q * q * q);
}

class TangentAndChord : public live::Panel {
public:
    TangentAndChord() {
        title = "Tangent and chord of a curve, and the error of the chord's slope against the step";
        aspect = 0.68, aspect_narrow = 1.35;
        sweep[0] = 1;
        for (std::size_t i = 1; i < sweep.size(); ++i) sweep[i] = sweep[i - 1] / 1.1547819846894582;  // 16 a decade
    }

    void restart() override { h.value = sweep[place = 5], back = false; }
    double seconds() const override { return 1.0 / 30; }
    bool restarts(const live::Control&) const override { return false; }
    bool moves(const live::Control& c) const override { return &c == &h; }

    // Down to 1e-16 and up again, from where the reader has left it.
    void step() override {
        if (h != sweep[place])
            for (place = 0; place + 1 < sweep.size() && sweep[place + 1] >= h;) ++place;
        back = place == 0 ? false : place + 1 == sweep.size() ? true : back;
        h.value = sweep[back ? --place : ++place];
    }

    void draw(live::Picture& p) const override {
        draw_curve(p);
        draw_magnified(p);
        draw_errors(p);
        forward_off = error(forward, h), central_off = error(central, h);
        found = difference(formula, h), exact = slope(at());
    }

    // The point can be dragged along the curve, and so can the chord's end, which sets h.
    bool grab(double x, double y) override {
        const auto near = [&](double at) { return std::fabs(x - at) < 0.4 && std::fabs(y - bell(at)) < 0.4; };
        end_is_held = h > 0.15 && x > t + h / 2 && near(t + h);
        return end_is_held || near(t);
    }
    void drag(double x, double) override { end_is_held ? set(h, x - t) : set(t, x); }
    bool handle(double& x, double& y) const override { return x = t, y = bell(t.value), true; }

private:
    enum { forward, central };

    // In the reader's precision. The point is a number of that precision, too.
    double at() const { return in_float ? static_cast<double>(static_cast<float>(t)) : t; }
    template <class Real>
    double difference(int of, Real x, Real step) const {
        return of == forward ? forward_difference(bell, x, step) : central_difference(bell, x, step);
    }
    double difference(int of, double step) const {
        return in_float ? difference(of, static_cast<float>(t), static_cast<float>(step))
                        : difference(of, t.value, step);
    }
    double error(int of, double step) const { return std::fabs(difference(of, step) - slope(at())); }
    // Roundoff has its luck: at one place the error dips, at the next it does not. Of 21 places
    // close by, the middle one.
    template <class Real>
    double usual_error(int of, double step) const {
        std::array<double, 21> all{};
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Real x = static_cast<Real>(t + 1e-5 * (static_cast<double>(i) - 10));
            all[i] = std::fabs(static_cast<double>(difference(of, x, static_cast<Real>(step))) -
                               slope(static_cast<double>(x)));
        }
        std::nth_element(all.begin(), all.begin() + 10, all.end());
        return all[10];
    }
    double usual_error(int of, double step) const {
        return in_float ? usual_error<float>(of, step) : usual_error<double>(of, step);
    }
    template <class Real>
    static double rise(double t, double step) {  // of the curve, from t to t + step
        const Real x = static_cast<Real>(t), next = x + static_cast<Real>(step);
        return static_cast<double>(bell(next)) - static_cast<double>(bell(x));
    }
    double rise(double step) const { return in_float ? rise<float>(t, step) : rise<double>(t, step); }
    const char* name() const { return formula == forward ? forward_difference.name : central_difference.name; }

    // A line through (x, y), from one side of the picture to the other.
    static void line(live::Picture& p, double x, double y, double slope, double far) {
        p.segment(-far, y + slope * (-far - x), far, y + slope * (far - x));
    }

    void draw_curve(live::Picture& p) const {
        p.window(-2.4, 2.4, -0.5, 1.5, true, 0, p.narrow ? 0.5 : 0.4, p.narrow ? 0.62 : 0.5, 1);
        p.ink("exact", 3, 0.8);
        p.move(-2.4, bell(-2.4));
        for (int i = -47; i <= 48; ++i) p.line(i / 20.0, bell(i / 20.0));
        p.stroke();
        const double from = formula == forward ? t : t - h;
        p.ink("ink", 1.5);
        line(p, t, bell(t.value), slope(t), 2.4);
        p.ink(name(), 2);
        line(p, from, bell(from), difference(formula, h), 2.4);
        p.dot(from, bell(from), 4);
        p.dot(t + h, bell(t + h), 4);
        p.ink("ink");
        p.dot(t, bell(t.value), 6);
        p.text(-2.3, -0.4, "f(t) = 1/(1 + t²)");
    }

    // The same around the point, enlarged until h fills a quarter of the width: x and y are in
    // units of h.
    void draw_magnified(live::Picture& p) const {
        p.window(-2, 2, -2, 2, true, p.narrow ? 0.5 : 0, p.narrow ? 1 : 0.4, p.narrow ? 0.62 : 0, p.narrow ? 1 : 0.5);
        p.ink("exact", 3, 0.8);
        p.move(-2.5, rise(-2.5 * h) / h);
        for (int i = -99; i <= 100; ++i) p.line(i / 40.0, rise(i / 40.0 * h) / h);
        p.stroke();
        const double from = formula == forward ? 0 : -1, y = rise(from * h) / h;
        p.ink("ink", 1.5);
        line(p, 0, 0, slope(at()), 3);
        p.ink(name(), 2);
        line(p, from, y, difference(formula, h), 3);
        p.dot(from, y, 4);
        p.dot(1, rise(h) / h, 4);
        p.ink("ink");
        p.dot(0, 0, 6);
        p.text(-1.9, 1.6, "magnified, 4h wide");
    }

    void draw_errors(live::Picture& p) const {
        p.window(-16.3, 0.3, -13, 2.2, false, p.narrow ? 0 : 0.4, 1, 0, p.narrow ? 0.62 : 1);
        p.axes("step h", "error of the slope", true, true);
        // The second term counts where the first one's derivative is nearly zero: where the curve
        // hardly bends.
        formula == forward ? draw_prediction(p, forward_difference, second(t), std::fabs(third(t)) / 6, 2)
                           : draw_prediction(p, central_difference, third(t), std::fabs(fifth(t)) / 120, 4);
        for (const int of : {1 - formula, static_cast<int>(formula)}) {
            p.ink(of == forward ? forward_difference.name : central_difference.name, 2, of == formula ? 1 : 0.3);
            for (std::size_t i = 0; i < sweep.size(); ++i) {
                const double x = live::log10(sweep[i]), y = decade(usual_error(of, sweep[i]));
                i == 0 ? p.move(x, y) : p.line(x, y);
            }
            p.stroke();
            for (std::size_t i = 0; of == formula && i < sweep.size(); i += 4)
                p.dot(live::log10(sweep[i]), decade(error(of, sweep[i])), 1.5);
            p.dot(live::log10(h), decade(error(of, h)), of == formula ? 6 : 4);
        }
    }
    // The formula's two errors, as the library declares them: the one goes with h^order, the other
    // with 1/h.
    template <class Formula>
    void draw_prediction(live::Picture& p, const Formula&, double next, double more, int more_order) const {
        using std::numeric_limits;
        const double epsilon = in_float ? numeric_limits<float>::epsilon() : numeric_limits<double>::epsilon();
        const double noise = 1.5 * epsilon * bell(at());  // f rounds three times, each time by half an ε at most
        const double term = Formula::error_constant * std::fabs(next) + 1e-20, truncation = live::log10(term);
        const double roundoff = live::log10(Formula::noise_gain * noise);
        p.ink("faint", 1.5);
        for (std::size_t i = sweep.size(); i-- > 0;) {
            const double x = live::log10(sweep[i]), higher = more * power(sweep[i], more_order - Formula::order);
            const double y = live::log10(term + higher) + x * Formula::order;
            i + 1 == sweep.size() ? p.move(x, y) : p.line(x, y);
        }
        p.stroke();
        p.segment(-16.3, roundoff + 16.3, 0.3, roundoff - 0.3);
        p.ink("ink");
        p.text(std::min((-1 - truncation) / Formula::order, 0.0) - 4.8, -1, "truncation");
        p.text(roundoff + 0.2, 0.3, "roundoff");
    }
    static double power(double x, int n) { return n > 0 ? x * power(x, n - 1) : 1; }
    // A slope may be right by chance, to the last digit: that is drawn at the lower edge.
    static double decade(double error) { return live::log10(std::max(error, 1e-13)); }

    static constexpr Bell bell{};
    live::LogSlider h{this, "h", "step h", 1e-16, 1, 0.487};
    live::Slider t{this, "t", "point t", -1.5, 1.5, 0.01, 0.8};
    live::Choice formula{this, "formula", "difference", "forward|central"};
    live::Choice in_float{this, "precision", "numbers", "double|float"};
    // Of the picture as it is drawn. Under the names of the formulas: how far the slope is off.
    mutable live::Readout forward_off{this, forward_difference.name, "off"};
    mutable live::Readout central_off{this, central_difference.name, "off"};
    mutable live::Readout found{this, "slope of the chord"}, exact{this, "of the tangent"};

    std::array<double, 257> sweep{};
    std::size_t place = 0;
    bool back = false, end_is_held = false;
};
LIVE_PANEL(TangentAndChord)
