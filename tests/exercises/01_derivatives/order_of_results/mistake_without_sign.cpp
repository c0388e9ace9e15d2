#include "exercise.hpp"

double order_of_results(double coarse, double middle, double fine) {
    return std::fabs(std::log2((coarse - middle) / (middle - fine)));
}
