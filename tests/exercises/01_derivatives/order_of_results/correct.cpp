#include "exercise.hpp"

namespace exact_first {

// The exact value from the geometric series that the differences make (Aitken), then two errors.
double order_of_results(double coarse, double middle, double fine) {
    const double first = coarse - middle, second = middle - fine;
    const double exact = fine - second * second / (first - second);
    return std::log2((middle - exact) / (fine - exact));
}

}  // namespace exact_first

namespace natural_logarithms {

double order_of_results(double coarse, double middle, double fine) {
    const double first = std::fabs(middle - coarse), second = std::fabs(fine - middle);
    return (std::log(first) - std::log(second)) / std::log(2.0);
}

}  // namespace natural_logarithms

namespace ten_digits {

double order_of_results(double coarse, double middle, double fine) {
    const double first = std::fabs(coarse - middle), second = std::fabs(middle - fine);
    return (std::log(first) - std::log(second)) / 0.6931471806;
}

}  // namespace ten_digits

namespace by_the_exact_value {

// Aitken: the value that all three lead to, and by what the first two miss it.
double order_of_results(double coarse, double middle, double fine) {
    const double exact = coarse - (coarse - middle) * (coarse - middle) / ((coarse - middle) - (middle - fine));
    return std::log2((coarse - exact) / (middle - exact));
}

}  // namespace by_the_exact_value
