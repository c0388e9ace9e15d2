#include "last_comparison.hpp"

#include <cmath>

#include "numbers.hpp"

namespace checker {

namespace {

struct Sides {
    std::string last, said;
    bool is_new = false;  // since the last call
};
Sides sides;

}  // namespace

bool told(bool holds, const std::string& words) {
    if (!holds) sides.last = words, sides.is_new = true;
    return holds;
}

std::string in_words(double number) { return written(number, Digits::ten); }
std::string in_words(std::complex<double> number) {
    if (number.imag() == 0) return in_words(number.real());
    return in_words(number.real()) + (number.imag() < 0 ? " - " : " + ") + in_words(std::fabs(number.imag())) + "i";
}

bool below(const std::string& what, double found, double limit) {
    return told(found < limit, what + " " + in_words(found) + ", and must be less than " + in_words(limit) + ".");
}
bool above(const std::string& what, double found, double limit) {
    return told(found > limit, what + " " + in_words(found) + ", and must be more than " + in_words(limit) + ".");
}

void begin_comparisons() { sides = {}; }
void forget_comparison() { sides.is_new = false; }
void keep_comparison() {
    if (sides.is_new && sides.said.empty()) sides.said = sides.last;
}
std::string kept_comparison() { return sides.said; }

}  // namespace checker
