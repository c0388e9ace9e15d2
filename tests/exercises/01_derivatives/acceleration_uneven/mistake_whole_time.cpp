#include "exercise.hpp"

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) / (h0 + h1);
}
