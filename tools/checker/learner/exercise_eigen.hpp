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

#endif
