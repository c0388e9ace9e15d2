#pragma once
/// \file
/// The two sides of a property that does not hold, for whoever works it out by hand: where many answers are right there
/// is no right one to show.

#include <complex>
#include <string>

namespace checker {

/// `holds`; where not, these words are what the learner reads, if no call follows before the property breaks.
bool told(bool holds, const std::string& words);
/// As one reads a number.
std::string in_words(double number);
std::string in_words(std::complex<double> number);

/// "after the step it is 2, and must be 3. They differ by 1."
template <class T>
bool agree(bool holds, const std::string& what, T found, T right) {
    if (holds) return true;
    return told(false, what + " " + in_words(found) + ", and must be " + in_words(right) + ". They differ by " +
                           in_words(std::abs(found - right)) + ".");
}
/// Is it less? Or: is it more?
bool below(const std::string& what, double found, double limit);
bool above(const std::string& what, double found, double limit);

/// For the session: a property begins; the answer is called; the property breaks here. And what was said of it.
void begin_comparisons();
void forget_comparison();
void keep_comparison();
std::string kept_comparison();

}  // namespace checker
