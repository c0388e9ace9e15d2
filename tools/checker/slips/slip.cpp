#include "slip.hpp"

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

int shared(int site, Form form, int count) {
    int slip = 0;
    if (count == 1) slip = chosen(site, {form});
    if (count == 2) slip = chosen(site, {form, form});
    return slip;
}

}  // namespace

bool rounds() { return going.roundings != nullptr; }
double rounded(double x) { return x * (1 + few_units * (2 * next_share(*going.roundings) - 1)); }

int chosen(int site, std::initializer_list<Form> forms) {
    if (++going.work > going.most_work) throw Nowhere{};
    if (going.noted) {
        const auto at = static_cast<std::size_t>(site);
        if (at >= going.passed->size()) going.passed->resize(at + 1);
        int number = 0;
        for (const Form form : forms)
            if (++number, !(*going.passed)[at] && form != Form::none) going.noted->push_back({site, number, form});
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
    switch (chosen(site, {Form::sign, Form::sign, Form::term, Form::term, Form::twice, Form::twice, Form::half,
                          Form::half, Form::absolute})) {
        case 1:
            return l - r;
        case 2:
            return r - l;
        case 3:
            return l;
        case 4:
            return r;
        case 5:
            return l + 2 * r;
        case 6:
            return 2 * l + r;
        case 7:
            return l + r / 2;
        case 8:
            return l / 2 + r;
        case 9:
            return std::fabs(l + r);
        default:
            return out(l + r, going.roundings && is_exact_sum(l, r));
    }
}

double minus(int site, double l, double r) {
    switch (chosen(site, {Form::sign, Form::sign, Form::term, Form::term, Form::twice, Form::twice, Form::half,
                          Form::half, Form::sign, Form::absolute, Form::limit, Form::limit})) {
        case 1:
            return l + r;
        case 2:
            return r - l;
        case 3:
            return l;
        case 4:
            return -r;
        case 5:
            return l - 2 * r;
        case 6:
            return 2 * l - r;
        case 7:
            return l - r / 2;
        case 8:
            return l / 2 - r;
        case 9:
            return -l - r;
        case 10:
            return std::fabs(l - r);
        case 11:
            return std::max(l - r, 0.0);
        case 12:
            return std::min(l - r, 0.0);
        default:
            return out(l - r, going.roundings && is_exact_sum(l, -r));
    }
}

double times(int site, double l, double r) {
    switch (chosen(site, {Form::sign, Form::twice, Form::half, Form::factor, Form::factor, Form::upside_down,
                          Form::upside_down, Form::power, Form::power, Form::absolute})) {
        case 1:
            return -(l * r);
        case 2:
            return 2 * (l * r);
        case 3:
            return l * r / 2;
        case 4:
            return l;
        case 5:
            return r;
        case 6:
            return l / r;
        case 7:
            return r / l;
        case 8:
            return l * l * r;
        case 9:
            return l * r * r;
        case 10:
            return std::fabs(l * r);
        default:
            return out(l * r, going.roundings && is_exact_product(l, r));
    }
}

double over(int site, double l, double r) {
    switch (chosen(site, {Form::sign, Form::twice, Form::half, Form::factor, Form::factor, Form::upside_down,
                          Form::upside_down, Form::power, Form::power})) {
        case 1:
            return -(l / r);
        case 2:
            return 2 * (l / r);
        case 3:
            return l / r / 2;
        case 4:
            return l;
        case 5:
            return 1 / r;
        case 6:
            return l * r;
        case 7:
            return r / l;
        case 8:
            return l * l / r;
        case 9:
            return l / (r * r);
        default:
            return out(l / r, going.roundings && is_exact_quotient(l, r));
    }
}

double added(int site, double x) {
    switch (chosen(site, {Form::sign, Form::term, Form::twice, Form::half})) {
        case 1:
            return -x;
        case 2:
            return 0;
        case 3:
            return 2 * x;
        case 4:
            return x / 2;
        default:
            return out(x, true);
    }
}

double negative(int site, double x) { return chosen(site, {Form::sign}) == 1 ? x : -x; }

double pi() {
    const int slip = shared(pi_site, Form::constant, 2);
    return slip == 1 ? 3.14 : slip == 2 ? 3.1416 : std::numbers::pi;
}

double angle(double x) {
    const int slip = shared(angle_site, Form::degrees, 2);
    constexpr double degree = std::numbers::pi / 180;
    return slip == 1 ? x / degree : slip == 2 ? x * degree : x;
}

bool without(int site) { return chosen(site, {Form::guard}) == 1; }

double pick(int site, double one, std::initializer_list<double> others) {
    constexpr Form v = Form::variable;
    int slip = 0;
    switch (others.size()) {
        case 0:
            return one;
        case 1:
            slip = chosen(site, {v});
            break;
        case 2:
            slip = chosen(site, {v, v});
            break;
        case 3:
            slip = chosen(site, {v, v, v});
            break;
        case 4:
            slip = chosen(site, {v, v, v, v});
            break;
        case 5:
            slip = chosen(site, {v, v, v, v, v});
            break;
        default:
            slip = chosen(site, {v, v, v, v, v, v});
    }
    return slip == 0 ? one : others.begin()[slip - 1];
}

// Left out, or another of its form in its place.
double sin(int site, double x) {
    x = angle(x);
    const int slip = chosen(site, {Form::function, Form::function});
    return slip == 1 ? std::cos(x) : slip == 2 ? x : out(std::sin(turned(x)));
}
double cos(int site, double x) {
    x = angle(x);
    const int slip = chosen(site, {Form::function, Form::function});
    return slip == 1 ? std::sin(x) : slip == 2 ? x : out(std::cos(turned(x)));
}
double exp(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function});
    return slip == 1 ? x : slip == 2 ? std::exp2(x) : out(std::exp(x));
}
double log(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function, Form::function});
    return slip == 1 ? x : slip == 2 ? std::log10(x) : slip == 3 ? std::log2(x) : out(std::log(x));
}
// The other of the two leaves out a 1.
double log1p(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::term});
    return slip == 1 ? x : slip == 2 ? std::log(x) : out(std::log1p(x));
}
double expm1(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::term});
    return slip == 1 ? x : slip == 2 ? std::exp(x) : out(std::expm1(x));
}
double exp2(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function});
    return slip == 1 ? x : slip == 2 ? std::exp(x) : out(std::exp2(x));
}
double log2(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function, Form::function});
    return slip == 1 ? x : slip == 2 ? std::log(x) : slip == 3 ? std::log10(x) : out(std::log2(x));
}
double cbrt(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function});
    return slip == 1 ? x : slip == 2 ? std::sqrt(x) : out(std::cbrt(x));
}
double floor(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function});
    return slip == 1 ? std::ceil(x) : slip == 2 ? std::round(x) : std::floor(x);
}
double ceil(int site, double x) {
    const int slip = chosen(site, {Form::function, Form::function, Form::edge});
    return slip == 1 ? std::floor(x) : slip == 2 ? std::round(x) : slip == 3 ? std::floor(x) + 1 : std::ceil(x);
}
double pow(int site, double x, double y) {
    const int slip = chosen(site, {Form::function, Form::exchanged, Form::upside_down, Form::upside_down});
    return slip == 1   ? x
           : slip == 2 ? std::pow(y, x)
           : slip == 3 ? std::pow(x, -y)
           : slip == 4 ? std::pow(x, 1 / y)
                       : out(std::pow(x, y));
}
double clamp(int site, double x, double low, double high) {
    const int slip = chosen(site, {Form::guard, Form::guard, Form::guard});
    return slip == 1   ? x
           : slip == 2 ? std::max(x, low)
           : slip == 3 ? std::min(x, high)
                       : std::max(low, std::min(high, x));
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
