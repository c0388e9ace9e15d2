// The table of bits: every method on every model, and every rule for a body that turns, in float and in double. Two
// desks whose tables are the same may play in lockstep, as far as this library goes. One file for the compiler: most of
// what it takes is to read Eigen.
#include "bodies.hpp"
#include "math.hpp"
#include "others.hpp"
#include "plain.hpp"
#include "points.hpp"
#include "systems.hpp"

int main() {
    points::print_rows();
    systems::print_rows();
    bodies::print_rows();
    plain::print_rows();
    others::print_rows();
    math::print_rows();
}
