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

/// 0: as written; else the slip, one of `forms`, that is to be made at this place.
int chosen(int site, std::initializer_list<Form> forms);
/// Counts the turns of loops; always true.
bool turn();

/// Is each result to be off by some units of roundoff? And a number that is.
bool rounds();
double rounded(double x);

// Sites that all places of an answer share.
inline constexpr int pi_site = 1, angle_site = 2, single_site = 3, first_free_site = 10;

// Of numbers, in slips.cpp.
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

template <class L, class R>
auto plus(int site, const L& l, const R& r) {
    if constexpr (Number<L> && Number<R> && !Whole<L, R>)
        return plus(site, double(l), double(r));
    else if constexpr (!Terms<L, R>)
        return l + r;
    else {
        using T = Plain<decltype(l + r)>;
        switch (chosen(site, {Form::sign, Form::term, Form::term, Form::twice, Form::half})) {
            case 1:
                return T(l - r);
            case 2:
                return T(l);
            case 3:
                return T(r);
            case 4:
                return T(l + scaled(r, 2));
            case 5:
                return T(l + scaled(r, 0.5));
            default:
                return with_roundoff(T(l + r));
        }
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
        switch (chosen(site, {Form::sign, Form::sign, Form::term, Form::term, Form::twice, Form::half})) {
            case 1:
                return T(l + r);
            case 2:
                return T(r - l);
            case 3:
                return T(l);
            case 4:
                return T(scaled(r, -1));
            case 5:
                return T(l - scaled(r, 2));
            case 6:
                return T(l - scaled(r, 0.5));
            default:
                return with_roundoff(T(l - r));
        }
    }
}

template <class L, class R>
auto times(int site, const L& l, const R& r) {
    if constexpr (Number<L> && Number<R> && !Whole<L, R>)
        return times(site, double(l), double(r));
    else {
        using T = Plain<decltype(l * r)>;
        switch (chosen(site, {scales<T> ? Form::sign : Form::none, scales<T> ? Form::twice : Form::none,
                              scales<T> ? Form::half : Form::none, std::same_as<L, T> ? Form::factor : Form::none,
                              std::same_as<R, T> ? Form::factor : Form::none,
                              std::same_as<L, R> && !scales<T> ? Form::exchanged : Form::none})) {
            case 1:
                return scaled(T(l * r), -1);
            case 2:
                return scaled(T(l * r), 2);
            case 3:
                return scaled(T(l * r), 0.5);
            case 4:
                if constexpr (std::same_as<L, T>) return T(l);
                break;
            case 5:
                if constexpr (std::same_as<R, T>) return T(r);
                break;
            case 6:
                if constexpr (std::same_as<L, R>) return T(r * l);
                break;
            default:
                break;
        }
        if constexpr (Whole<L, R>)
            return T(l * r);
        else
            return T(with_roundoff(l) * with_roundoff(r));  // its own sums may cancel
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
        switch (chosen(site, {Form::sign, Form::twice, Form::half, std::same_as<L, T> ? Form::factor : Form::none,
                              Form::upside_down})) {
            case 1:
                return scaled(T(l / r), -1);
            case 2:
                return scaled(T(l / r), 2);
            case 3:
                return scaled(T(l / r), 0.5);
            case 4:
                if constexpr (std::same_as<L, T>) return T(l);
                break;
            case 5:
                return T(l * r);
            default:
                break;
        }
        if constexpr (Whole<L, R>)
            return T(l / r);
        else
            return with_roundoff(T(l / r));
    }
}

template <class L, class R>
auto rest(int site, L l, R r) {
    if (r == 0) throw Nowhere{};
    return chosen(site, {Form::factor}) == 1 ? decltype(l % r)(l) : l % r;
}

