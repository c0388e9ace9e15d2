#include "exercise.hpp"

// Says: The links pull from the old places: this is semi-implicit Euler, which blows up when the chain is
//       stiff.
// Hint: The force belongs to the x2, which are x1 + h v2. So v2 stands on both sides.
namespace explicit_pull {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::vector<State<double>> old = s;
    for (std::size_t i = 0; i < s.size(); ++i) {
        double force = -k * (old[i].x - (i > 0 ? old[i - 1].x : 0));
        if (i + 1 < s.size()) force += k * (old[i + 1].x - old[i].x);
        s[i].v += h * force / m;
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace explicit_pull

// Says: Each mass is solved alone, as if its neighbours stood still.
// Hint: Their v2 are unknown, too. All equations have to hold at once: first remove one neighbour from each,
//       then go back.
namespace neighbours_stand_still {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = right[i] / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace neighbours_stand_still

// Says: You go down the chain once, with the new velocity of the mass above and the old one of that below.
// Hint: The one below is unknown yet. Write down its equation before you use it; or sweep until nothing
//       changes, which takes long for a stiff chain.
namespace one_sweep {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k;
    std::vector<double> right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
    }
    for (int sweep = 0; sweep < 1; ++sweep)
        for (std::size_t i = 0; i < n; ++i) {
            const double up = i > 0 ? s[i - 1].v : 0, down = i + 1 < n ? s[i + 1].v : 0;
            s[i].v = (right[i] + a * (up + down)) / (m + (i + 1 < n ? 2 : 1) * a);
        }
    for (auto& [t, x, v] : s) t += h, x += h * v;
    return s;
}

}  // namespace one_sweep

// Says: You sweep over the chain twenty times. Soft chains come out right, stiff ones do not: each sweep
//       carries news from one mass to the next.
// Hint: Elimination needs two passes, one down and one up, and has no error.
namespace twenty_sweeps {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k;
    std::vector<double> right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
    }
    for (int sweep = 0; sweep < 20; ++sweep)
        for (std::size_t i = 0; i < n; ++i) {
            const double up = i > 0 ? s[i - 1].v : 0, down = i + 1 < n ? s[i + 1].v : 0;
            s[i].v = (right[i] + a * (up + down)) / (m + (i + 1 < n ? 2 : 1) * a);
        }
    for (auto& [t, x, v] : s) t += h, x += h * v;
    return s;
}

}  // namespace twenty_sweeps

