#pragma once
// What the page calls: a panel as a WebAssembly module. docs/theme/live.js is the other side of it.

#include <limits>

#include "live.hpp"

// A module has no words for what cannot go on (tools/cmake/live.cmake): it stops, and the page says so.
extern "C" void __cxa_pure_virtual() { __builtin_trap(); }

extern "C" __attribute__((import_module("page"), import_name("clock"))) double page_clock();
double live::clock() { return page_clock(); }

namespace live {
namespace {

Picture picture;
const Control& control(int i) { return *the_panel().controls[static_cast<std::size_t>(i)]; }
const Readout& readout(int i) { return *the_panel().readouts[static_cast<std::size_t>(i)]; }
const Fuse& fuse(int i) { return *the_panel().fuses[static_cast<std::size_t>(i)]; }
template <class Parts>
int count(const Parts& parts) {
    int n = 0;
    for (const auto* part : parts) n += part != nullptr;
    return n;
}

}  // namespace
}  // namespace live

extern "C" {
#define EXPORTED(name) __attribute__((export_name(#name)))
EXPORTED(title) const char* live_title() { return live::the_panel().title; }
EXPORTED(seconds) double live_seconds() { return live::the_panel().seconds(); }
EXPORTED(aspect) double live_aspect(int narrow) {
    return narrow ? live::the_panel().aspect_narrow : live::the_panel().aspect;
}

EXPORTED(controls) int live_controls() { return live::count(live::the_panel().controls); }
EXPORTED(control_text) const char* live_control_text(int i, int which) {
    const live::Control& c = live::control(i);
    return which == 0 ? c.name : which == 1 ? c.label : c.unit;
}
EXPORTED(control_number) double live_control_number(int i, int which) {
    const live::Control& c = live::control(i);
    const double numbers[] = {static_cast<double>(c.kind), c.least, c.most, c.step, c.first, c.value};
    return numbers[which];
}
EXPORTED(moves) int live_moves(int i) { return live::the_panel().moves(live::control(i)) ? 1 : 0; }
EXPORTED(set) void live_set(int i, double value) {
    live::the_panel().set(*live::the_panel().controls[static_cast<std::size_t>(i)], value);
}

EXPORTED(readouts) int live_readouts() { return live::count(live::the_panel().readouts); }
EXPORTED(readout_text) const char* live_readout_text(int i, int which) {
    const live::Readout& r = live::readout(i);
    if (which > 1 && !live::is_look(r.look)) return "";
    if (which > 1) return which == 2 ? live::look_of(r.look).colour : live::look_of(r.look).dashes;
    return which == 0 ? r.label : r.unit;
}
EXPORTED(readout) double live_readout(int i) { return live::readout(i).value; }
EXPORTED(known) int live_known(int i) { return live::readout(i).known ? 1 : 0; }

EXPORTED(fuses) int live_fuses() { return live::count(live::the_panel().fuses); }
EXPORTED(fuse_text) const char* live_fuse_text(int i) { return live::fuse(i).name; }
EXPORTED(fuse) int live_fuse(int i) { return static_cast<int>(live::fuse(i).blown_at); }

EXPORTED(begin) void live_begin() { live::the_panel().begin(); }
EXPORTED(step) void live_step() { live::the_panel().go_on(); }
EXPORTED(steps) int live_steps() { return static_cast<int>(live::the_panel().steps); }
EXPORTED(grab) int live_grab(double x, double y) { return live::the_panel().grab(x, y); }
EXPORTED(drag) void live_drag(double x, double y) { live::the_panel().drag(x, y); }
EXPORTED(let_go) void live_let_go() { live::the_panel().let_go(); }
EXPORTED(handle) double live_handle(int axis) {
    double place[2] = {0, 0};
    const bool there = live::the_panel().handle(place[0], place[1]);
    return there ? place[axis] : std::numeric_limits<double>::quiet_NaN();
}

EXPORTED(draw) int live_draw(int narrow) {
    live::picture.clear();
    live::picture.narrow = narrow != 0;
    live::the_panel().draw(live::picture);
    return live::picture.size();
}
EXPORTED(changed) int live_changed() { return live::picture.changed() ? 1 : 0; }
EXPORTED(commands) const double* live_commands() { return live::picture.commands(); }
EXPORTED(said) const char* live_said(int i) { return live::picture.said(i); }
// What is said as the name of a look.
EXPORTED(colour) const char* live_colour(int i) { return live::look_of(live::picture.said(i)).colour; }
EXPORTED(dashes) const char* live_dashes(int i) { return live::look_of(live::picture.said(i)).dashes; }
EXPORTED(broken) int live_broken() { return live::picture.broken() ? 1 : live::picture.full() ? 2 : 0; }
#undef EXPORTED
}