// Is one less than the other? `back`: are the two asked about the other way round; `equal`: counts equality?
template <class L, class R>
bool less(int site, const L& l, const R& r, bool back, bool equal) {
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
struct Plus {
    int site;
};
struct Minus {
    int site;
};
struct Times {
    int site;
};
struct Over {
    int site;
};
struct Rest {
    int site;
};
struct Less {
    int site;
};
struct AtMost {
    int site;
};
struct More {
    int site;
};
struct AtLeast {
    int site;
};
struct Negative {
    int site;
};

template <class Operator, class L>
struct Half {
    L left;
    int site;
};

template <class L>
Half<Plus, Plain<L>> operator+(const L& l, Plus at) {
    return {l, at.site};
}
template <class L, class R>
auto operator+(const Half<Plus, L>& half, const R& r) {
    return plus<L, Plain<R>>(half.site, half.left, r);
}
template <class L>
Half<Minus, Plain<L>> operator-(const L& l, Minus at) {
    return {l, at.site};
}
template <class L, class R>
auto operator-(const Half<Minus, L>& half, const R& r) {
    return minus<L, Plain<R>>(half.site, half.left, r);
}
template <class L>
Half<Times, Plain<L>> operator*(const L& l, Times at) {
    return {l, at.site};
}
template <class L, class R>
auto operator*(const Half<Times, L>& half, const R& r) {
    return times<L, Plain<R>>(half.site, half.left, r);
}
template <class L>
Half<Over, Plain<L>> operator/(const L& l, Over at) {
    return {l, at.site};
}
template <class L, class R>
auto operator/(const Half<Over, L>& half, const R& r) {
    return over<L, Plain<R>>(half.site, half.left, r);
}
template <class L>
Half<Rest, L> operator%(const L& l, Rest at) {
    return {l, at.site};
}
template <class L, class R>
auto operator%(const Half<Rest, L>& half, const R& r) {
    return rest(half.site, half.left, r);
}
template <class L>
Half<Less, L> operator<(const L& l, Less at) {
    return {l, at.site};
}
template <class L, class R>
bool operator<(const Half<Less, L>& half, const R& r) {
    return less(half.site, half.left, r, false, false);
}
template <class L>
Half<AtMost, L> operator<=(const L& l, AtMost at) {
    return {l, at.site};
}
template <class L, class R>
bool operator<=(const Half<AtMost, L>& half, const R& r) {
    return less(half.site, half.left, r, false, true);
}
template <class L>
Half<More, L> operator>(const L& l, More at) {
    return {l, at.site};
}
template <class L, class R>
bool operator>(const Half<More, L>& half, const R& r) {
    return less(half.site, half.left, r, true, false);
}
template <class L>
Half<AtLeast, L> operator>=(const L& l, AtLeast at) {
    return {l, at.site};
}
template <class L, class R>
bool operator>=(const Half<AtLeast, L>& half, const R& r) {
    return less(half.site, half.left, r, true, true);
}

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
        switch (chosen(site, {Form::sign, Form::term, Form::twice, Form::half})) {
            case 1:
                return scaled(T(x), -1);
            case 2:
                return scaled(T(x), 0);
            case 3:
                return scaled(T(x), 2);
            case 4:
                return scaled(T(x), 0.5);
            default:
                return T(x);
        }
    }
}

// Functions of Eigen's: `x ->* Norm{7}`.
struct norm {
    int site;
};
struct squaredNorm {
    int site;
};
struct normalized {
    int site;
};
struct conjugate {
    int site;
};
template <class X>
double operator->*(const X& x, norm at) {
    return chosen(at.site, {Form::function}) == 1 ? x.squaredNorm() : with_roundoff(double(x.norm()));
}
template <class X>
double operator->*(const X& x, squaredNorm at) {
    return chosen(at.site, {Form::function}) == 1 ? x.norm() : with_roundoff(double(x.squaredNorm()));
}
template <class X>
Plain<X> operator->*(const X& x, normalized at) {
    return chosen(at.site, {Form::function}) == 1 ? Plain<X>(x) : with_roundoff(Plain<X>(x.normalized()));
}
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
        static constexpr std::array forms{std::same_as<T, Others> ? Form::variable : Form::none...};
        static_assert(sizeof...(others) <= 6);
        const auto form = [](std::size_t i) { return i < forms.size() ? forms[i] : Form::none; };
        const int slip = chosen(site, {form(0), form(1), form(2), form(3), form(4), form(5)});
        if (slip == 0) return one;
        int at = 0;
        T other = one;
        const auto look = [&](const auto& each) {
            ++at;
            if constexpr (std::same_as<std::decay_t<decltype(each)>, T>)
                if (at == slip) other = each;
        };
        (look(others), ...);
        return other;
    }
}

}  // namespace checker::slip
