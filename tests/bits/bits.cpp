// The table of bits: every method on every model, and every rule for a body that turns, in float and in double. Two
// desks whose tables are the same may play in lockstep, as far as this library goes.
#include "hash.hpp"

int main() {
    print_points();
    print_systems();
    print_bodies();
    print_plain();
    print_others();
    print_math();
}
