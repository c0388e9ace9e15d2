#include "exercise_eigen.hpp"

Vector3d solve_linear(const Matrix3d& A, const Vector3d& b) { return A.partialPivLu().solve(b); }
