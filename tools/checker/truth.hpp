#pragma once
/// \file
/// The course's own answer, beside the learner's in every call: where the two are not the same to roundoff, one
/// of them is wrong.

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <tuple>

#include "answer.hpp"
#include "roundoff.hpp"

namespace checker {

/// Changes the real numbers in a value as `next`, a share from -1 to 0, says.
template <class T>
struct Nudge {
    template <class Next>
    static void by(T& value, const Next& next) {
        if constexpr (std::floating_point<T>)
            value *= 1 + T(next());
        else if constexpr (requires { value.begin(), value.end(); })
            for (auto& one : value) Nudge<std::decay_t<decltype(one)>>::by(one, next);
    }
};
template <class X>
struct Nudge<timestep::State<X>> {
    template <class Next>
    static void by(timestep::State<X>& state, const Next& next) {
        Nudge<timestep::real_of<X>>::by(state.t, next);
        Nudge<X>::by(state.x, next), Nudge<X>::by(state.v, next);
    }
};

/// An answer of the course's, and what becomes of it where its arguments are smaller by shares of them, each at most
/// `most`. With a few units of roundoff: as far as those lie apart, another way to write it may be off, too.
struct Function {
    Answer answer;
    std::function<Numbers(const Numbers& arguments, unsigned variation, double most)> nudged;
    std::size_t leading = 0;  ///< of the numbers in its arguments so many stand before the first list,
    bool has_list = false;    ///< which there may be
};

/// The right answer.
using Truth = Function;

/// Has it as many numbers whatever they are?
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

/// Those of the arguments before the first list.
template <class... Args>
std::size_t leading_numbers() {
    const Numbers zeros(64);
    Reader reader(zeros);
    static_cast<void>((... && (!is_list<Args> && (Wire<Args>::take(reader), true))));
    return reader.at();
}

template <class R, class... Args>
Function function_of(R (*function)(Args...)) {
    return {answer_of(function),
            [function](const Numbers& numbers, unsigned variation, double most) {
                Reader reader(numbers);
                std::tuple<std::decay_t<Args>...> arguments{Wire<std::decay_t<Args>>::take(reader)...};
                std::uint64_t state = variation;
                // -1, …, 0: smaller, for what may be at most 1 may not be more
                const auto next = [&state, most] { return -most * next_share(state); };
                std::apply([&](auto&... values) { (Nudge<std::decay_t<decltype(values)>>::by(values, next), ...); },
                           arguments);
                Numbers result;
                Wire<std::decay_t<R>>::put(result, std::apply(function, arguments));
                return result;
            },
            leading_numbers<std::decay_t<Args>...>(), (is_list<std::decay_t<Args>> || ...)};
}

/// A constant such as π may be typed with nine digits.
inline constexpr double nine_digits = 2e-9;
/// Nothing but roundoff.
inline constexpr double all_digits = 2e-12;

/// How near the right answer an answer must be. All of these are allowed:
struct Within {
    double relative;    ///< so much of the answer
    Function beside{};  ///< what another right way to write it, where one is given, loses to roundoff
    double of_arguments =
        0;  ///< what a change of the arguments by so much does to the answer; 0: by as much as `relative`
    const std::vector<Answer>* ways =
        nullptr;  ///< what roundings make of the ways to write it that the course knows (slips.hpp)
};

/// By how much `way` misses the right answer near these arguments, number by number: what its roundings make of it
/// there. One infinite number where it has not as many.
Numbers lost_by(const Function& way, const Truth& truth, const Numbers& arguments, unsigned variation);

/// Is `found` the right answer to this call, but for roundoff?
bool is_right(const Truth& truth, const Numbers& arguments, const Numbers& found, const Within& within,
              const Spoken& spoken);

/// The right answer as it comes out by hand: where a number of it is no larger than what roundoff of the arguments
/// does to it, as the sine of π is not, it is zero.
Numbers without_roundoff(const Truth& truth, const Numbers& arguments);

/// As `Within::relative`: there are many right answers, and the course's is but one of them.
inline constexpr double many_are_right = std::numeric_limits<double>::infinity();

}  // namespace checker
