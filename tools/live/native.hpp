#pragma once
// A panel without a page: the same steps, and where they end. Words are carried out in their order:
//
//   ./panel omega_h=1.2 steps=600 grab=0.5,0 drag=0.7,0.1 let_go steps=60 --still picture.svg
//
// It prints the readouts, who has blown up, and a hash of all bits that are drawn; `--controls` alone prints what
// can be set, from where to where.

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "live.hpp"
#include "still.hpp"

// With the word clock=2 each look at the clock is 2 ms after the one before: so what measures ends on the same bits,
// too.
static double live_tick = 0, live_ticks = 0;
double live::clock() {
    if (live_tick > 0) return live_ticks += live_tick;
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

namespace live {

inline int complain(const std::string& what) {
    std::fprintf(stderr, "panel: %s\n", what.c_str());
    return 2;
}

// FNV-1a over the bytes of the commands: the same bits, the same hash.
inline std::uint64_t hash(const Picture& picture) {
    std::uint64_t sum = 14695981039346656037u;
    const auto* bytes = reinterpret_cast<const unsigned char*>(picture.commands());
    for (std::size_t i = 0; i < static_cast<std::size_t>(picture.size()) * sizeof(double); ++i)
        sum = (sum ^ bytes[i]) * 1099511628211u;
    return sum;
}

// The numbers of "0.5,0.1"; false where it is nothing of the kind.
inline bool numbers_in(const std::string& text, double* numbers, int count) {
    const char* at = text.c_str();
    for (int i = 0; i < count; ++i) {
        char* end;
        numbers[i] = std::strtod(at, &end);
        if (end == at || *end != (i + 1 < count ? ',' : '\0') || !std::isfinite(numbers[i])) return false;
        at = end + 1;
    }
    return true;
}

// Carries out one word; returns what is wrong with it, or nothing.
inline std::string carry_out(Panel& panel, const std::string& word) {
    if (word == "let_go") return panel.let_go(), "";
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals), value = equals < word.size() ? word.substr(equals + 1) : "";
    double numbers[2] = {0, 0};
    if (name == "grab" || name == "drag") {
        if (!numbers_in(value, numbers, 2)) return word + ": must be " + name + "=x,y";
        name == "grab" ? void(panel.grab(numbers[0], numbers[1])) : panel.drag(numbers[0], numbers[1]);
        return "";
    }
    if (name == "steps") {
        if (!numbers_in(value, numbers, 1) || numbers[0] != std::floor(numbers[0]) || numbers[0] < 0 ||
            numbers[0] > 1e9)
            return word + ": steps must be a whole number from 0 to 1e9";
        for (long n = std::lround(numbers[0]); n > 0; --n) panel.go_on();
        return "";
    }
    if (name == "clock") {
        if (!numbers_in(value, numbers, 1) || numbers[0] <= 0)
            return word + ": clock must be a number of ms above zero";
        live_tick = numbers[0];
        return "";
    }
    std::string known = "steps, grab, drag, let_go, clock";
    for (Control* control : panel.controls) {
        if (!control) continue;
        known += std::string(", ") + control->name;
        if (name != control->name) continue;
        if (!numbers_in(value, numbers, 1) || numbers[0] < control->least || numbers[0] > control->most) {
            char rule[100];
            std::snprintf(rule, sizeof rule, ": must be a number from %g to %g", control->least, control->most);
            return word + rule;
        }
        panel.set(*control, numbers[0]);
        return "";
    }
    return word + ": is none of " + known;
}

}  // namespace live

int main(int count, char** words) {
    using namespace live;
    static Picture picture;
    Panel& panel = the_panel();
    panel.begin();
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--controls" && count == 2) {
            for (const Control* control : panel.controls)
                if (control) std::printf("%s %.17g %.17g\n", control->name, control->least, control->most);
            return 0;
        }
        if (word != "--still") {
            const std::string wrong = carry_out(panel, word);
            if (!wrong.empty()) return complain(wrong);
        } else if (++i == count) {
            return complain("--still: needs the name of a file");
        } else {
            picture.clear();
            panel.draw(picture);
            if (!write_still(picture, panel, words[i])) return complain(std::string(words[i]) + ": cannot be written");
        }
    }
    picture.clear();
    panel.draw(picture);
    std::printf("%ld steps\n", panel.steps);
    for (const Readout* readout : panel.readouts)
        if (readout && readout->known)
            std::printf("%s: %.17g %s\n", readout->label, readout->value, readout->unit);
        else if (readout)
            std::printf("%s: not yet\n", readout->label);
    for (const Fuse* fuse : panel.fuses)
        if (fuse && fuse->blown_at >= 0) std::printf("%s blew up at step %ld\n", fuse->name, fuse->blown_at);
    if (picture.broken()) std::printf("a place in the picture is no number\n");
    if (picture.full()) std::printf("the picture is too large\n");
    std::printf("bits: %016llx\n", static_cast<unsigned long long>(hash(picture)));
}
