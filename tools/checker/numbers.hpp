#pragma once
/// \file
/// Values as rows of numbers: all that passes between the tests and a learner's code.

#include <array>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <utility>
#include <vector>

#include <timestep/state.hpp>

namespace checker {

/// A value, or the arguments of a call, one number after another.
using Numbers = std::vector<double>;

/// An answer that is not made as its type demands.
struct Malformed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads numbers from front to back.
class Reader {
public:
    explicit Reader(const Numbers& numbers) : numbers_(numbers) {}

    /// The next number. Throws Malformed where there is none left.
    double next() {
        if (at_ == numbers_.size()) throw Malformed("an answer has fewer numbers than its type");
        return numbers_[at_++];
    }
    std::size_t left() const { return numbers_.size() - at_; }

private:
    const Numbers& numbers_;
    std::size_t at_ = 0;
};

/// How a type becomes numbers and how it is made of them again: `put` and `take`.
template <class T>
struct Wire;

template <class T>
    requires std::integral<T> || std::floating_point<T>
struct Wire<T> {
    static void put(Numbers& numbers, T value) { numbers.push_back(static_cast<double>(value)); }
    static T take(Reader& reader) { return static_cast<T>(reader.next()); }
};

template <class T, std::size_t n>
struct Wire<std::array<T, n>> {
    static void put(Numbers& numbers, const std::array<T, n>& values) {
        for (const T& value : values) Wire<T>::put(numbers, value);
    }
    static std::array<T, n> take(Reader& reader) {
        std::array<T, n> values{};
        for (T& value : values) value = Wire<T>::take(reader);
        return values;
    }
};

/// Its size first.
template <class T>
struct Wire<std::vector<T>> {
    static void put(Numbers& numbers, const std::vector<T>& values) {
        numbers.push_back(static_cast<double>(values.size()));
        for (const T& value : values) Wire<T>::put(numbers, value);
    }
    static std::vector<T> take(Reader& reader) {
        const double size = reader.next();
        if (!(size >= 0 && size <= static_cast<double>(reader.left())))
            throw Malformed("an answer's length is not the number of its elements");
        std::vector<T> values;
        for (double i = 0; i < size; ++i) values.push_back(Wire<T>::take(reader));
        return values;
    }
};

template <class X>
struct Wire<timestep::State<X>> {
    static void put(Numbers& numbers, const timestep::State<X>& state) {
        Wire<timestep::real_of<X>>::put(numbers, state.t);
        Wire<X>::put(numbers, state.x);
        Wire<X>::put(numbers, state.v);
    }
    static timestep::State<X> take(Reader& reader) {
        const auto t = Wire<timestep::real_of<X>>::take(reader);
        const X x = Wire<X>::take(reader);
        const X v = Wire<X>::take(reader);
        return {t, x, v};
    }
};

}  // namespace checker
