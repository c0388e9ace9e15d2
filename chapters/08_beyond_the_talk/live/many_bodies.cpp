// Up to ten thousand boxes that tumble: what each solver costs, whose boxes keep their energy, and
// whose point where they should. still: steps=120 wasm: -msimd128

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/many_bodies.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>
#include <timestep/rigid/tumble.hpp>
#include "live.hpp"

using namespace timestep;

constexpr std::tuple solvers{implicit_gyroscopic,  passive_gyroscopic,   half_step_jacobian,
                             tumble<CalmHalfStep>, ball_and_remainder_4, explicit_gyroscopic};
using Pack = Lanes<float>;  // a number of each of four boxes
constexpr std::size_t lanes = Pack::lanes, most = 10000;
constexpr std::size_t few = 64;  // are followed as they truly move, and timed
constexpr float h = 1.0f / 60;

// One box by itself, its spin in its own axes.
struct One {
    PrincipalInertia<double> inertia{1, 1, 1};
    SpinState<double> now{};
};

// Four boxes of half the edges a, b and c.
struct BoxPack : BodyPack<PrincipalInertia<Pack>> {
    BoxPack(Pack a = 1, Pack b = 1, Pack c = 1)
        : BodyPack{PrincipalInertia<Pack>(b * b + c * c, c * c + a * a, a * a + b * b), Quaternion<Pack>::Identity(),
                   Vector3<Pack>::Zero()} {}
    // Some methods choose their way by the body: they take the boxes one by one.
    template <class Method>
    void step_all(const Method& method) {
        if constexpr (requires { method.step(One{}.inertia, One{}.now, 1.0); })
            for (int i = 0; i < Pack::lanes; ++i) {
                One one = alone(i);
                one.now = method.step(one.inertia, one.now, double(h));
                const Vector3<double> spin = one.now.q * one.now.omega;
                for (int k = 0; k < 4; ++k) q.coeffs()[k].set(i, float(one.now.q.coeffs()[k]));
                for (int k = 0; k < 3; ++k) omega[k].set(i, float(spin[k]));
            }
        else
            step(method, Pack(h));
    }
    One alone(int i) const {
        One one;
        for (int k = 0; k < 4; ++k) one.now.q.coeffs()[k] = q.coeffs()[k][i];
        double I[3];
        for (int k = 0; k < 3; ++k) one.now.omega[k] = omega[k][i], I[k] = inertia.moments[k][i];
        for (int k = 0; k < 3; ++k)  // rounded to float, a plate's may exceed the sum
            I[k] = std::min(I[k], I[(k + 1) % 3] + I[(k + 2) % 3]);
        one.inertia = PrincipalInertia<double>(I[0], I[1], I[2]);
        one.now.omega = one.now.q.conjugate() * one.now.omega;
        return one;
    }
};

// What a solver takes a box, and whether it has blown one up.
struct Price {
    Price(live::Panel* panel, const char* name) : times{panel, name, "× one Newton step", ""}, holds{panel, name} {}
    live::Readout times;  // without the solver's colour, which here is that of a box
    live::Fuse holds;
    double least = 1e9;  // ms a box
};

class ManyBoxes : public live::Panel {
public:
    ManyBoxes() {
        title = "Many bodies in SIMD lanes", aspect = 0.66, aspect_narrow = 1.6;
        frame.not_yet();
        for (Price& price : prices) price.times.not_yet();
    }

