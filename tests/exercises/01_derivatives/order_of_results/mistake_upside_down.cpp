#include "exercise.hpp"

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((middle - fine) / (coarse - middle));
}
