#pragma once
/// \file
/// Values as rows of numbers: all that passes between the tests and a learner's code.

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
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

/// Are they alike bit by bit? For NaN is not equal to itself. Not by memcmp, of which a learner's
/// file may have its own.
inline bool same_bits(const Numbers& a, const Numbers& b) {
    std::uint64_t different = a.size() ^ b.size();
    for (std::size_t i = 0; different == 0 && i < a.size(); ++i)
        different = std::bit_cast<std::uint64_t>(a[i]) ^ std::bit_cast<std::uint64_t>(b[i]);
    return different == 0;
}

/// How people read a number: with ten digits, or with as many more as it takes to be the same number again.
enum class Digits { ten, all };

inline std::string written(double number, Digits digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", number);
    for (int more = 11; digits == Digits::all && more <= 17 && std::strtod(text, nullptr) != number; ++more)
        std::snprintf(text, sizeof text, "%.*g", more, number);  // NaN stays what it is
    return text;
}

/// Reads numbers from front to back.
class Reader {
public:
    explicit Reader(const Numbers& numbers, Digits digits = Digits::ten) : numbers_(numbers), digits_(digits) {}

    /// The next number. Throws Malformed where there is none left.
    double next() {
        if (at_ == numbers_.size()) throw Malformed("an answer has fewer numbers than its type");
        return numbers_[at_++];
    }
    std::size_t left() const { return numbers_.size() - at_; }
    /// The next number as people read it.
    std::string next_written() { return written(next(), digits_); }

private:
    const Numbers& numbers_;
    Digits digits_;
    std::size_t at_ = 0;
};

/// How a type becomes numbers, how it is made of them again, and how people read it: `put`, `take`
/// and `show`.
template <class T>
struct Wire;

template <class T>
requires std::integral<T> || std::floating_point<T>
struct Wire<T> {
    static void put(Numbers& numbers, T value) { numbers.push_back(static_cast<double>(value)); }
    static T take(Reader& reader) {
        const double number = reader.next();
        if constexpr (std::integral<T>) {  // of a bool's numbers there are two
            using Limits = std::numeric_limits<T>;
            if (!(number >= static_cast<double>(Limits::min()) &&
                  number <= static_cast<double>(Limits::max()) && number == std::trunc(number)))
                throw Malformed("an answer has a number that its type has not");
        }
        return static_cast<T>(number);
    }
    static std::string show(Reader& reader) {
        if constexpr (std::same_as<T, bool>) return reader.next() == 0 ? "false" : "true";
        return reader.next_written();
    }
};

/// "a, b, c" of so many values.
template <class T>
std::string show_row(Reader& reader, std::size_t size) {
    const std::size_t first = size > 20 ? 10 : size, last = size > 20 ? 2 : 0;
    std::string row;
    for (std::size_t i = 0; i < size; ++i) {
        const std::string one = Wire<T>::show(reader);
        const bool shown = i < first || i >= size - last;
        if (shown || i == first) row += (i > 0 ? ", " : "") + (shown ? one : "…");
    }
    return row;
}

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
    static std::string show(Reader& reader) { return "{" + show_row<T>(reader, n) + "}"; }
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
        if (!(size >= 0 && size <= static_cast<double>(reader.left()) && size == std::trunc(size)))
            throw Malformed("an answer's length is not the number of its elements");
        // At its full size at once: a sanitizer that marks the room behind the end of a learner's
        // vectors sees only what the learner's code does to them.
        std::vector<T> values(static_cast<std::size_t>(size));
        for (T& value : values) value = Wire<T>::take(reader);
        return values;
    }
    static std::string show(Reader& reader) {
        return "{" + show_row<T>(reader, static_cast<std::size_t>(reader.next())) + "}";
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
    static std::string show(Reader& reader) {
        std::string state = "{t " + Wire<timestep::real_of<X>>::show(reader);
        state += ", x " + Wire<X>::show(reader);
        state += ", v " + Wire<X>::show(reader);
        return state + "}";
    }
};

}  // namespace checker
