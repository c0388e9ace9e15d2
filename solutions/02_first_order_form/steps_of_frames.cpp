// Chapter 2, exercise 3: how many steps each frame takes
//
// A replay tells how long each frame of a game took. The game ran in steps of one length behind an
// accumulator. Find out how many steps each frame took.
//
// At first nothing is owed. A frame adds its time to what is owed and pays in whole steps. A step
// that is owed in full, to the last bit, is taken now and not later. No frame takes more than
// `most_steps`. If there is a whole step or more left to pay then, whole steps are dropped until
// less than one step is owed, and that remainder stays owed.
//
//   frames      how long each frame took, in s: from zero to a million steps; the list may be empty
//   step        length of a step, above zero, in s
//   most_steps  the most that one frame may take, 1 or more
//   returns     how many steps each frame took: as many numbers as there are frames
//
// Example: frames of 0.75, 0.75, 5.25 and 0.75 s with a step of 0.5 s and at most 3 steps give 1,
// 2, 3 and 2.
//
// What is checked: one number for each frame; frames that are longer than a step, as long, and
// shorter, if only by the last bit; the simulation is never ahead of the clock, and less than one
// step behind it; the cap; after a hitch the remainder is kept and whole steps are not. All times
// that are drawn are binary fractions, which add and subtract without rounding. One hitch lasts for
// nearly a million steps.

#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    // [answer]
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);  // the cap drops whole steps
        steps.push_back(count);
    }
    return steps;
    // [answer]
}
