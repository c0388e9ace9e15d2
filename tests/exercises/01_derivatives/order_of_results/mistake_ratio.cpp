#include "exercise.hpp"

double order_of_results(double coarse, double middle, double fine) {
    return (coarse - middle) / (middle - fine);
}
