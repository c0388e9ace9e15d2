#pragma once
// Words for a live panel: what a reader can set, how the scene steps, what is drawn. A panel is one short file,
// chapters/NN_name/live/panel.cpp. Compiled to WebAssembly it moves in the page; compiled as any program, by
//
//   c++ -std=c++20 -O1 -Iinclude -Itools/live chapters/03_euler_variants/live/three_eulers.cpp -o panel && ./panel
//
// it takes the same steps and tells where they end. Nothing here allocates: a page that is left open must not grow.

#include <array>
#include <cmath>
#include <cstddef>

#include "colours.hpp"

namespace live {

class Panel;

// ---- What a reader sets, and reads ------------------------------------------------------------------

// Each has a name for links and the shell, in small letters, and a label for the eye.
struct Control {
    enum Kind { slider, log_slider, choice, toggle };
    Kind kind;
    const char* name;
    const char* label;
    const char* unit;  // of a choice its options: "one|another"
    double least, most, step, first;
    double value = first;
};

// A number between two others, in steps; a log slider moves by factors and has three digits.
struct Slider : Control {
    Slider(Panel* panel, const char* name, const char* label, double least, double most, double step, double first,
           const char* unit = "");
    operator double() const { return value; }
};
struct LogSlider : Control {
    LogSlider(Panel* panel, const char* name, const char* label, double least, double most, double first,
              const char* unit = "");
    operator double() const { return value; }
};
// One of several, "explicit|implicit": as a number from 0 on.
struct Choice : Control {
    Choice(Panel* panel, const char* name, const char* label, const char* options, int first = 0);
    operator int() const { return static_cast<int>(value); }
};
struct Toggle : Control {
    Toggle(Panel* panel, const char* name, const char* label, bool first = false);
    operator bool() const { return value != 0; }
};

// A number below the picture. One whose label is a method's name has the method's colour beside it: the picture's key.
// What is no method may name the look that it is drawn in.
struct Readout {
    Readout(Panel* panel, const char* label, const char* unit = "", const char* look = nullptr);
    void operator=(double v) { value = v, known = true; }
    void not_yet() { value = 0, known = false; }  // still being measured, or to come
    const char* label;
    const char* unit;
    const char* look;
    double value = 0;
    bool known = true;
};

// Something that may blow up: what has is said once, "explicit Euler blew up at step 57", and is drawn no more.
struct Fuse {
    Fuse(Panel* panel, const char* name);
    // Still sound? Once it is not, never again until a restart.
    bool holds(bool sound);
    operator bool() const { return blown_at < 0; }
    Panel* panel;
    const char* name;
    long blown_at = -1;  // the step, or -1
};

// ---- The picture ---------------------------------------------------------------------------------------

// Commands for the page, in the units of the scene, y upwards. A method's colour is asked for by its name, and is
// that of the figures; "ink", "soft", "faint", "first" to "fourth" are no method's.
class Picture {
public:
    // The part of the picture that is drawn in from here on, in shares from its lower left corner, and what it
    // shows. With `equal` a metre is as long upwards as sideways: then at least this is shown.
    void window(double left, double right, double bottom, double top, bool equal = false, double from_x = 0,
                double to_x = 1, double from_y = 0, double to_y = 1) {
        put({0, left, right, bottom, top, equal ? 1.0 : 0.0, from_x, to_x, from_y, to_y});
    }
    // With log axes the scene's units are powers of ten.
    void axes(const char* x, const char* y, bool log_x = false, bool log_y = false) {
        put({1, word(x), word(y), log_x ? 1.0 : 0.0, log_y ? 1.0 : 0.0});
    }
    void ink(const char* look, double width = 2, double strength = 1) { put({2, word(look), width, strength}); }
    // Lines, each begun by a move; they are drawn together by one stroke, or filled.
    void move(double x, double y) { put({3, x, y}); }
    void line(double x, double y) { put({4, x, y}); }
    void stroke() { put({5}); }
    void fill() { put({6}); }
    void dot(double x, double y, double radius = 5) { put({7, x, y, radius}); }  // in pixels
    void text(double x, double y, const char* words) { put({8, x, y, word(words)}); }
    // Round, without a sine: the browser's and ours differ in their last bits.
    void circle(double x, double y, double radius) {
        double c = radius, s = 0;
        move(x + c, y + s);
        for (int i = 0; i < 96; ++i) {
            const double turned = 0.99785892323860348 * c - 0.065403129230143062 * s;  // by 2π/96
            s = 0.065403129230143062 * c + 0.99785892323860348 * s, c = turned;
            line(x + c, y + s);
        }
    }
    void segment(double x1, double y1, double x2, double y2) { move(x1, y1), line(x2, y2), stroke(); }

