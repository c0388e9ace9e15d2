#pragma once
/// \file
/// Fixed-size vectors, matrices (column by column) and quaternions (x, y, z, w) as rows of numbers.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "numbers.hpp"
#include "truth.hpp"

namespace checker {

template <class T, int rows, int columns, int... rest>
requires(rows > 0 && columns > 0) struct Wire<Eigen::Matrix<T, rows, columns, rest...>> {
    using Matrix = Eigen::Matrix<T, rows, columns, rest...>;
    static void put(Numbers& numbers, const Matrix& values) {
        for (int j = 0; j < columns; ++j)
            for (int i = 0; i < rows; ++i) Wire<T>::put(numbers, values(i, j));
    }
    static Matrix take(Reader& reader) {
        Matrix values;
        for (int j = 0; j < columns; ++j)
            for (int i = 0; i < rows; ++i) values(i, j) = Wire<T>::take(reader);
        return values;
    }
    /// A vector as (x, y, z); a matrix column by column, as the vectors that they are, or what stands on its diagonal,
    /// if that is all.
    static std::string show(Reader& reader) {
        if constexpr (rows == columns && rows > 1) {
            Reader ahead = reader;
            const Matrix values = take(ahead);
            if ((values.array() == 0).count() == rows * (rows - 1) && (values.diagonal().array() != 0).all()) {
                std::string diagonal;
                for (int i = 0; i < rows * rows; ++i) {
                    const std::string one = Wire<T>::show(reader);
                    if (i % (rows + 1) == 0) diagonal += (i > 0 ? ", " : "") + one;
                }
                return "{diagonal (" + diagonal + ")}";
            }
        }
        std::string columns_shown;
        for (int j = 0; j < columns; ++j) {
            if (j > 0) columns_shown += ", ";
            columns_shown += "(" + show_row<T>(reader, rows) + ")";
        }
        return columns == 1 ? columns_shown : "{columns " + columns_shown + "}";
    }
};

template <class T>
struct Wire<Eigen::Quaternion<T>> {
    using Coefficients = Eigen::Matrix<T, 4, 1>;
    static void put(Numbers& numbers, const Eigen::Quaternion<T>& q) { Wire<Coefficients>::put(numbers, q.coeffs()); }
    static Eigen::Quaternion<T> take(Reader& reader) { return Eigen::Quaternion<T>(Wire<Coefficients>::take(reader)); }
    static std::string show(Reader& reader) {
        const std::string vector = show_row<T>(reader, 3);  // w comes last here, and first in the constructor
        return "Quaterniond(" + Wire<T>::show(reader) + ", " + vector + ")";
    }
};

template <class T>
inline constexpr bool minus_is_the_same<Eigen::Quaternion<T>> = true;
template <class T>
inline constexpr bool of_one_unit<Eigen::Quaternion<T>> = true;
template <class T, int rows, int columns, int... rest>
inline constexpr bool of_one_unit<Eigen::Matrix<T, rows, columns, rest...>> = true;

template <class T, int rows, int columns, int... rest>
struct Nudge<Eigen::Matrix<T, rows, columns, rest...>> {
    template <class Next>
    static void by(Eigen::Matrix<T, rows, columns, rest...>& values, const Next& next) {
        for (auto& value : values.reshaped()) Nudge<T>::by(value, next);
    }
};
template <class T>
struct Nudge<Eigen::Quaternion<T>> {
    template <class Next>
    static void by(Eigen::Quaternion<T>& q, const Next& next) {
        const T length = q.norm();
        Nudge<Eigen::Matrix<T, 4, 1>>::by(q.coeffs(), next);
        if (length > 0) q.coeffs() *= length / q.norm();  // a turn stays a turn
    }
};

}  // namespace checker