    void restart() override {
        seed = 1, angle = spin * h;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            // (In braces: in parentheses a compiler may draw the last number first.)
            BoxPack& box = boxes[i] = BoxPack{random(0.2f, 0.5f), random(0.5f, 0.8f), random(0.8f, 1.3f)};
            box.q = over_its_length(Quaternion<Pack>{random(0.1f, 1), random(-1, 1), random(-1, 1), random(-1, 1)});
            const Vector3<Pack> way{random(-1, 1), random(-1, 1), random(0.1f, 1)};
            box.omega = Pack(static_cast<float>(spin)) * random(0.5f, 1) / sqrt(way.squaredNorm()) * way;
            at_start[i] = energy(box);
        }
        for (std::size_t i = 0; i < few; ++i) truth[i] = boxes[i / lanes].alone(static_cast<int>(i % lanes));
        shown = 0;
        look();
    }

    void step() override {
        advance(solver, boxes.data(), (size() + lanes - 1) / lanes);
        // As good as exact: chapter 8's best method, with an eighth of the step.
        for (One& one : truth)
            for (int part = 0; part < 8; ++part)
                one.now = ball_and_remainder_4.step(one.inertia, one.now, double(h) / 8);
        look();
        if (steps % 4 == 0) measure(static_cast<std::size_t>(steps / 4) % prices.size());
    }

    void draw(live::Picture& p) const override {
        const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(count.value)));
        const auto wide = static_cast<double>(columns);
        p.window(0, wide, 0, wide, true, 0, p.narrow ? 1 : 0.6, p.narrow ? 0.39 : 0, 1);
        // Of every box its long axis. Those of one colour are one drawing.
        for (const Look each : {right, slower, faster}) {
            p.ink(name(each), (size() < 500 ? 3 : 1) * (each == right ? 1 : 1.5)), p.move(0, 0);
            for (std::size_t i = 0; i < size(); ++i) {
                if (!alive(i) || look_of(i) != each) continue;
                const Quaternion<float> q = orientation(i);
                const double x = static_cast<double>(i % columns) + 0.5,
                             y = wide - static_cast<double>(i / columns) - 0.5;
                const double to_x = q.x() * q.z() + q.w() * q.y(), to_y = q.y() * q.z() - q.w() * q.x();
                p.move(x - 0.9 * to_x, y - 0.9 * to_y), p.line(x + 0.9 * to_x, y + 0.9 * to_y);
            }
            p.stroke();
        }
        // Beside it, or below it, where it truly is.
        p.narrow ? p.window(-1.2, 1.2, -1.5, 1.4, true, 0, 0.5, 0, 0.39)
                 : p.window(-1.2, 1.2, -1.5, 1.4, true, 0.6, 1, 0.5, 1);
        if (alive(shown))
            draw_large(p, orientation(shown), name(look_of(shown)));
        else
            p.ink("ink"), p.text(-1.15, 0, "these blew up: Restart");
        p.ink("ink"), p.text(-1.15, 1.2, !alive(shown) ? "" : "energy farthest off");
        p.ink(name(slower)), p.text(-1.15, -1.2, "blue: lost 10 %");
        p.ink(name(faster)), p.text(-1.15, -1.45, "orange: gained 10 %");
        p.narrow ? p.window(-1.2, 1.2, -1.5, 1.4, true, 0.5, 1, 0, 0.39)
                 : p.window(-1.2, 1.2, -1.5, 1.4, true, 0.6, 1, 0, 0.5);
        draw_large(p, truth[shown].now.q.cast<float>(), "exact");
        p.ink("ink"), p.text(-1.15, 1.2, "that one in truth");
    }

