#include "exercise.hpp"

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x2 - x1) / h0 - (x1 - x0) / h1) / (h0 + h1);
}
