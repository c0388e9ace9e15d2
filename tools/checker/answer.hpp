#pragma once
/// \file
/// An answer to an exercise, seen from outside: numbers in, numbers out, wherever it runs.

#include <functional>
#include <tuple>
#include <type_traits>

#include "numbers.hpp"

namespace checker {

/// A learner's function behind a pipe, the solution, a planted mistake: each is an Answer.
using Answer = std::function<Numbers(const Numbers&)>;

/// An ordinary typed function as an Answer.
template <class R, class... Args>
Answer answer_of(R (*function)(Args...)) {
    return [function](const Numbers& numbers) {
        Reader reader(numbers);
        // Braces, because they read the arguments from left to right.
        std::tuple<std::decay_t<Args>...> arguments{Wire<std::decay_t<Args>>::take(reader)...};
        Numbers result;
        Wire<std::decay_t<R>>::put(result, std::apply(function, arguments));
        return result;
    };
}

/// An Answer as an ordinary typed function: `Typed<double(double, double)> f; f(1, 2)`.
template <class Signature>
class Typed;

template <class R, class... Args>
class Typed<R(Args...)> {
public:
    explicit Typed(Answer answer) : answer_(std::move(answer)) {}

    std::decay_t<R> operator()(const std::decay_t<Args>&... arguments) const {
        Numbers numbers;
        (Wire<std::decay_t<Args>>::put(numbers, arguments), ...);
        const Numbers result = answer_(numbers);
        Reader reader(result);
        return Wire<std::decay_t<R>>::take(reader);
    }

private:
    Answer answer_;
};

}  // namespace checker
