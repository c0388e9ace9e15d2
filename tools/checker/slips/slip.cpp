#include "slip.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "roundoff.hpp"
#include "slips.hpp"

namespace checker::slip {

namespace {

// What is going on: which slips are to be made, what is noted of the places that are passed, and how much was done.
struct Going {
    const Made* first = nullptr;
    const Made* second = nullptr;
    std::vector<Made>* noted = nullptr;
    std::vector<bool>* passed = nullptr;  // the places among them
    std::uint64_t* roundings = nullptr;   // where each result is off by some
    double constant = 0;                  // by a share of so much a part of a turn may be off
    bool is_single = false;
    long turns = 0, work = 0, most_work = std::numeric_limits<long>::max();
};
Going going;

constexpr long most_turns = 200'000;

// All numbers of a slip that is called single precision have so few digits. Others may be off by a few units, where
// they are not exact.
double out(double x, bool is_exact = false) {
    if (going.roundings && !is_exact) return rounded(x);
    return going.is_single ? double(float(x)) : x;
}

// What rounding leaves out of a sum (Knuth, Moller), a product and a quotient.
bool is_exact_sum(double l, double r) {
    const double sum = l + r, rest = sum - l;
    return (l - (sum - rest)) + (r - rest) == 0;
}
bool is_exact_product(double l, double r) { return std::fma(l, r, -(l * r)) == 0; }
bool is_exact_quotient(double l, double r) { return std::fma(l / r, r, -l) == 0; }

// An angle of which another way to write it takes a part of a turn.
double turned(double x) {
    if (!going.roundings) return x;
    const double off = few_units * std::fabs(x) + going.constant * std::numbers::pi;
    return x + off * (2 * next_share(*going.roundings) - 1);
}

}  // namespace

bool rounds() { return going.roundings != nullptr; }
double rounded(double x) { return x * (1 + few_units * (2 * next_share(*going.roundings) - 1)); }

bool as_written(int site) {
    if (++going.work > going.most_work) throw Nowhere{};
    const auto is_at = [site](const Made* slip) { return slip && slip->site == site; };
    return !going.noted && !is_at(going.first) && !is_at(going.second);
}

int noted(int site, const Form* forms, std::size_t count) {
    if (going.noted) {
        const auto at = static_cast<std::size_t>(site);
        if (at >= going.passed->size()) going.passed->resize(at + 1);
        for (std::size_t i = 0; i < count; ++i)
            if (!(*going.passed)[at] && forms[i] != Form::none) going.noted->push_back({site, int(i) + 1, forms[i]});
        (*going.passed)[at] = true;
    }
    if (going.first && going.first->site == site) return going.first->number;
    if (going.second && going.second->site == site) return going.second->number;
    return 0;
}

bool turn() {
    if (++going.turns > most_turns) throw Nowhere{};
    return true;
}

double plus(int site, double l, double r) {
    const double sum = out(l + r, going.roundings && is_exact_sum(l, r));
    if (as_written(site)) return sum;
    return either(site, sum,
                  {{Form::sign, l - r},
                   {Form::sign, r - l},
                   {Form::term, l},
                   {Form::term, r},
                   {Form::twice, l + 2 * r},
                   {Form::twice, 2 * l + r},
                   {Form::half, l + r / 2},
                   {Form::half, l / 2 + r},
                   {Form::absolute, std::fabs(l + r)}});
}

double minus(int site, double l, double r) {
    const double difference = out(l - r, going.roundings && is_exact_sum(l, -r));
    if (as_written(site)) return difference;
    return either(site, difference,
                  {{Form::sign, l + r},
                   {Form::sign, r - l},
                   {Form::term, l},
                   {Form::term, -r},
                   {Form::twice, l - 2 * r},
                   {Form::twice, 2 * l - r},
                   {Form::half, l - r / 2},
                   {Form::half, l / 2 - r},
                   {Form::sign, -l - r},
                   {Form::absolute, std::fabs(l - r)},
                   {Form::limit, std::max(l - r, 0.0)},
                   {Form::limit, std::min(l - r, 0.0)}});
}

double times(int site, double l, double r) {
    const double product = out(l * r, going.roundings && is_exact_product(l, r));
    if (as_written(site)) return product;
    return either(site, product,
                  {{Form::sign, -(l * r)},
                   {Form::twice, 2 * (l * r)},
                   {Form::half, l * r / 2},
                   {Form::factor, l},
                   {Form::factor, r},
                   {Form::upside_down, l / r},
                   {Form::upside_down, r / l},
                   {Form::power, l * l * r},
                   {Form::power, l * r * r},
                   {Form::absolute, std::fabs(l * r)}});
}

double over(int site, double l, double r) {
    const double quotient = out(l / r, going.roundings && is_exact_quotient(l, r));
    if (as_written(site)) return quotient;
    return either(site, quotient,
                  {{Form::sign, -(l / r)},
                   {Form::twice, 2 * (l / r)},
                   {Form::half, l / r / 2},
                   {Form::factor, l},
                   {Form::factor, 1 / r},
                   {Form::upside_down, l * r},
                   {Form::upside_down, r / l},
                   {Form::power, l * l / r},
                   {Form::power, l / (r * r)}});
}

double added(int site, double x) {
    if (as_written(site)) return out(x, true);
    return either(site, out(x, true), {{Form::sign, -x}, {Form::term, 0.0}, {Form::twice, 2 * x}, {Form::half, x / 2}});
}

double negative(int site, double x) { return chosen(site, {Form::sign}) == 1 ? x : -x; }

double pi() {
    if (as_written(pi_site)) return std::numbers::pi;
    return either(pi_site, std::numbers::pi, {{Form::constant, 3.14}, {Form::constant, 3.1416}});
}

double angle(double x) {
    constexpr double degree = std::numbers::pi / 180;
    if (as_written(angle_site)) return x;
    return either(angle_site, x, {{Form::degrees, x / degree}, {Form::degrees, x * degree}});
}

bool without(int site) { return chosen(site, {Form::guard}) == 1; }

double pick(int site, double one, std::initializer_list<double> others) {
    if (others.size() == 0 || as_written(site)) return one;
    std::array<Slip<double>, 6> slips;
    std::transform(others.begin(), others.end(), slips.begin(), [](double other) {
        return Slip<double>{Form::variable, other};
    });
    return either(site, one, slips.data(), others.size());
}

// A function of a number: what it gives, and what comes of it left out, or of another of its form in its place.
#define TIMESTEP_FUNCTION_THAT_SLIPS(name, written, ...)              \
    double name(int site, double x) {                                 \
        const double y = written;                                     \
        return as_written(site) ? y : either(site, y, {__VA_ARGS__}); \
    }
namespace {

TIMESTEP_FUNCTION_THAT_SLIPS(sine, out(std::sin(turned(x))), {Form::function, std::cos(x)}, {Form::function, x})
TIMESTEP_FUNCTION_THAT_SLIPS(cosine, out(std::cos(turned(x))), {Form::function, std::sin(x)}, {Form::function, x})

}  // namespace

TIMESTEP_FUNCTION_THAT_SLIPS(exp, out(std::exp(x)), {Form::function, x}, {Form::function, std::exp2(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(log, out(std::log(x)), {Form::function, x}, {Form::function, std::log10(x)},
                             {Form::function, std::log2(x)})
// The other of the two leaves out a 1.
TIMESTEP_FUNCTION_THAT_SLIPS(log1p, out(std::log1p(x)), {Form::function, x}, {Form::term, std::log(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(expm1, out(std::expm1(x)), {Form::function, x}, {Form::term, std::exp(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(exp2, out(std::exp2(x)), {Form::function, x}, {Form::function, std::exp(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(log2, out(std::log2(x)), {Form::function, x}, {Form::function, std::log(x)},
                             {Form::function, std::log10(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(cbrt, out(std::cbrt(x)), {Form::function, x}, {Form::function, std::sqrt(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(floor, std::floor(x), {Form::function, std::ceil(x)}, {Form::function, std::round(x)})
TIMESTEP_FUNCTION_THAT_SLIPS(ceil, std::ceil(x), {Form::function, std::floor(x)}, {Form::function, std::round(x)},
                             {Form::edge, std::floor(x) + 1})
#undef TIMESTEP_FUNCTION_THAT_SLIPS
double sin(int site, double x) { return sine(site, angle(x)); }
double cos(int site, double x) { return cosine(site, angle(x)); }
double pow(int site, double x, double y) {
    const double power = out(std::pow(x, y));
    if (as_written(site)) return power;
    return either(site, power,
                  {{Form::function, x},
                   {Form::exchanged, std::pow(y, x)},
                   {Form::upside_down, std::pow(x, -y)},
                   {Form::upside_down, std::pow(x, 1 / y)}});
}
double clamp(int site, double x, double low, double high) {
    const double y = std::max(low, std::min(high, x));
    if (as_written(site)) return y;
    return either(site, y, {{Form::guard, x}, {Form::guard, std::max(x, low)}, {Form::guard, std::min(x, high)}});
}

namespace {

// Nothing where the slip leads nowhere.
Numbers run(const Answer& answer, const Numbers& arguments) {
    going.turns = 0;
    try {
        return answer(arguments);
    } catch (const Nowhere&) {
    } catch (const std::exception&) {  // a vector of less than no length, and the like
    }
    return {};
}

}  // namespace

Numbers rounded(const Answer& answer, const Numbers& arguments, unsigned variation, double constant) {
    std::uint64_t roundings = variation;
    going.roundings = &roundings, going.constant = constant, going.most_work = going.work + most_places;
    Numbers result = run(answer, arguments);
    going = {.work = going.work};
    return result;
}

Numbers answered(const Answer& answer, const Numbers& arguments, const Made& first, const Made* second, long most) {
    const bool is_single = first.form == Form::single;
    going.first = &first, going.second = second, going.is_single = is_single;
    Numbers given = arguments;
    if (is_single)
        for (double& number : given) number = float(number);
    going.most_work = going.work + most;
    Numbers result = run(answer, given);
    if (is_single)
        for (double& number : result) number = float(number);
    going = {.work = going.work};
    return result;
}

long note(const Answer& answer, const Numbers& arguments, std::vector<Made>& noted) {
    std::vector<bool> passed;
    for (const Made& made : noted) {
        passed.resize(std::max(passed.size(), std::size_t(made.site) + 1));
        passed[std::size_t(made.site)] = true;
    }
    const long before = going.work;
    going.noted = &noted, going.passed = &passed, going.most_work = before + most_places;
    run(answer, arguments);
    going = {.work = going.work};
    return going.work - before;
}

long work() { return going.work; }

}  // namespace checker::slip
