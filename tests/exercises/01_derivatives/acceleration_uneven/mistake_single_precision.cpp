#include "exercise.hpp"

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const float first = static_cast<float>(h0), second = static_cast<float>(h1);
    const float middle = static_cast<float>(x1);
    const float older = (middle - static_cast<float>(x0)) / first;
    const float newer = (static_cast<float>(x2) - middle) / second;
    return 2 * (newer - older) / (first + second);
}
