#include "NEW_NAME.hpp"

#include "property.hpp"

EXERCISE(NEW_NAME);

// FILL IN: what every right answer has; the learner is told the first that does not hold.
PROPERTY("a body at rest stays where it is") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double x = draw.real(-10, 10), h = draw.log(1e-3, 1);
        REQUIRE(close(learner(x, 0, h), x, 1e-15));
    }
}

// Both terms are below 10: one product and one sum are rounded.
PROPERTY("a body goes its velocity times the step") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), v = draw.real(-10, 10), h = draw.log(1e-3, 1);
        REQUIRE(close(learner(x, v, h) - x, v * h, 0, 1e-14));
    }
}
