// Up to ten thousand boxes that tumble in SIMD lanes: what each solver costs, and what it does to the worst of them.
// still: steps=120
// wasm: -msimd128

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/many_bodies.hpp>
#include "live.hpp"

using namespace timestep;

constexpr std::tuple solvers{implicit_gyroscopic, passive_gyroscopic, half_step_jacobian, cayley_gyroscopic,
                             explicit_gyroscopic};
using Pack = Lanes<float>;  // a number of each of four boxes
constexpr std::size_t lanes = Pack::lanes, most = 10000, few = 64;
constexpr float h = 1.0f / 60;

// Four boxes of half the edges a, b and c.
struct BoxPack : BodyPack<PrincipalInertia<Pack>> {
    BoxPack(Pack a = 1, Pack b = 1, Pack c = 1)
        : BodyPack{PrincipalInertia<Pack>(b * b + c * c, c * c + a * a, a * a + b * b), Quaternion<Pack>::Identity(),
                   Vector3<Pack>::Zero()} {}
};

// What a solver takes a box, and whether it has blown one up.
struct Price {
    Price(live::Panel* panel, const char* name) : times{panel, name, "× one Newton step", ""}, holds{panel, name} {}
    live::Readout times;  // without the solver's colour, which here is that of a box
    live::Fuse holds;
    double least = 1e9;  // ms
};

class ManyBoxes : public live::Panel {
public:
    ManyBoxes() {
        title = "Many bodies in SIMD lanes", aspect = 0.66, aspect_narrow = 1.6;
        frame.not_yet();
        for (Price& price : prices) price.times.not_yet();
    }

    void restart() override {
        seed = 1;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            // (In braces: in parentheses a compiler may draw the last number first.)
            BoxPack& box = boxes[i] = BoxPack{random(0.2f, 0.5f), random(0.5f, 0.8f), random(0.8f, 1.3f)};
            box.q = over_its_length(Quaternion<Pack>{random(0.1f, 1), random(-1, 1), random(-1, 1), random(-1, 1)});
            const Vector3<Pack> way{random(-1, 1), random(-1, 1), random(0.1f, 1)};
            box.omega = Pack(static_cast<float>(spin)) * random(0.5f, 1) / sqrt(way.squaredNorm()) * way;
            at_start[i] = energy(box);
            thrown[i] = stacked(RigidState<Pack>{Pack(0), box.q, box.omega});
        }
        show(0);
        look();
    }

    void step() override {
        advance(solver, boxes.data(), (size() + lanes - 1) / lanes);
        look();
        follow_truth();
        if (steps % 4 == 0) measure(static_cast<int>(steps / 4 % 5));
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
                const double x = static_cast<double>(i % columns) + 0.5, y = wide - static_cast<double>(i / columns) - 0.5;
                const double to_x = q.x() * q.z() + q.w() * q.y(), to_y = q.y() * q.z() - q.w() * q.x();
                p.move(x - 0.9 * to_x, y - 0.9 * to_y), p.line(x + 0.9 * to_x, y + 0.9 * to_y);
            }
            p.stroke();
        }
        // Beside it, or below it, where it truly is.
        p.narrow ? p.window(-1.2, 1.2, -1.5, 1.4, true, 0, 0.5, 0, 0.39) : p.window(-1.2, 1.2, -1.5, 1.4, true, 0.6, 1, 0.5, 1);
        if (alive(shown)) draw_large(p, orientation(shown), name(look_of(shown)));
        else p.ink("ink"), p.text(-1.15, 0, "all have blown up: Restart");
        p.ink("ink"), p.text(-1.15, 1.2, !alive(shown) ? "" : "the worst of them");
        p.ink(name(slower)), p.text(-1.15, -1.2, "blue: lost 10 %");
        p.ink(name(faster)), p.text(-1.15, -1.45, "orange: gained 10 %");
        p.narrow ? p.window(-1.2, 1.2, -1.5, 1.4, true, 0.5, 1, 0, 0.39) : p.window(-1.2, 1.2, -1.5, 1.4, true, 0.6, 1, 0, 0.5);
        if (true_steps >= steps) draw_large(p, orientation(true_one.y.head<4>(), shown), "exact");
        p.ink("ink"), p.text(-1.15, 1.2, "that one in truth");
    }

