#pragma once
// Every method on inputs that no game should have: the cells of a table, each with what theory
// expects and what the run finds. The chapter's program counts them, and a test checks every one.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <timestep/run.hpp>

namespace extremes {

using namespace timestep;

enum class Outcome {
    refused,           // std::invalid_argument, with one line that says why
    does_not_compile,  // the method has nothing to hand to such a force
    exact,             // the exact answer, but for roundoff
    bounded,           // finite, and never larger than theory allows
    grows,             // finite, and as much larger as theory says
    reported,          // too large for a number, no later than theory says, and the run says when
    wrong              // none of these
};

inline const char* words(Outcome word) {
    const char* all[] = {"refused", "does not compile", "exact", "bounded", "grows", "not finite, reported", "wrong"};
    return all[static_cast<int>(word)];
}

struct Cell {
    std::string real, scene, method;
    Outcome expected, found;
    std::string note;  // the message, or the step at which the run blew up
};

template <class Real>
inline constexpr bool is_float = sizeof(Real) == sizeof(float);
// Near the smallest and the largest number that a Real can hold; and one whose square is still a
// number.
template <class Real>
inline constexpr Real tiny = is_float<Real> ? Real(1e-36) : Real(1e-300);
template <class Real>
inline constexpr Real huge = 1 / tiny<Real>;
template <class Real>
inline constexpr Real stiff = is_float<Real> ? Real(1e16) : Real(1e150);
template <class Real>
inline constexpr double eps = std::numeric_limits<Real>::epsilon();

// What theory says of a run.
struct Theory {
    Outcome expected;
    double size = 1;         // bounded: never larger. exact: no farther from it
    double log_growth = 0;   // grows: by e to this
    double latest = 0;       // reported: at this step or before
    const char* named = "";  // refused: what the message says is bad, as in "step = 0: must be …"
    double last_size = std::numeric_limits<double>::infinity();  // bounded: at the end, at the most
    double earliest = 1;                                         // reported: not before this step
};

inline Theory refused(const char* named) { return {Outcome::refused, 1, 0, 0, named}; }

// The larger of the two; a NaN is larger than any number, for there must be none.
inline double larger(double a, double b) { return a < b || std::isnan(b) ? b : a; }

// The word for a run that came to an end with `size`, from `first` on; `largest` on the way.
inline Outcome judge(const Theory& theory, double first, double largest, double last, long blew_up_at) {
    if (blew_up_at > 0)
        return theory.expected == Outcome::reported && blew_up_at >= theory.earliest && blew_up_at <= theory.latest
                   ? Outcome::reported
                   : Outcome::wrong;
    if (theory.expected == Outcome::bounded)
        return largest <= theory.size && last <= theory.last_size ? Outcome::bounded : Outcome::wrong;
    if (theory.expected == Outcome::exact) return last <= theory.size ? Outcome::exact : Outcome::wrong;
    // What is no eigenvector makes up to a factor 8 of difference once, and roundoff 1 % of the
    // exponent.
    const double off = std::log(last) - std::log(first) - theory.log_growth;
    return theory.expected == Outcome::grows && theory.log_growth > 4 &&
                   std::fabs(off) < std::log(8) + 0.01 * theory.log_growth
               ? Outcome::grows
               : Outcome::wrong;
}

template <class Model>
using Make = std::function<Model()>;  // or throws
template <class S>
using Size = std::function<double(const S&)>;  // of a state; in exact cells its distance from the right one

// Does the message begin with what is bad?
inline bool names(const std::string& message, const std::string& named) {
    return !named.empty() && (message.rfind(named + " = ", 0) == 0 || message.rfind(named + ": ", 0) == 0);
}

// Makes the model, runs it, and finds the word.
template <class Model, class Method, class S>
Cell cell(const char* scene, const Method& method, const Make<Model>& make, const S& start, real_of<S> h, long steps,
          const Theory& theory, const std::type_identity_t<Size<S>>& size) {
    Cell cell{is_float<real_of<S>> ? "float" : "double", scene, method.name, theory.expected, Outcome::wrong, ""};
    try {
        const Model model = make();
        double largest = 0;
        long finite_states = 0;
        const S end = run(method, model, start, h, steps, [&](const S& s) {
            largest = larger(largest, size(s));
            finite_states += is_finite(s);
        });
        // One look at the end finds whatever went wrong on the way: so it must be, in every cell.
        const bool blew_up = !is_finite(end);
        if (blew_up == (finite_states == steps + 1)) return cell;
        const long blew_up_at = blew_up ? finite_states : 0;  // the start is one of them
        cell.found = judge(theory, size(start), largest, size(end), blew_up_at);
        cell.note = blew_up ? "at step " + std::to_string(blew_up_at) : "";
    } catch (const std::invalid_argument& refusal) {
        cell.note = refusal.what();
        const bool one_line = cell.note.find('\n') == std::string::npos;
        cell.found = one_line && names(cell.note, theory.named) ? Outcome::refused : Outcome::wrong;
    }
    return cell;
}

// All cells: of every method on every force, and of every gyroscopic solver on every inertia, with
// those of a ball on the ground.
std::vector<Cell> of_methods();
std::vector<Cell> of_bodies();
std::vector<Cell> of_balls();

}  // namespace extremes