    bool narrow = false;  // on a phone: one part above the other

    void clear() { size_before_ = size_, size_ = words_ = 0, broken_ = full_ = changed_ = false; }
    const double* commands() const { return commands_.data(); }
    int size() const { return static_cast<int>(size_); }
    const char* said(int i) const { return texts_[static_cast<std::size_t>(i)]; }
    bool broken() const { return broken_; }  // a place was no number: nothing of the kind is drawn in silence
    bool full() const { return full_; }
    bool changed() const { return changed_ || size_ != size_before_; }  // is it another one than before it was cleared?

private:
    template <std::size_t n>
    void put(const double (&command)[n]) {
        for (const double number : command) broken_ = broken_ || !std::isfinite(number);
        if (broken_ || size_ + n > commands_.size()) {
            full_ = full_ || !broken_;
            return;
        }
        for (const double number : command) {
            changed_ = changed_ || commands_[size_] != number;
            commands_[size_++] = number;
        }
    }
    double word(const char* text) {
        std::size_t i = 0;
        while (i < words_ && texts_[i] != text) ++i;
        if (i == texts_.size()) return full_ = true, 0;
        if (i == words_) changed_ = changed_ || texts_[i] != text, texts_[words_++] = text;
        return static_cast<double>(i);
    }

    std::array<double, 120'000> commands_{};
    std::array<const char*, 64> texts_{};
    std::size_t size_ = 0, size_before_ = 0, words_ = 0;
    bool broken_ = false, full_ = false, changed_ = false;
};

// The last places of something that moves.
template <std::size_t n>
class Trail {
public:
    void clear() { size_ = 0; }
    void add(double x, double y) { places_[size_++ % n] = {x, y}; }
    void draw(Picture& picture) const {
        const std::size_t first = size_ > n ? size_ - n : 0;
        for (std::size_t i = first; i < size_; ++i) {
            const auto& [x, y] = places_[i % n];
            i == first ? picture.move(x, y) : picture.line(x, y);
        }
        picture.stroke();
    }

private:
    std::array<std::array<double, 2>, n> places_{};
    std::size_t size_ = 0;
};

// A diagram against time, the last twenty seconds. A line that leaves it upwards says so.
template <std::size_t lines>
class Chart {
public:
    Chart(const char* what, double most) : what_(what), most_(most) {}
    void clear() {
        for (Trail<300>& trail : trails_) trail.clear();
        left_at_.fill(-1), next_.fill(0);
    }
    void add(std::size_t i, double t, double y) {
        now_ = t;
        if (t < next_[i]) return;  // as often as can be seen
        next_[i] = t + seconds / 300;
        trails_[i].add(t, y);
        if (y > most_ && left_at_[i] < 0) left_at_[i] = t;
    }
    // With these looks, in this part of the picture; the first of them wide behind the others, if that one is `behind`.
    void draw(Picture& p, const std::array<const char*, lines>& looks, bool behind, double from_x, double to_x,
              double to_y) const {
        const double end = std::fmax(seconds, now_);
        p.window(end - seconds, end, 0, most_, false, from_x, to_x, 0, to_y);
        p.axes("t, s", what_);
        double row = 0.8;
        for (std::size_t i = 0; i < lines; ++i) {
            p.ink(looks[i], behind && i == 0 ? 5 : 2, behind && i == 0 ? 0.6 : 1);
            trails_[i].draw(p);
            if (left_at_[i] < 0) continue;
            p.text(std::fmin(std::fmax(left_at_[i], end - seconds) + 0.4, end - (p.narrow ? 17 : 9)), row * most_,
                   "leaves upwards");
            row -= 0.25;
        }
    }

private:
    static constexpr double seconds = 20;
    const char* what_;
    double most_, now_ = 0;
    std::array<Trail<300>, lines> trails_{};
    std::array<double, lines> left_at_{}, next_{};  // −1: it has not left
};

// The place of x > 0 on a log axis. Of + − × ÷ alone, so it has the same bits in the page and in the shell, as
// std::log10 need not have.
inline double log10(double x) {
    int twos = 0;
    const double root = 0.70710678118654752, part = std::frexp(x, &twos);  // x = part · 2^twos, part from 1/2 to 1
    const double z = (part - root) / (part + root);  // ln(part/root) = 2 (z + z³/3 + z⁵/5 + …)
    double series = 0;
    for (int n = 17; n > 0; n -= 2) series = series * z * z + 1.0 / n;
    return 0.30102999566398120 * (twos - 0.5) + 0.86858896380650366 * z * series;
}

// And back: 10^y, of + − × ÷ alone.
inline double power_of_ten(double y) {
    const double whole = std::floor(y + 0.5), z = 2.3025850929940457 * (y - whole);
    double series = 1;  // e^z = 1 + z (1 + z/2 (1 + z/3 (1 + …)))
    for (int n = 20; n > 0; --n) series = 1 + z / n * series;
    for (double n = whole; n > 0; --n) series *= 10;
    for (double n = whole; n < 0; ++n) series /= 10;
    return series;
}

// ---- The panel -----------------------------------------------------------------------------------------

class Panel {
public:
    virtual ~Panel() = default;

