#include "exercise_eigen.hpp"

// Says: The two ends share the excess in halves, as the points of the chapter's rope do: their masses are
//       not used, only whether they are held.
// Hint: The same pull moves a lighter body further. Let a have a hundred times the mass of b: which of them
//       moves?
namespace halves {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d half = (distance - length) / 2 * (apart / distance);
    if (wa == 0) return {a, b - 2 * half};
    if (wb == 0) return {a + 2 * half, b};
    return {a + half, b - half};
}

}  // namespace halves

// Says: The shares are exchanged: the heavier end moves further, and the wall comes to the player.
// Hint: wa is the inverse of a mass. The larger wa is, the lighter is a, and the further it moves.
namespace heavier_moves_more {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wb * pull, b - wa * pull};
}

}  // namespace heavier_moves_more

// Says: This is a rod: it also pushes the ends apart when they are nearer than its length.
// Hint: A loose rope does nothing. Ask whether it is too long before you move anything.
namespace pushes {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance == 0 || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace pushes

// Says: Each end moves by its inverse mass times the excess. Nothing makes the two parts add up to the
//       whole.
// Hint: A length in metres times 1/kg is no length. Divide by something that has that unit, too.
namespace no_sum {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace no_sum

// Says: The excess is measured again after the first end has moved, so that the second takes its share of
//       what is left only.
// Hint: Both shares are parts of the same excess. Compute it once, from the two positions given, before
//       either moves.
namespace one_after_the_other {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    a += wa / (wa + wb) * (distance - length) * (apart / distance);
    const Vector3d rest = b - a;
    b -= wb / (wa + wb) * (rest.norm() - length) * rest.normalized();
    return {a, b};
}

}  // namespace one_after_the_other

// Says: Right, except for a rope between two walls: there the sum of the inverse masses is zero, and you
//       divide by it.
// Hint: What can a rope move when both of its ends are held?
namespace both_held {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace both_held

// Says: The excess is multiplied by the whole vector between the ends, not by its direction: long ropes are
//       pulled too hard.
// Hint: A direction has the length one. The vector from a to b has the length of the rope.
namespace not_a_direction {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * apart;
    return {a + wa * pull, b - wb * pull};
}

}  // namespace not_a_direction

// Says: The ends move away from each other: a rope that is too long gets longer.
// Hint: The vector b - a leads from a to b. Along which way does a come nearer, and along which does b?
namespace apart_instead {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a - wa * pull, b + wb * pull};
}

}  // namespace apart_instead

// Says: The ends share the excess in halves, a wall as well: neither the masses nor what is held counts.
// Hint: The shares are wa and wb over their sum. What does that give for a wall?
namespace halves_of_walls_too {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + (wa + wb) / 2 * pull, b - (wa + wb) / 2 * pull};
}

}  // namespace halves_of_walls_too

// Says: The square of the distance is taken for the distance: the root is missing.
// Hint: Eigen has norm() and squaredNorm(). Which of them is in metres?
namespace squared_distance {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.squaredNorm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace squared_distance

// Says: Only b is moved: a is treated as a wall, whatever its mass.
// Hint: Both ends are pulled. Let b be a wall: what moves then?
namespace only_b_moves {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    if ((b - a).norm() <= length || wa + wb == 0) return {a, b};
    return {a, a + length * (b - a).normalized()};
}

}  // namespace only_b_moves

// Says: Only a is moved: b is treated as a wall, whatever its mass.
// Hint: The crate at the other end is pulled as well. Let a be a wall: what moves then?
namespace only_a_moves {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    if ((b - a).norm() <= length || wa + wb == 0) return {a, b};
    return {b - length * (b - a).normalized(), b};
}

}  // namespace only_a_moves

// Says: The comparison is the wrong way round: loose ropes are stretched, and tight ones left as they are.
// Hint: When is there something to do for a rope: when its ends are nearer than its length, or farther?
namespace upside_down {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance >= length || distance == 0 || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace upside_down

// Says: The ends move by half of what they should: after it the rope is still too long by half of the excess.
// Hint: The shares wa and wb over their sum add up to one already. What is the 2 for?
namespace half_of_the_excess {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / 2 / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace half_of_the_excess

// Says: Both ends move in the same direction: one of them comes nearer, and the other one flees.
// Hint: The pull on b is opposite to the pull on a. Which sign has it?
namespace same_direction {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wa * pull, b + wb * pull};
}

}  // namespace same_direction

// Says: The ends move by the rope's length, not by what it is too long.
// Hint: A rope that is too long by a hair should move by a hair. What does yours do?
namespace length_for_the_excess {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = length / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
}

}  // namespace length_for_the_excess

// Says: The distance is found without a square root, by a formula that is right only for a rope that is hardly too long.
// Hint: Afterwards the ends must be one length apart, whatever they were before. Take the root.
namespace without_a_root {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double square = apart.squaredNorm(), wanted = length * length;
    if (square <= wanted || wa + wb == 0) return {a, b};
    const Vector3d pull = (square - wanted) / ((square + wanted) * (wa + wb)) * apart;
    return {a + wa * pull, b - wb * pull};
}

}  // namespace without_a_root
