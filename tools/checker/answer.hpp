#pragma once
/// \file
/// An answer to an exercise, seen from outside: numbers in, numbers out, wherever it runs.

#include <functional>
#include <string>
#include <tuple>
#include <type_traits>

#include "numbers.hpp"

namespace checker {

/// A learner's function behind a pipe, the solution, a planted mistake: each is an Answer.
using Answer = std::function<Numbers(const Numbers&)>;

/// Thrown where a call has changed what it should only read.
struct ArgumentsChanged {};

/// An ordinary typed function as an Answer.
template <class R, class... Args>
Answer answer_of(R (*function)(Args...)) {
    return [function](const Numbers& numbers) {
        Reader reader(numbers);
        // Braces, because they read the arguments from left to right.
        std::tuple<std::decay_t<Args>...> arguments{Wire<std::decay_t<Args>>::take(reader)...};
        Numbers result;
        Wire<std::decay_t<R>>::put(result, std::apply(function, arguments));
        Numbers after;
        // So that none is copied once more: the learner may have an own memmove.
        after.reserve(numbers.size());
        const auto add = [&after](const auto& value) { Wire<std::decay_t<decltype(value)>>::put(after, value); };
        std::apply([&](const auto&... values) { (add(values), ...); }, arguments);
        if (!same_bits(after, numbers)) throw ArgumentsChanged{};
        return result;
    };
}

/// Calls as people write them, of functions of one type: "(1, 2)" and "3".
struct Spoken {
    std::string (*arguments)(const Numbers&, Digits);
    std::string (*result)(const Numbers&, const Numbers& beside, Digits);  ///< shows also where the two differ
    bool (*is_result)(const Numbers&);  ///< has it as many numbers as its type demands?
    bool or_minus;                      ///< is the negative of a result the same, as of a rotation's quaternion?
    bool one_size;   ///< are its numbers of one unit, as a vector's: is roundoff that of the largest?
    bool has_reals;  ///< or are they whole, or a yes or no, to which no rounding belongs?
};

/// A type of which a value and its negative stand for the same.
template <class T>
inline constexpr bool minus_is_the_same = false;
/// A type whose numbers are of one unit.
template <class T>
inline constexpr bool of_one_unit = false;

/// A type that holds other numbers than whole ones.
template <class T>
inline constexpr bool holds_reals = !std::is_integral_v<T>;
template <class T, std::size_t n>
inline constexpr bool holds_reals<std::array<T, n>> = holds_reals<T>;
template <class T>
inline constexpr bool holds_reals<std::vector<T>> = holds_reals<T>;

template <class Signature>
struct SpokenOf;

template <class R, class... Args>
struct SpokenOf<R(Args...)> {
    static std::string arguments(const Numbers& numbers, Digits digits) {
        Reader reader(numbers, digits);
        std::string row;
        const auto add = [&](const std::string& argument) {
            if (!row.empty()) row += ", ";
            row += argument;
        };
        (add(Wire<std::decay_t<Args>>::show(reader)), ...);
        return "(" + row + ")";
    }
    static std::string result(const Numbers& numbers, const Numbers& beside, Digits digits) {
        Reader reader(numbers, digits);
        reader.beside(beside);
        return Wire<std::decay_t<R>>::show(reader);
    }
    static bool is_result(const Numbers& numbers) {
        try {
            Reader reader(numbers);
            Wire<std::decay_t<R>>::take(reader);
            return reader.left() == 0;
        } catch (const Malformed&) {
            return false;
        }
    }
    static constexpr Spoken spoken{arguments,
                                   result,
                                   is_result,
                                   minus_is_the_same<std::decay_t<R>>,
                                   of_one_unit<std::decay_t<R>>,
                                   holds_reals<std::decay_t<R>>};
};

/// A function of numbers as an ordinary typed function: `Typed<double(double, double)> f(g); f(1,
/// 2)`.
template <class Signature>
class Typed;

template <class R, class... Args>
class Typed<R(Args...)> {
public:
    using Call = Numbers (*)(const Numbers&, const Spoken&);
    explicit Typed(Call call) : call_(call) {}

    std::decay_t<R> operator()(const std::decay_t<Args>&... arguments) const {
        Numbers numbers;
        (Wire<std::decay_t<Args>>::put(numbers, arguments), ...);
        const Numbers result = call_(numbers, SpokenOf<R(Args...)>::spoken);
        Reader reader(result);
        return Wire<std::decay_t<R>>::take(reader);
    }

private:
    Call call_;
};

}  // namespace checker
