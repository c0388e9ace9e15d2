#pragma once
/// \file
/// The course's own answers with slips in them: a sign turned round, a term left out. write_slips.cpp rewrites an
/// answer so that each of its operators asks `chosen` whether to do as written or to slip. So one function is all of
/// its slips, and two at once cost nothing.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace checker::slip {

/// What a slip does. The learner is told no more (tools/course/misconception.cpp): which it is leads on, where does
/// not. Where two slips answer alike, the first of these is what is told.
enum class Form : unsigned char {
    sign,
    twice,
    half,
    term,
    factor,
    function,
    upside_down,
    power,
    exchanged,
    reversed,
    edge,
    guard,
    absolute,
    limit,
    joined,
    brackets,
    line,
    loop,
    variable,
    constant,
    degrees,
    single,
    none
};
/// A slip in arithmetic, which is one in whatever way an answer is written.
inline constexpr Form last_of_arithmetic = Form::power;

/// Thrown where an answer with a slip leaves its vectors, or never ends: then nobody answers like that.
struct Nowhere {};

/// Counts the place that is passed. Is all to be done as written there, and nothing to be noted?
bool as_written(int site);
/// Notes the slips that can be made at a place: there are `count`, with these forms. The number of the one that is to
/// be made, from 1 on; 0: as written. Form::none stands for a slip that cannot be made there.
int noted(int site, const Form* forms, std::size_t count);
/// 0: as written; else the number of the slip, one of `forms`, that is to be made at this place.
inline int chosen(int site, std::initializer_list<Form> forms) {
    return as_written(site) ? 0 : noted(site, forms.begin(), forms.size());
}
/// A slip's form, and its value.
template <class T>
using Slip = std::pair<Form, T>;
/// Where a place is not passed as written: its value, with the slip that is to be made.
template <class T>
T either(int site, const T& written, const Slip<T>* slips, std::size_t count) {
    std::array<Form, 16> forms;
    for (std::size_t i = 0; i < count; ++i) forms[i] = slips[i].first;
    const int number = noted(site, forms.data(), count);
    return number == 0 ? written : slips[number - 1].second;
}
template <class T>
T either(int site, const T& written, std::initializer_list<Slip<T>> slips) {
    return either(site, written, slips.begin(), slips.size());
}
/// Counts the turns of loops; always true.
bool turn();

/// Is each result to be off by some units of roundoff? And a number that is.
bool rounds();
double rounded(double x);

// Sites that all places of an answer share.
inline constexpr int pi_site = 1, angle_site = 2, single_site = 3, first_free_site = 10;

// Of numbers (slip.cpp).
double plus(int site, double l, double r);
double minus(int site, double l, double r);
double times(int site, double l, double r);
double over(int site, double l, double r);
double added(int site, double x);
double negative(int site, double x);
double pi();
double angle(double x);
bool without(int site);
inline bool joined(int site) { return chosen(site, {Form::joined}) == 1; }
inline bool unbracketed(int site) { return chosen(site, {Form::brackets}) == 1; }
double pick(int site, double one, std::initializer_list<double> others);

template <class T>
struct PlainOf {
    using type = T;
};
template <class T>
requires requires { typename T::PlainObject; }
struct PlainOf<T> {
    using type = typename T::PlainObject;
};
/// What an expression of Eigen's is worked out to.
template <class T>
using Plain = typename PlainOf<std::decay_t<T>>::type;

template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class L, class R>
concept Whole = std::integral<L> && std::integral<R>;
template <class T>
concept Scales = requires(T x) {
    Plain<T>(x * 2.0);
}
&&!requires(T x) { x.conjugate().w(); };
template <class T>
inline constexpr bool scales = Scales<T>;

template <class T>
T scaled(const T& x, double by) {
    if constexpr (std::integral<T>)
        return static_cast<T>(by * static_cast<double>(x));
    else if constexpr (scales<T>)
        return x * by;
    else
        return x;
}

/// Numbers of which each is off by some units of roundoff, if any is.
template <class T>
T with_roundoff(T x) {
    if (!rounds()) return x;
    if constexpr (std::same_as<T, double>)
        x = rounded(x);
    else if constexpr (requires { x = T(rounded(x.real()), rounded(x.imag())); })
        x = T(rounded(x.real()), rounded(x.imag()));
    else if constexpr (requires { x.coeffs().reshaped(); })
        for (double& one : x.coeffs().reshaped()) one = rounded(one);
    else if constexpr (requires { x.reshaped()[0] = 1.0; })
        for (double& one : x.reshaped()) one = rounded(one);
    return x;
}

