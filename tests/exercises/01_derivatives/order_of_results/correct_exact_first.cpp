#include "exercise.hpp"

// The exact value from the geometric series that the differences make (Aitken), then two errors.
double order_of_results(double coarse, double middle, double fine) {
    const double first = coarse - middle, second = middle - fine;
    const double exact = fine - second * second / (first - second);
    return std::log2((middle - exact) / (fine - exact));
}
