#include "exercise.hpp"

double order_of_results(double coarse, double middle, double fine) {
    const double first = std::fabs(middle - coarse), second = std::fabs(fine - middle);
    return (std::log(first) - std::log(second)) / std::log(2.0);
}