// Both may stand for their sum: numbers and vectors, no iterators.
template <class L, class R>
concept Terms = requires(const L& l, const R& r) {
    Plain<decltype(l - r)>(l + r);
    Plain<decltype(l - r)>(l);
    Plain<decltype(l - r)>(r);
};

/// `x` where it is of type T, and else `otherwise`.
template <class T, class X>
T as(const X& x, const T& otherwise) {
    if constexpr (std::same_as<X, T>)
        return x;
    else
        return otherwise;
}
template <class T, class X>
inline constexpr Form if_same(Form form) {
    return std::same_as<T, X> ? form : Form::none;
}

template <class L, class R>
auto plus(int site, const L& l, const R& r) {
    if constexpr (Number<L> && Number<R> && !Whole<L, R>)
        return plus(site, double(l), double(r));
    else if constexpr (!Terms<L, R>)
        return l + r;
    else {
        using T = Plain<decltype(l + r)>;
        const T sum = with_roundoff(T(l + r));
        if (as_written(site)) return sum;
        return either<T>(site, sum,
                         {{Form::sign, T(l - r)},
                          {Form::term, T(l)},
                          {Form::term, T(r)},
                          {Form::twice, T(l + scaled(r, 2))},
                          {Form::half, T(l + scaled(r, 0.5))}});
    }
}

template <class L, class R>
auto minus(int site, const L& l, const R& r) {
    if constexpr (Number<L> && Number<R> && !Whole<L, R>)
        return minus(site, double(l), double(r));
    else if constexpr (!Terms<L, R>)
        return l - r;
    else {
        using T = Plain<decltype(l - r)>;
        const T difference = with_roundoff(T(l - r));
        if (as_written(site)) return difference;
        return either<T>(site, difference,
                         {{Form::sign, T(l + r)},
                          {Form::sign, T(r - l)},
                          {Form::term, T(l)},
                          {Form::term, T(scaled(r, -1))},
                          {Form::twice, T(l - scaled(r, 2))},
                          {Form::half, T(l - scaled(r, 0.5))}});
    }
}

template <class L, class R>
auto times(int site, const L& l, const R& r) {
    if constexpr (Number<L> && Number<R> && !Whole<L, R>)
        return times(site, double(l), double(r));
    else {
        using T = Plain<decltype(l * r)>;
        if (as_written(site)) {
            if constexpr (Whole<L, R>)
                return T(l * r);
            else
                return T(with_roundoff(l) * with_roundoff(r));  // its own sums may cancel
        }
        const T product = l * r;
        T exchanged = product;
        if constexpr (std::same_as<L, R>) exchanged = r * l;
        const auto if_scales = [](Form form) { return scales<T> ? form : Form::none; };
        return either<T>(site, product,
                         {{if_scales(Form::sign), scaled(product, -1)},
                          {if_scales(Form::twice), scaled(product, 2)},
                          {if_scales(Form::half), scaled(product, 0.5)},
                          {if_same<L, T>(Form::factor), as<T>(l, product)},
                          {if_same<R, T>(Form::factor), as<T>(r, product)},
                          {std::same_as<L, R> && !scales<T> ? Form::exchanged : Form::none, exchanged}});
    }
}

template <class L, class R>
auto over(int site, const L& l, const R& r) {
    if constexpr (Number<L> && Number<R> && !Whole<L, R>)
        return over(site, double(l), double(r));
    else {
        using T = Plain<decltype(l / r)>;
        if constexpr (std::integral<R>)
            if (r == 0) throw Nowhere{};
        T quotient = l / r;
        if constexpr (!Whole<L, R>) quotient = with_roundoff(quotient);
        if (as_written(site)) return quotient;
        return either<T>(site, quotient,
                         {{Form::sign, scaled(quotient, -1)},
                          {Form::twice, scaled(quotient, 2)},
                          {Form::half, scaled(quotient, 0.5)},
                          {if_same<L, T>(Form::factor), as<T>(l, quotient)},
                          {Form::upside_down, T(l * r)}});
    }
}

template <class L, class R>
auto rest(int site, L l, R r) {
    if (r == 0) throw Nowhere{};
    return chosen(site, {Form::factor}) == 1 ? decltype(l % r)(l) : l % r;
}