// Says: Elimination is right, but you do not go back up: only the last mass has its true velocity.
// Hint: After the way down each line still has the velocity of the mass below in it.
namespace not_back_up {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = right[i] / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace not_back_up

// Says: On the way down only the right side is changed. What stands before v2 changes as well.
// Hint: You add a multiple of the whole line above, and that line has a v2 of this mass in it.
namespace diagonal_kept {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace diagonal_kept

// Says: The neighbours have the wrong sign: one that flies down pushes this mass up.
// Hint: k (x_above - x) grows with x_above. On the other side of the equation that is a minus.
namespace beside_plus {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace beside_plus

// Says: The last mass hangs between two links: there is none below it.
// Hint: Nothing is below the last mass, not even something that stands still. How many terms has its force?
namespace floor_below {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = (i + 1 < n ? s[i + 1].x : 0) - s[i].x;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 2) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace floor_below

// Says: The force on the last mass is right, but the matrix gives it two links.
// Hint: For the last mass put x2 = x1 + h v2 into the force again. What stands before its v2?
namespace last_has_two {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 2) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace last_has_two

// Says: The chain falls off the ship: the first mass has no link above it.
// Hint: What is above it stands still, at x = 0. Its velocity is known, but its pull is there.
namespace no_ship {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = i > 0 ? s[i - 1].x - s[i].x : 0;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + ((i > 0 ? 1 : 0) + (i + 1 < n ? 1 : 0)) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace no_ship

// Says: The right side lacks the pull at the old places: links that are too long do not pull.
// Hint: x2 = x1 + h v2 has two parts. The one with x1 is known, and goes to the right.
namespace velocities_only {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        right[i] = m * s[i].v;
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace velocities_only

// Says: The pull on the right side lacks its h: it acts for a whole second.
// Hint: h times the force, and the force has x1 and h v2 in it. How many h has each part?
namespace pull_for_a_second {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace pull_for_a_second

// Says: The matrix has h k where h² k belongs.
// Hint: One h comes from force times time, another from x2 = x1 + h v2.
namespace h_once {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace h_once

// Says: At the old places the links push where they should pull.
// Hint: A mass above its neighbours is pulled down. Check the sign of what you brought to the right.
namespace pushed {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v - h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace pushed

// Says: Each mass is taken for one kilogram.
// Hint: m stands before v2 - v1.
namespace mass_forgotten {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = s[i].v + h * k * (above + below);
        diagonal[i] = 1 + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace mass_forgotten

// Says: The velocities are right, but the masses move with their old ones.
// Hint: x2 = x1 + h v2.
namespace moved_by_old_velocity {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].x += h * s[i].v;
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].t += h;
    }
    return s;
}

}  // namespace moved_by_old_velocity

// Says: The masses move, but their clock stands still.
// Hint: At the end it is h later.
namespace clock_stands {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
    }
    return s;
}

}  // namespace clock_stands

// Says: This is explicit Euler: links and masses both go by the old places and velocities.
// Hint: What stands on the right of the equations in the task is taken at the end of the step. Nothing of it
//       is known yet.
namespace explicit_euler {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::vector<State<double>> old = s;
    for (std::size_t i = 0; i < s.size(); ++i) {
        double force = -k * (old[i].x - (i > 0 ? old[i - 1].x : 0));
        if (i + 1 < s.size()) force += k * (old[i + 1].x - old[i].x);
        s[i] = {old[i].t + h, old[i].x + h * old[i].v, old[i].v + h * force / m};
    }
    return s;
}

}  // namespace explicit_euler

// Says: This is the trapezoid rule: it takes the mean of the old and the new forces and velocities.
// Hint: Implicit Euler has no old force, and no old velocity beside v1 itself. A stiff chain must not swing on.
namespace trapezoid {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k / 4;
    std::vector<double> diagonal(n), right(n);
    const auto place = [&](std::size_t i) { return s[i].x + h / 4 * s[i].v; };
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? place(i - 1) : 0) - place(i);
        const double below = i + 1 < n ? place(i + 1) - place(i) : 0;
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
        right[i] = m * s[i].v + h * k * (above + below);
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = a / diagonal[i - 1];
        diagonal[i] -= share * a;
        right[i] += share * right[i - 1];
    }
    double v_below = 0;
    for (std::size_t i = n; i-- > 0;) {
        const double v2 = (right[i] + a * v_below) / diagonal[i];
        s[i] = {s[i].t + h, s[i].x + h / 2 * (s[i].v + v2), v2};
        v_below = v2;
    }
    return s;
}

}  // namespace trapezoid

// Says: A mass alone hangs between two links, as if it were the first of many. Longer chains are right.
// Hint: A mass alone is the first and the last. What is below it?
namespace two_links_alone {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool last = n > 1 && i + 1 == n;
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = last ? 0 : (i + 1 < n ? s[i + 1].x : 0) - s[i].x;
        diagonal[i] = m + (last ? 1 : 2) * a;
        right[i] = m * s[i].v + h * k * (above + below);
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = a / diagonal[i - 1];
        diagonal[i] -= share * a;
        right[i] += share * right[i - 1];
    }
    double v_below = 0;
    for (std::size_t i = n; i-- > 0;) {
        const double v2 = (right[i] + a * v_below) / diagonal[i];
        s[i] = {s[i].t + h, s[i].x + h * v2, v2};
        v_below = v2;
    }
    return s;
}

}  // namespace two_links_alone

// Says: Right to a few digits only: numbers have gone through float, or an iteration ends too early.
// Hint: Use double for every place and every velocity. Elimination, down and up, has no error but roundoff.
namespace single_precision {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    for (auto& [t, x, v] : s) x = static_cast<float>(x), v = static_cast<float>(v);
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        diagonal[i] -= share * beside;
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}

}  // namespace single_precision
