#pragma once
// The chapter's methods, and those of its appendix, as steps of the whole body. They are compiled
// once, in methods.cpp.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <timestep/rigid/inertia.hpp>
#include <timestep/rigid/spin_state.hpp>

using Vector = timestep::Vector3<double>;
using Body = timestep::PrincipalInertia<double>;
using Spin = timestep::SpinState<double>;

// So many steps of h from s. One call takes them all: what the call costs is nothing beside them,
// and the compiler sees the whole loop.
using Steps = std::function<Spin(const Spin& s, double h, long steps)>;

struct Method {
    std::string name;                        // in tables, and in what the program prints
    std::string key;                         // in data files and figures
    int order;                               // it claims; of an engine's rule 0: none
    std::function<Steps(const Body&)> made;  // for a body: what is needed of it, computed once
};

const std::vector<Method>& methods();        // the chapter's line
const std::vector<Method>& others();         // the appendix: first those from books,
const std::vector<Method>& engines();        // then the rules of engines: these
const Method& method(std::string_view key);  // any of them

// What a step takes, orientation and all, in ns, by the method's key; measured once.
const std::map<std::string, double>& step_times();  // step_times.cpp

// The exact motion, in body coordinates.
class Exact {
public:
    Exact(const Body& inertia, const Spin& start);
    Spin operator()(double t) const { return motion_(t); }

private:
    std::function<Spin(double t)> motion_;
};

inline Spin spinning(const Vector& omega) { return {0, timestep::Quaternion<double>::Identity(), omega}; }

// The larger one; and where a value is no number, that stays to be seen as ∞.
inline double larger(double most, double value) { return value <= most ? most : std::isnan(value) ? INFINITY : value; }

using timestep::apart;