// Is one less than the other? `back`: are the two asked about the other way round; `equal`: counts equality?
template <bool is_back, bool is_equal, class L, class R>
bool compare(int site, const L& l, const R& r) {
    bool back = is_back, equal = is_equal;
    const int slip = chosen(site, {Form::reversed, Form::edge, Whole<L, R> ? Form::edge : Form::none});
    if (slip == 1) back = !back;
    if (slip == 2) equal = !equal;
    const auto ask = [&](const auto& a, const auto& b) {
        if constexpr (Whole<L, R>) {
            const auto one = static_cast<long long>(a) + (slip == 3 ? 1 : 0), other = static_cast<long long>(b);
            return equal ? one <= other : one < other;
        } else {
            return equal ? a <= b : a < b;
        }
    };
    return back ? ask(r, l) : ask(l, r);
}

// An operator in two halves, for its precedence: `a + Plus{7} + b`.
template <class Operator, class L>
struct Half {
    L left;
    int site;
};
#define TIMESTEP_OPERATOR_THAT_SLIPS(Name, op, ...)                                \
    struct Name {                                                                  \
        int site;                                                                  \
    };                                                                             \
    template <class L>                                                             \
    Half<Name, Plain<L>> operator op(const L& l, Name at) {                        \
        return {l, at.site};                                                       \
    }                                                                              \
    template <class L, class R>                                                    \
    auto operator op(const Half<Name, L>& half, const R& r) {                      \
        return __VA_ARGS__(half.site, half.left, static_cast<const Plain<R>&>(r)); \
    }
TIMESTEP_OPERATOR_THAT_SLIPS(Plus, +, plus)
TIMESTEP_OPERATOR_THAT_SLIPS(Minus, -, minus)
TIMESTEP_OPERATOR_THAT_SLIPS(Times, *, times)
TIMESTEP_OPERATOR_THAT_SLIPS(Over, /, over)
TIMESTEP_OPERATOR_THAT_SLIPS(Rest, %, rest)
TIMESTEP_OPERATOR_THAT_SLIPS(Less, <, compare<false, false>)
TIMESTEP_OPERATOR_THAT_SLIPS(AtMost, <=, compare<false, true>)
TIMESTEP_OPERATOR_THAT_SLIPS(More, >, compare<true, false>)
TIMESTEP_OPERATOR_THAT_SLIPS(AtLeast, >=, compare<true, true>)
#undef TIMESTEP_OPERATOR_THAT_SLIPS

struct Negative {
    int site;
};
template <class R>
auto operator->*(Negative at, const R& r) {
    if constexpr (Number<R>)
        return negative(at.site, double(r));
    else {
        using T = Plain<R>;
        return chosen(at.site, {Form::sign}) == 1 ? T(r) : T(-r);
    }
}

/// What stands behind += or -=.
template <class X>
auto added(int site, const X& x) {
    if constexpr (Number<X>)
        return added(site, double(x));
    else {
        using T = Plain<X>;
        if (as_written(site)) return T(x);
        return either<T>(site, x,
                         {{Form::sign, scaled(T(x), -1)},
                          {Form::term, scaled(T(x), 0)},
                          {Form::twice, scaled(T(x), 2)},
                          {Form::half, scaled(T(x), 0.5)}});
    }
}

// Functions of Eigen's: `x ->* norm{7}`.
#define TIMESTEP_METHOD_THAT_SLIPS(name, written, slipped)                                      \
    struct name {                                                                               \
        int site;                                                                               \
    };                                                                                          \
    template <class X>                                                                          \
    auto operator->*(const X& x, name at) {                                                     \
        using T = decltype(written);                                                            \
        return chosen(at.site, {Form::function}) == 1 ? T(slipped) : with_roundoff(T(written)); \
    }
TIMESTEP_METHOD_THAT_SLIPS(norm, double(x.norm()), x.squaredNorm())
TIMESTEP_METHOD_THAT_SLIPS(squaredNorm, double(x.squaredNorm()), x.norm())
TIMESTEP_METHOD_THAT_SLIPS(normalized, Plain<X>(x.normalized()), x)
#undef TIMESTEP_METHOD_THAT_SLIPS
struct conjugate {
    int site;
};
template <class X>
Plain<X> operator->*(const X& x, conjugate at) {
    return chosen(at.site, {Form::function}) == 1 ? Plain<X>(x) : Plain<X>(x.conjugate());
}

