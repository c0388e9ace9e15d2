#include "exercise.hpp"

// Says: The position before is left as it is: Verlet will take the way of an old step for that of a new one.
// Hint: With half the step the point would fly on at twice its velocity. Scale the way first, then ask what
//       is still missing.
namespace left_alone {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return before;
}

}  // namespace left_alone

// Says: The displacement is scaled to the new step, the usual repair, and in a run with changing steps its order is
//       one: the force is not used, or has cancelled. Or is there a 1/2? In C++ that is 0: write 0.5.
// Hint: A short step ending now has its middle nearer to now than a long one. Under a force the velocities
//       in the two middles differ.
namespace only_scaled {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old;
}

}  // namespace only_scaled

// Says: The displacement is scaled by h_old / h_new: in slow motion the point gets faster.
// Hint: A shorter step has a shorter way. Try a constant velocity and half the step.
namespace ratio_upside_down {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double ratio = h_old / h_new;
    return now - ratio * (now - before) + h_new * (h_new - h_old) / 2 * a;
}

}  // namespace ratio_upside_down

// Says: The scaling is right, but the force corrects in the wrong direction.
// Hint: Let a stone fall. The middle of a shorter last step lies later than that of a longer one: is the
//       stone faster there, or slower?
namespace other_way_round {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old - h_new * (h_new - h_old) / 2 * a;
}

}  // namespace other_way_round

// Says: The path bends the wrong way. Is the sign of your last term wrong, or is this made for the chapter's step
//       that corrects the time, without the h_new² a that plain Verlet adds of its own?
// Hint: The answer is a place on the path behind the point. On a parabola, where was it one new step ago?
namespace force_twice {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old - h_new * (h_old + h_new) / 2 * a;
}

}  // namespace force_twice

// Says: The velocity over the old step is taken for the velocity now, but it is that of half an old step
//       ago.
// Hint: You go back along a parabola that ends now. Bring the velocity to now first: for how long does the
//       force have to act?
namespace velocity_of_the_middle {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double v = (now - before) / h_old;
    return now - h_new * v + h_new * h_new / 2 * a;
}

}  // namespace velocity_of_the_middle

// Says: Scaled and corrected in the right direction, but by twice as much as is needed.
// Hint: From the middle of one step to the middle of the other, both ending now: how long is that?
namespace whole_kick {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old + h_new * (h_new - h_old) * a;
}

}  // namespace whole_kick

// Says: This is the position one new step after now: the coming step itself.
// Hint: Asked is what to store as "before"; Verlet takes the step. With equal steps the answer is the old
//       "before".
namespace next_position {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now + (now - before) * h_new / h_old + h_new * (h_old + h_new) / 2 * a;
}

}  // namespace next_position

// Says: The velocity now is right, but you follow it back along a straight line: the path is bent. If a term for
//       that is there, is it zero by a 1 / 2? In C++ that is 0.
// Hint: The force acts on the way back, too. What does it add with h_new squared?
namespace straight_back {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double v = (now - before) / h_old + h_old / 2 * a;
    return now - h_new * v;
}

}  // namespace straight_back

// Says: The force has acted for a whole old step upon the velocity over that step, but now is only half a
//       step later.
// Hint: A mean velocity belongs to the middle of its step. How far is it from there to the end?
namespace velocity_too_late {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double v = (now - before) / h_old + h_old * a;
    return now - h_new * v + h_new * h_new / 2 * a;
}

}  // namespace velocity_too_late

// Says: The velocity now is right, but the force bends the way back by h_new² a, twice as much as it should.
// Hint: From rest a stone falls half of a t squared. Where is the half in your last term?
namespace bent_twice {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double v = (now - before) / h_old + h_old / 2 * a;
    return now - h_new * v + h_new * h_new * a;
}

}  // namespace bent_twice

// Says: The way is measured from the old position before, forwards in time; the new one is to end at now.
// Hint: With half the step and no force the answer lies midway. With a tenth of it, is the answer near now or
//       near before?
namespace from_before {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return before + (now - before) * h_new / h_old + h_new * (h_new - h_old) / 2 * a;
}

}  // namespace from_before

// Says: The force comes in with the sum of the two steps, so that it changes something even where they are equal.
//       Is a sign wrong, or is your velocity that of the beginning of the old step?
// Hint: Where nothing changes, nothing needs a correction. And from the middle of the old step, is now later or
//       earlier?
namespace sum_of_the_steps {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old + h_new * (h_old + h_new) / 2 * a;
}

}  // namespace sum_of_the_steps

// Says: The scaling is right, but the force comes in with the difference of the two squares: the scaled
//       displacement has its share of it already.
// Hint: Take your velocity at the middle of the old step, and write down where the middle of the new one
//       lies. How long does the force act in between?
namespace difference_of_squares {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old + (h_new * h_new - h_old * h_old) / 2 * a;
}

}  // namespace difference_of_squares

// Says: The new place before is counted from the old one before. It lies behind the place now.
// Hint: Go back from now, by what the body moves in a new step.
namespace from_the_old_place {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return before - (now - before) * h_new / h_old + h_new * (h_new + h_old) / 2 * a;
}

}  // namespace from_the_old_place

// Says: The correction by the force has the old step before its brackets, where the new one belongs.
// Hint: The displacement is h_new times a velocity. So is what the force adds to it.
namespace correction_with_old_step {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return now - (now - before) * h_new / h_old + h_old * (h_new - h_old) / 2 * a;
}

}  // namespace correction_with_old_step
