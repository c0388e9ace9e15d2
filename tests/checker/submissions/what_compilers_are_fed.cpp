// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a main of its own
// velocity_now does_not_compile: The file has a main of its own
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

int main() {}

// ---- a syntax error
// velocity_now does_not_compile: error: expected
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h){return (x2 - x1) / h}
// ---- an answer that is too long
// steps_of_frames left_early: The answer was too long, 9000001 numbers, in the call steps_of_frames(
#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return std::vector<int>(9'000'000);
}

// ---- an empty file
// velocity_now does_not_compile: The file has no function

// ---- static
// velocity_now does_not_compile: It has a function of that name, but it is static
#include "exercise.hpp"

static double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- inline
// velocity_now does_not_compile: It has a function of that name, but it is inline
#include "exercise.hpp"

inline double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- in a namespace
// velocity_now does_not_compile: It has a function of that name, but in the namespace mine
#include "exercise.hpp"

namespace mine {

double twice(double x) { return 2 * x; }

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / twice(h); }

}  // namespace mine

// ---- in a namespace without a name
// velocity_now does_not_compile: It has a function of that name, but in a namespace without a name
#include "exercise.hpp"

namespace {

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

}  // namespace

// ---- a template
// velocity_now does_not_compile: It has a function of that name, but it is a template
#include "exercise.hpp"

template <class T>
T velocity_now(T x0, T x1, T x2, T h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- in a class
// velocity_now does_not_compile: It has a function of that name, but as a part of Frames
#include "exercise.hpp"

struct Frames {
    static double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }
};

// ---- an unused variable
// velocity_now pass: The compiler remarks:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const double middle = (x2 - x0) / 2;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- another signature
// velocity_now does_not_compile: double velocity_now(double x0, double x1, double x2, double h)
#include "exercise.hpp"

double velocity_now(float x0, float x1, float x2, float h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- brings code for the linkers own compiler
// velocity_now pass
#include "exercise.hpp"

asm(".section .gnu.lto_.opts,\"e\",@progbits\n.string \"none\"\n"
    ".section .gnu.lto_.symtab.0,\"e\",@progbits\n.asciz \"main\"\n.skip 64\n"
    ".section .gnu.lto_main.0,\"e\",@progbits\n.string \"none\"\n.text");

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- compiles without end by a loop
// velocity_now does_not_compile: constexpr
#include "exercise.hpp"

constexpr int endless() {
    int sum = 0;
    for (int i = 0;; ++i) sum += i % 2;
    return sum;
}

double velocity_now(double, double, double, double) {
    constexpr int sum = endless();
    return sum;
}

// ---- compiles without end by recursion
// velocity_now does_not_compile: depth
#include "exercise.hpp"

template <int n>
struct Deeper : Deeper<n + 1> {};

double velocity_now(double, double, double, double) { return Deeper<0>().size; }

// ---- compiles without end by templates
// velocity_now does_not_compile: had not come to an end after 9 s of work
#include "exercise.hpp"

template <int depth, long path>
struct Tree {
    static constexpr int size = Tree<depth - 1, 2 * path>::size + Tree<depth - 1, 2 * path + 1>::size;
};
template <long path>
struct Tree<0, path> {
    static constexpr int size = 1;
};

double velocity_now(double, double, double, double) { return Tree<40, 1>::size; }

// ---- compiles without end by words that double
// velocity_now does_not_compile
#include "exercise.hpp"

#define a0 0,
#define a1 a0 a0 a0 a0 a0 a0 a0 a0
#define a2 a1 a1 a1 a1 a1 a1 a1 a1
#define a3 a2 a2 a2 a2 a2 a2 a2 a2
#define a4 a3 a3 a3 a3 a3 a3 a3 a3
#define a5 a4 a4 a4 a4 a4 a4 a4 a4
#define a6 a5 a5 a5 a5 a5 a5 a5 a5
#define a7 a6 a6 a6 a6 a6 a6 a6 a6
#define a8 a7 a7 a7 a7 a7 a7 a7 a7
#define a9 a8 a8 a8 a8 a8 a8 a8 a8
#define a10 a9 a9 a9 a9 a9 a9 a9 a9
#define a11 a10 a10 a10 a10 a10 a10 a10 a10
#define a12 a11 a11 a11 a11 a11 a11 a11 a11

double velocity_now(double, double, double, double) {
    static const int numbers[] = {a12};
    return numbers[0];
}

// ---- has a main in assembler
// velocity_now does_not_compile: The file has a main of its own
#include "exercise.hpp"

asm(".globl main\nmain:\n    ret");

double velocity_now(double, double, double, double) { return 0; }

// ---- includes a right answer of the tests
// velocity_now does_not_compile: includes tests/exercises/01_derivatives/velocity_now/correct.cpp
#include "exercise.hpp"

#include "SOURCE/tests/exercises/01_derivatives/velocity_now/correct.cpp"

// ---- includes endless zeros
// velocity_now does_not_compile
#include "exercise.hpp"

#include "/dev/zero"

// ---- includes the compilers own memory
// velocity_now does_not_compile
#include "exercise.hpp"

#include "/proc/self/mem"

// ---- includes the hidden tests
// velocity_now does_not_compile: properties.cpp
#include "exercise.hpp"

#include "SOURCE/tests/exercises/01_derivatives/velocity_now/properties.cpp"

// ---- includes the solution
// velocity_now does_not_compile: includes solutions/01_derivatives/velocity_now.cpp
#include "exercise.hpp"

#include "SOURCE/solutions/01_derivatives/velocity_now.cpp"

// ---- includes what it is typed
// velocity_now wrong: returned 0; right is
// graded: does_not_compile
#include "exercise.hpp"

#include "/dev/stdin"

double velocity_now(double, double, double, double) { return 0; }

// ---- includes what the compiler says
// velocity_now does_not_compile: No such device or address
#include "exercise.hpp"

#include "/proc/self/fd/1"

// ---- includes what the library has
// half_step_jacobian does_not_compile: includes include/timestep/gyroscopic/half_step_jacobian.hpp
#include "exercise_eigen.hpp"

#include <timestep/gyroscopic/half_step_jacobian.hpp>

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const timestep::PrincipalInertia<double> body(inertia.x(), inertia.y(), inertia.z());
    return timestep::half_step_jacobian.step(body, omega, h);
}

// ---- makes every double a float
// velocity_now does_not_compile: The file has no function
#include "exercise.hpp"

#define double float

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- makes not started a number
// velocity_now wrong: returned 0; right is
#include "exercise.hpp"

#define not_started 0
#undef NAN
#undef HUGE_VAL

double velocity_now(double, double, double, double) { return not_started; }

// ---- returns a float
// velocity_now does_not_compile: otherwise than the exercise does: double velocity_now(double x0,
#include "exercise.hpp"

float velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- returns a long double
// velocity_now does_not_compile: otherwise than the exercise does: double velocity_now(double x0,
#include "exercise.hpp"

long double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- returns an int
// velocity_now does_not_compile: otherwise than the exercise does: double velocity_now(double x0,
#include "exercise.hpp"

int velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- returns auto
// velocity_now does_not_compile: otherwise than the exercise does: double velocity_now(double x0,
#include "exercise.hpp"

auto velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- returns nothing
// velocity_now does_not_compile: The type it returns, name and arguments must stay as they were.
#include "exercise.hpp"

void velocity_now(double, double, double, double) {}