    virtual void restart() = 0;  // to the start, as the controls stand
    virtual void step() = 0;
    virtual void draw(Picture& picture) const = 0;
    virtual double seconds() const { return 1.0 / 60; }           // of the reader's time that a step stands for
    virtual bool restarts(const Control&) const { return true; }  // when the reader changes this one
    // Does the panel move this one by itself? Then it stops when the reader takes it, and goes on from there by Play.
    virtual bool moves(const Control&) const { return false; }
    // A finger: it takes hold of what is near (true: the page does not scroll), drags it, lets go.
    virtual bool grab(double, double) { return false; }
    virtual void drag(double, double) {}
    virtual void let_go() {}
    // Where the arrow keys take hold, if anything can be moved by them.
    virtual bool handle(double&, double&) const { return false; }

    const char* title = "";
    double aspect = 0.6;  // height of the picture over its width
    double aspect_narrow = 0.9;
    long steps = 0;

    std::array<Control*, 16> controls{};
    std::array<Readout*, 16> readouts{};
    std::array<Fuse*, 16> fuses{};

    void begin() {
        steps = 0;
        for (Fuse* fuse : fuses)
            if (fuse) fuse->blown_at = -1;
        restart();
    }
    void go_on() { ++steps, step(); }
    void set(Control& control, double value) {
        control.value = std::fmin(std::fmax(value, control.least), control.most);
        if (control.step >= 1) control.value = std::floor(control.value);  // what is counted is whole
        if (restarts(control)) begin();
    }
};

// The page's clock in ms, for a panel that measures.
double clock();

template <class Part>
void add(std::array<Part*, 16>& parts, Part* part) {
    for (Part*& place : parts)
        if (!place) {
            place = part;
            return;
        }
}
inline Slider::Slider(Panel* panel, const char* name, const char* label, double least, double most, double step,
                      double first, const char* unit)
    : Control{slider, name, label, unit, least, most, step, first} {
    add<Control>(panel->controls, this);
}
inline LogSlider::LogSlider(Panel* panel, const char* name, const char* label, double least, double most, double first,
                            const char* unit)
    : Control{log_slider, name, label, unit, least, most, 0, first} {
    add<Control>(panel->controls, this);
}
inline Choice::Choice(Panel* panel, const char* name, const char* label, const char* options, int first)
    : Control{choice, name, label, options, 0, 0, 1, static_cast<double>(first)} {
    for (const char* c = options; *c; ++c) most += *c == '|';
    add<Control>(panel->controls, this);
}
inline Toggle::Toggle(Panel* panel, const char* name, const char* label, bool first)
    : Control{toggle, name, label, "", 0, 1, 1, first ? 1.0 : 0.0} {
    add<Control>(panel->controls, this);
}
inline Readout::Readout(Panel* panel, const char* label_, const char* unit_, const char* look_)
    : label(label_), unit(unit_), look(look_ ? look_ : label_) {
    add(panel->readouts, this);
}
inline Fuse::Fuse(Panel* panel_, const char* name_) : panel(panel_), name(name_) { add(panel->fuses, this); }
inline bool Fuse::holds(bool sound) {
    if (!sound && blown_at < 0) blown_at = panel->steps;
    return blown_at < 0;
}

Panel& the_panel();

}  // namespace live

// At the end of a panel's file: this is the one.
#define LIVE_PANEL(Type)             \
    live::Panel& live::the_panel() { \
        static Type panel;           \
        return panel;                \
    }

#ifdef __wasm__
#include "module.hpp"
#else
#include "native.hpp"
#endif
