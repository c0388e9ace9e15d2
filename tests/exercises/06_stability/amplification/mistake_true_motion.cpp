#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    return std::exp(h * re);
}