// Functions of the standard library's.
double sin(int site, double x);
double cos(int site, double x);
double exp(int site, double x);
double log(int site, double x);
double log1p(int site, double x);
double expm1(int site, double x);
double exp2(int site, double x);
double log2(int site, double x);
double cbrt(int site, double x);
double floor(int site, double x);
double ceil(int site, double x);
double pow(int site, double x, double y);
double clamp(int site, double x, double low, double high);
template <class X>
requires(!Number<X>) X exp(int, const X& x) { return std::exp(x); }
template <class X>
requires(!Number<X>) X log(int, const X& x) { return std::log(x); }
template <class X>
auto sqrt(int site, const X& x) {
    using T = decltype(std::sqrt(x));
    return chosen(site, {Form::function}) == 1 ? T(x) : with_roundoff(T(std::sqrt(x)));
}
template <class X>
auto abs(int site, const X& x) {
    using T = decltype(std::abs(x));
    if constexpr (Number<X>)
        return chosen(site, {Form::absolute}) == 1 ? x : T(std::abs(x));
    else
        return chosen(site, {Form::function}) == 1 ? T(x.real()) : std::abs(x);
}
inline double fabs(int site, double x) { return abs(site, x); }
template <class X>
X max(int site, const X& a, const X& b) {
    const int slip = chosen(site, {Form::reversed, Form::guard, Form::guard});
    return slip == 1 ? std::min(a, b) : slip == 2 ? a : slip == 3 ? b : std::max(a, b);
}
template <class X>
X min(int site, const X& a, const X& b) {
    const int slip = chosen(site, {Form::reversed, Form::guard, Form::guard});
    return slip == 1 ? std::max(a, b) : slip == 2 ? a : slip == 3 ? b : std::min(a, b);
}

// Vectors that are asked for no more than they have.
template <class C>
struct In {
    C& values;
    template <class I>
    decltype(auto) operator[](I i) const {
        if (!(i >= 0 && static_cast<std::size_t>(i) < static_cast<std::size_t>(values.size()))) throw Nowhere{};
        return values[i];
    }
    decltype(auto) back() const { return values.empty() ? throw Nowhere{} : values.back(); }
    decltype(auto) front() const { return values.empty() ? throw Nowhere{} : values.front(); }
};
template <class C>
In<C> in(C& values) {
    return {values};
}

/// A loop's vector, or without its first or its last element.
template <class T>
std::vector<T> part(int site, std::vector<T> values) {
    const int slip = chosen(site, {Form::loop, Form::loop});
    if (slip != 0 && !values.empty()) values.erase(slip == 1 ? values.begin() : values.end() - 1);
    return values;
}
template <class T>
const T& part(int, const T& values) {
    return values;
}
/// Where a loop begins, and the next one: up, or down.
template <class T>
T from(int site, T first) {
    if constexpr (std::integral<T>)
        return chosen(site, {Form::loop}) == 1 ? T(first + 1) : first;
    else
        return first;
}
template <class T>
T down_from(int site, T first) {
    if constexpr (std::integral<T>)
        return chosen(site, {Form::loop}) == 1 && first > 0 ? T(first - 1) : first;
    else
        return first;
}
/// Is a line to be left out?
inline bool keeps(int site) { return chosen(site, {Form::line}) == 0; }

/// Two arguments of one type.
template <class T>
void exchange(int site, T& a, T& b) {
    if (chosen(site, {Form::exchanged}) == 1) std::swap(a, b);
}

/// An argument whose sign is gone, turned round, or which is never less than nothing.
inline void given(int site, double& a) {
    const int slip = chosen(site, {Form::absolute, Form::sign, Form::limit});
    if (slip != 0) a = slip == 1 ? std::fabs(a) : slip == 2 ? -a : std::max(a, 0.0);
}

/// A variable, or another that is there.
template <class T, class... Others>
T pick(int site, const T& one, const Others&... others) {
    if constexpr (std::same_as<T, double> && (std::same_as<Others, double> && ...))
        return pick(site, one, {others...});
    else {
        if (as_written(site)) return one;
        const std::array slips{Slip<T>{if_same<T, Others>(Form::variable), as<T>(others, one)}...};
        return either<T>(site, one, slips.data(), slips.size());
    }
}

}  // namespace checker::slip