private:
    enum Look { right, slower, faster };
    static const char* name(Look look) { return look == right ? "exact" : look == slower ? "first" : "explicit"; }

    std::size_t size() const { return static_cast<std::size_t>(count); }
    std::size_t followed() const { return std::min(few, size()); }

    // Every number as likely as any other, and the same ones each time.
    Pack random(float least, float largest) {
        Pack all;
        for (std::size_t i = 0; i < lanes; ++i) {
            seed = seed * 1664525u + 1013904223u;
            all.set(static_cast<int>(i), least + (largest - least) * (static_cast<float>(seed >> 8) / 16777216.0f));
        }
        return all;
    }
    // So many packs, by the solver of this number.
    static void advance(int solver, BoxPack* first, std::size_t packs) {
        int i = 0;
        const auto try_one = [&](const auto& each) {
            if (i++ == solver)
                for (std::size_t n = 0; n < packs; ++n) first[n].step_all(each);
        };
        std::apply([&](const auto&... each) { (try_one(each), ...); }, solvers);
    }

    static Pack energy(const BoxPack& pack) {
        const Matrix3<Pack> R = pack.q.toRotationMatrix();
        return kinetic_energy(pack.inertia, in_body(R, pack.omega));
    }
    Quaternion<float> orientation(std::size_t i) const {
        const auto& q = boxes[i / lanes].q;
        const int lane = static_cast<int>(i % lanes);
        return {q.w()[lane], q.x()[lane], q.y()[lane], q.z()[lane]};
    }
    // By half a radian or more: q and −q are the same place.
    bool astray(std::size_t i) const {
        return !alive(i) ||
               std::fabs(orientation(i).cast<double>().dot(truth[i].now.q)) < 0.96891242171064478;  // cos ¼
    }

    float left(std::size_t i) const { return shares[i / lanes][static_cast<int>(i % lanes)]; }  // of its energy
    bool alive(std::size_t i) const { return left(i) < 1000; }                                  // no NaN is
    Look look_of(std::size_t i) const { return left(i) < 0.9f ? slower : left(i) > 1.1f ? faster : right; }

    void look() {
        double living = 0, sum = 0, lost = 0, won = 0;
        for (std::size_t i = 0; i * lanes < size(); ++i) shares[i] = energy(boxes[i]) / at_start[i];
        for (std::size_t i = 0; i < size(); ++i) {
            if (!alive(i)) continue;
            living += 1, sum += left(i), lost += look_of(i) == slower, won += look_of(i) == faster;
        }
        prices[static_cast<std::size_t>(solver)].holds.holds(living >= size());
        if (living > 0)
            mean = 100 * sum / living;
        else
            mean.not_yet();
        slowed = 100.0 * lost / size(), sped = 100.0 * won / size(), gone = static_cast<double>(size() - living);
        double off = 0;
        for (std::size_t i = 0; i < followed(); ++i) off += astray(i);
        elsewhere = 100 * off / static_cast<double>(followed());
        if (steps % 30 == 0 || !alive(shown)) shown = worst();
    }
    std::size_t worst() const {
        std::size_t found = 0;
        for (std::size_t i = 0; i < followed(); ++i)
            if (alive(i) && (!alive(found) || std::fabs(left(i) - 1) > std::fabs(left(found) - 1))) found = i;
        return found;
    }

    // What each solver costs, whichever is chosen: in turns, a few boxes, many steps. What else a
    // machine does makes a time longer, never shorter: so the least of each counts, and we tell how
    // they compare: to a twentieth, or, where they are far apart, to a whole.
    void measure(std::size_t which) {
        std::copy_n(boxes.begin(), apart.size(), apart.begin());
        const int rounds = which == 3 || which == 4 ? 100 : 6400;  // who goes one by one takes longer
        const double begin = live::clock();
        for (int n = 0; n < rounds; ++n) advance(static_cast<int>(which), apart.data(), apart.size());
        double& least = prices[which].least;
        least = std::fmin(least, (live::clock() - begin) / (rounds * few));
        if (steps < 240) return;  // a browser compiles what runs often once more
        for (Price& price : prices) {
            const double times = price.least / prices[0].least, parts = times < 10 ? 20 : 1;
            price.times = std::floor(parts * times + 0.5) / parts;
        }
        frame = prices[static_cast<std::size_t>(solver)].least * count;
    }

    // The faces that we see, of a box of its moments: b² + c², c² + a² and a² + b².
    void draw_large(live::Picture& p, const Quaternion<float>& q, const char* paint) const {
        const Matrix3<float> R = q.toRotationMatrix();
        const Vector3<Pack>& I = boxes[shown / lanes].inertia.moments;
        const int lane = static_cast<int>(shown % lanes);
        const float sum = (I[0][lane] + I[1][lane] + I[2][lane]) / 2;
        Matrix3<float> edges;  // from the centre to three faces
        for (int k = 0; k < 3; ++k) edges.col(k) = std::sqrt((sum - I[k][lane]) / sum) * R.col(k);
        for (int k = 0; k < 3; ++k) {
            const float sign = R(2, k) < 0 ? -1 : 1;
            const Vector3<float> face = sign * edges.col(k), u = edges.col((k + 1) % 3), v = edges.col((k + 2) % 3);
            const Vector3<float> corners[] = {face + u + v, face + u - v, face - u - v, face - u + v, face + u + v};
            for (const bool filled : {true, false}) {
                filled ? p.ink(paint, 1, 0.2 + 0.6 * std::fabs(R(2, k))) : p.ink("ink", 1.5);
                for (const auto& at : corners) &at == corners ? p.move(at.x(), at.y()) : p.line(at.x(), at.y());
                filled ? p.fill() : p.stroke();
            }
        }
    }

    live::Choice solver{this, "solver", "solver",
                        "one Newton step|passive|half-step Jacobian|calm half-step|ball and remainder 4|explicit"};
    live::LogSlider count{this, "count", "boxes", 16, most, 2500};
    live::Slider spin{this, "spin", "fastest spin", 1, 60, 0.5, 15, "rad/s"};
    live::Readout angle{this, "a step turns", "rad at most, at the start"};
    live::Readout frame{this, "stepping all boxes", "ms a frame, at best"};
    live::Readout mean{this, "mean energy", "% of the start"};
    live::Readout slowed{this, "have lost a tenth", "% of all"}, sped{this, "have gained a tenth", "% of all"};
    live::Readout gone{this, "have blown up", "of them"};
    live::Readout elsewhere{this, "off by half a radian", "% of the first 64"};
    std::array<Price, std::tuple_size_v<decltype(solvers)>> prices =
        std::apply([this](const auto&... each) { return std::array{Price(this, each.name)...}; }, solvers);

    std::array<BoxPack, most / lanes> boxes;
    std::array<BoxPack, few / lanes> apart;
    std::array<One, few> truth;
    std::array<Pack, most / lanes> at_start{}, shares{};
    std::uint32_t seed = 1;
    std::size_t shown = 0;
};
LIVE_PANEL(ManyBoxes)
