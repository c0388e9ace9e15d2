#pragma once
/// \file
/// Values as rows of numbers: all that passes between the tests and a learner's code.

#include <algorithm>
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
#include <type_traits>
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
    std::size_t at() const { return at_; }

    /// Looks for the first two places at which another row of numbers has others: by more than roundoff, if there are
    /// such. (The first may be a length; then the second is an element.)
    void beside(const Numbers& other) {
        for (const double roundoff : {1e-9, 0.0})
            for (std::size_t i = 0; i < std::min(numbers_.size(), other.size()) && differing_[1] == nowhere; ++i)
                if (i != differing_[0] && !(std::fabs(numbers_[i] - other[i]) <= roundoff * std::fabs(other[i])))
                    differing_[differing_[0] == nowhere ? 0 : 1] = i;
    }
    /// Is one of those from `begin` to before `end`?
    bool differs(std::size_t begin, std::size_t end) const {
        return std::any_of(differing_.begin(), differing_.end(), [&](std::size_t i) { return i >= begin && i < end; });
    }

private:
    static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
    const Numbers& numbers_;
    Digits digits_;
    std::size_t at_ = 0;
    std::array<std::size_t, 2> differing_{nowhere, nowhere};
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
            if (!(number >= static_cast<double>(Limits::min()) && number <= static_cast<double>(Limits::max()) &&
                  number == std::trunc(number)))
                throw Malformed("an answer has a number that its type has not");
        }
        return static_cast<T>(number);
    }
    static std::string show(Reader& reader) {
        if constexpr (std::same_as<T, bool>) return reader.next() == 0 ? "false" : "true";
        return reader.next_written();
    }
};

/// "a, b, c" of so many values; of many, the first, the last, and where they differ from what they are held beside,
/// with its place: "a, b, …, [17]: c, …, d".
template <class T>
std::string show_row(Reader& reader, std::size_t size) {
    const std::size_t first = size > 20 ? 10 : size, last = size > 20 ? 2 : 0;
    std::string row;
    bool left_out = false;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t at = reader.at();
        const bool end = i < first || i >= size - last;
        // A long row has hundreds of thousands of numbers. To write those that nobody will read takes seconds.
        const bool unseen = std::is_arithmetic_v<T> && !end && !reader.differs(at, at + 1);
        const std::string one = unseen ? (reader.next(), "") : Wire<T>::show(reader);
        if (!unseen && (end || reader.differs(at, reader.at()))) {
            row += (i > 0 ? ", " : "") + (end ? one : "[" + std::to_string(i) + "]: " + one);
            left_out = false;
        } else if (!left_out) {
            row += ", …";
            left_out = true;
        }
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
        const bool of_another_length = reader.differs(reader.at(), reader.at() + 1);
        const auto size = static_cast<std::size_t>(reader.next());
        const std::string row = "{" + show_row<T>(reader, size) + "}";
        return of_another_length ? row + " of length " + std::to_string(size) : row;
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