private:
    enum Look { right, slower, faster };
    static const char* name(Look look) { return look == right ? "exact" : look == slower ? "first" : "explicit"; }

    std::size_t size() const { return static_cast<std::size_t>(count); }

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
                for (std::size_t n = 0; n < packs; ++n) first[n].step(each, Pack(h));
        };
        std::apply([&](const auto&... each) { (try_one(each), ...); }, solvers);
    }

    static Pack energy(const BoxPack& pack) {
        const Matrix3<Pack> R = pack.q.toRotationMatrix();
        return kinetic_energy(pack.inertia, in_body(R, pack.omega));
    }
    static Quaternion<float> orientation(const Eigen::Matrix<Pack, 4, 1>& q, std::size_t i) {  // x, y, z, w
        const int lane = static_cast<int>(i % lanes);
        return {q[3][lane], q[0][lane], q[1][lane], q[2][lane]};
    }
    Quaternion<float> orientation(std::size_t i) const { return orientation(boxes[i / lanes].q.coeffs(), i); }

    void show(std::size_t which) { shown = which, true_one = thrown[which / lanes], true_steps = 0; }
    // As good as exact: RK4 with a sixteenth of the step. Whoever is shown anew is followed from its throw on, twenty seconds
    // of it each frame.
    void follow_truth() {
        const FreeBody<PrincipalInertia<Pack>> body(boxes[shown / lanes].inertia);
        for (int n = 0; n < 1200 && true_steps < steps; ++n, ++true_steps)
            for (int part = 0; part < 16; ++part) {
                true_one = runge_kutta_4.step(body, true_one, Pack(h / 16));
                const Eigen::Matrix<Pack, 4, 1> q = true_one.y.head<4>();
                true_one.y.head<4>() = q / sqrt(q.squaredNorm());
            }
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
        mean = living > 0 ? 100 * sum / living : 0;
        slowed = 100.0 * lost / size(), sped = 100.0 * won / size(), gone = static_cast<double>(size() - living);
        const std::size_t now_worst = steps % 30 == 0 || !alive(shown) ? worst() : shown;
        if (now_worst != shown) show(now_worst);
        of_shown = alive(shown) ? 100 * left(shown) : 0;
    }
    std::size_t worst() const {
        std::size_t found = shown;
        for (std::size_t i = 0; i < size(); ++i)
            if (alive(i) && (!alive(found) || std::fabs(left(i) - 1) > std::fabs(left(found) - 1))) found = i;
        return found;
    }

    // What each solver costs, whichever is chosen: in turns, a few boxes, many steps. What else a machine does makes a
    // time longer, never shorter: so the least of each counts, and we tell how they compare, to a twentieth.
    void measure(int which) {
        std::copy_n(boxes.begin(), few, apart.begin());
        const double begin = live::clock();
        for (int n = 0; n < 1600; ++n) advance(which, apart.data(), few);
        double& least = prices[static_cast<std::size_t>(which)].least;
        least = std::fmin(least, live::clock() - begin);
        if (steps < 240) return;  // a browser compiles what runs often once more
        for (Price& price : prices) price.times = std::floor(20 * price.least / prices[0].least + 0.5) / 20;
        frame = prices[static_cast<std::size_t>(solver)].least / (1600 * few * lanes) * count;
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
                        "one Newton step|passive|half-step Jacobian|Cayley|explicit"};
    live::LogSlider count{this, "count", "boxes", 16, most, 2500};
    live::Slider spin{this, "spin", "fastest spin", 1, 60, 0.5, 15, "rad/s"};
    live::Readout frame{this, "all of them", "ms a frame, at best"};
    live::Readout mean{this, "mean energy", "% of the start"};
    live::Readout of_shown{this, "that of the large one", "% of the start"};
    live::Readout slowed{this, "have lost a tenth", "% of all"}, sped{this, "have gained a tenth", "% of all"};
    live::Readout gone{this, "have blown up", "of them"};
    std::array<Price, std::tuple_size_v<decltype(solvers)>> prices = std::apply(
        [this](const auto&... each) { return std::array{Price(this, each.name)...}; }, solvers);

    std::array<BoxPack, most / lanes> boxes;
    std::array<BoxPack, few> apart;
    using Turning = FirstOrder<Eigen::Matrix<Pack, 7, 1>>;
    std::array<Turning, most / lanes> thrown;
    Turning true_one{};
    long true_steps = 0;  // so far it is followed
    std::array<Pack, most / lanes> at_start{}, shares{};
    std::uint32_t seed = 1;
    std::size_t shown = 0;
};
LIVE_PANEL(ManyBoxes)
