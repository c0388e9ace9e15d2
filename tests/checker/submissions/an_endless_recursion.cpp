// velocity_now crash: Segmentation fault
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return velocity_now(x1, x2, x0, h) + x0 * velocity_now(x0, x1, x2, h / 2);
}
