// A guard instead of #pragma once: compilers complain of that where a header is compiled
// beforehand.
#ifndef TIMESTEP_EXERCISE_EIGEN_HPP
#define TIMESTEP_EXERCISE_EIGEN_HPP
/// \file
/// What an exercise with vectors and matrices gives to the file you write.

#include "exercise.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The x with A x = b. Eigen's own A.partialPivLu().solve(b) does the same, and is compiled some seconds
/// longer at every check; this is compiled already.
Vector3d solve_linear(const Matrix3d& A, const Vector3d& b);

#endif
