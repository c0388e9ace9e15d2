#include "exercise.hpp"

using Chain = std::vector<State<double>>;

// The equations of a step, as they should be: in line i `diagonal[i]` stands before v2 of that mass and `beside` before
// those of its neighbours. `solve` goes down and up.
struct Lines {
    std::vector<double> diagonal, right;
    double beside;

    Lines(const Chain& s, double m, double k, double h, double pull) : diagonal(s.size()), right(s.size()), beside(-h * h * k) {
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
            const double below = i + 1 < s.size() ? s[i + 1].x - s[i].x : 0;
            right[i] = m * s[i].v + pull * (above + below);
            diagonal[i] = m - (i + 1 < s.size() ? 2 : 1) * beside;
        }
    }
    Lines(const Chain& s, double m, double k, double h) : Lines(s, m, k, h, h * k) {}

    void down() {
        for (std::size_t i = 1; i < diagonal.size(); ++i) {
            const double share = beside / diagonal[i - 1];
            diagonal[i] -= share * beside;
            right[i] -= share * right[i - 1];
        }
    }
    std::vector<double> up() const {
        std::vector<double> v2(right.size());
        for (std::size_t i = v2.size(); i-- > 0;)
            v2[i] = (right[i] - (i + 1 < v2.size() ? beside * v2[i + 1] : 0)) / diagonal[i];
        return v2;
    }
    std::vector<double> solved() {
        down();
        return up();
    }
};

static Chain moved(Chain s, double h, const std::vector<double>& v2) {
    for (std::size_t i = 0; i < s.size(); ++i) s[i] = {s[i].t + h, s[i].x + h * v2[i], v2[i]};
    return s;
}

// By so many sweeps over the chain, each mass with what its neighbours have by then.
static Chain swept(Chain s, double m, double k, double h, int sweeps) {
    const Lines lines(s, m, k, h);
    const std::size_t n = s.size();
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < n; ++i) {
            const double up = i > 0 ? s[i - 1].v : 0, down = i + 1 < n ? s[i + 1].v : 0;
            s[i].v = (lines.right[i] - lines.beside * (up + down)) / lines.diagonal[i];
        }
    for (auto& [t, x, v] : s) t += h, x += h * v;
    return s;
}

// The pull of both links of each mass.
static std::vector<double> pulls(const Chain& s, double k) {
    return Lines(s, 0, k, 0, k).right;
}

// Says: The links pull from the old places: this is semi-implicit Euler, which blows up when the chain is stiff.
// Hint: The force belongs to the x2, which are x1 + h v2. So v2 stands on both sides.
namespace explicit_pull {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    std::vector<double> v2 = pulls(s, k);
    for (std::size_t i = 0; i < s.size(); ++i) v2[i] = s[i].v + h * v2[i] / m;
    return moved(s, h, v2);
}

}  // namespace explicit_pull

// Says: Each mass is solved alone, as if its neighbours stood still.
// Hint: Their v2 are unknown, too. All equations have to hold at once: first remove one neighbour from each, then go
//       back.
namespace neighbours_stand_still {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    lines.beside = 0;
    return moved(s, h, lines.solved());
}

}  // namespace neighbours_stand_still

// Says: You go down the chain once, with the new velocity of the mass above and the old one of that below.
// Hint: The one below is unknown yet. Write down its equation before you use it; or sweep until nothing changes, which
//       takes long for a stiff chain.
namespace one_sweep {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return swept(s, m, k, h, 1);
}

}  // namespace one_sweep

// Says: You sweep over the chain twenty times. Soft chains come out right, stiff ones do not: each sweep carries news
//       from one mass to the next.
// Hint: Elimination needs two passes, one down and one up, and has no error.
namespace twenty_sweeps {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return swept(s, m, k, h, 20);
}

}  // namespace twenty_sweeps

// Says: Elimination is right, but you do not go back up: only the last mass has its true velocity.
// Hint: After the way down each line still has the velocity of the mass below in it.
namespace not_back_up {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    lines.down();
    lines.beside = 0;
    return moved(s, h, lines.up());
}

}  // namespace not_back_up

// Says: On the way down only the right side is changed. What stands before v2 changes as well.
// Hint: You add a multiple of the whole line above, and that line has a v2 of this mass in it.
namespace diagonal_kept {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    const std::vector<double> diagonal = lines.diagonal;
    for (std::size_t i = 1; i < s.size(); ++i) lines.right[i] -= lines.beside / diagonal[i - 1] * lines.right[i - 1];
    return moved(s, h, lines.up());
}

}  // namespace diagonal_kept

// Says: The neighbours have the wrong sign: one that flies down pushes this mass up.
// Hint: k (x_above - x) grows with x_above. On the other side of the equation that is a minus.
namespace beside_plus {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    lines.beside = -lines.beside;
    return moved(s, h, lines.solved());
}

}  // namespace beside_plus

// Says: The last mass hangs between two links: there is none below it.
// Hint: Nothing is below the last mass, not even something that stands still. How many terms has its force?
namespace floor_below {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    lines.diagonal.back() -= lines.beside;
    lines.right.back() -= h * k * s.back().x;
    return moved(s, h, lines.solved());
}

}  // namespace floor_below

// Says: The force on the last mass is right, but the matrix gives it two links.
// Hint: For the last mass put x2 = x1 + h v2 into the force again. What stands before its v2?
namespace last_has_two {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    lines.diagonal.back() -= lines.beside;
    return moved(s, h, lines.solved());
}

}  // namespace last_has_two

// Says: The chain falls off the ship: the first mass has no link above it.
// Hint: What is above it stands still, at x = 0. Its velocity is known, but its pull is there.
namespace no_ship {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    lines.diagonal.front() += lines.beside;
    lines.right.front() += h * k * s.front().x;
    return moved(s, h, lines.solved());
}

}  // namespace no_ship

// Says: The right side lacks the pull at the old places: links that are too long do not pull.
// Hint: x2 = x1 + h v2 has two parts. The one with x1 is known, and goes to the right.
namespace velocities_only {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h, 0);
    return moved(s, h, lines.solved());
}

}  // namespace velocities_only

// Says: The pull on the right side lacks its h: it acts for a whole second.
// Hint: h times the force, and the force has x1 and h v2 in it. How many h has each part?
namespace pull_for_a_second {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h, k);
    return moved(s, h, lines.solved());
}

}  // namespace pull_for_a_second

// Says: The matrix has h k where h² k belongs.
// Hint: One h comes from force times time, another from x2 = x1 + h v2.
namespace h_once {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, std::sqrt(h), h * k);
    return moved(s, h, lines.solved());
}

}  // namespace h_once

// Says: At the old places the links push where they should pull.
// Hint: A mass above its neighbours is pulled down. Check the sign of what you brought to the right.
namespace pushed {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h, -h * k);
    return moved(s, h, lines.solved());
}

}  // namespace pushed

// Says: Each mass is taken for one kilogram.
// Hint: m stands before v2 - v1.
namespace mass_forgotten {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, 1, k, h);
    return moved(s, h, lines.solved());
}

}  // namespace mass_forgotten

// Says: The velocities are right, but the masses move with their old ones.
// Hint: x2 = x1 + h v2.
namespace moved_by_old_velocity {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    const std::vector<double> v2 = lines.solved();
    for (std::size_t i = 0; i < s.size(); ++i) s[i] = {s[i].t + h, s[i].x + h * s[i].v, v2[i]};
    return s;
}

}  // namespace moved_by_old_velocity

// Says: The masses move, but their clock stands still.
// Hint: At the end it is h later.
namespace clock_stands {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    const std::vector<double> v2 = lines.solved();
    for (std::size_t i = 0; i < s.size(); ++i) s[i].x += h * v2[i], s[i].v = v2[i];
    return s;
}

}  // namespace clock_stands

// Says: This is explicit Euler: links and masses both go by the old places and velocities.
// Hint: What stands on the right of the equations in the task is taken at the end of the step. Nothing of it is known
//       yet.
namespace explicit_euler {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::vector<double> force = pulls(s, k);
    for (std::size_t i = 0; i < s.size(); ++i) s[i] = {s[i].t + h, s[i].x + h * s[i].v, s[i].v + h * force[i] / m};
    return s;
}

}  // namespace explicit_euler

// Says: This is the trapezoid rule, or implicit midpoint, which is the same here: it takes the mean of the old and
//       the new forces and velocities.
// Hint: Implicit Euler has no old force, and no old velocity beside v1 itself. A stiff chain must not swing on.
namespace trapezoid {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Chain half = s;  // its matrix is that of half the step
    for (auto& [t, x, v] : half) x += h / 4 * v;
    Lines lines(half, m, k, h / 2, h * k);
    const std::vector<double> v2 = lines.solved();
    for (std::size_t i = 0; i < s.size(); ++i) s[i] = {s[i].t + h, s[i].x + h / 2 * (s[i].v + v2[i]), v2[i]};
    return s;
}

}  // namespace trapezoid

// Says: A mass alone hangs between two links, as if it were the first of many. Longer chains are right.
// Hint: A mass alone is the first and the last. What is below it?
namespace two_links_alone {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    if (s.size() == 1) {
        lines.diagonal[0] -= lines.beside;
        lines.right[0] -= h * k * s[0].x;
    }
    return moved(s, h, lines.solved());
}

}  // namespace two_links_alone

// Says: Right to a few digits only: numbers have gone through float, or an iteration ends too early.
// Hint: Use double for every place and every velocity. Elimination, down and up, has no error but roundoff.
namespace single_precision {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    for (auto& [t, x, v] : s) x = static_cast<float>(x), v = static_cast<float>(v);
    Lines lines(s, m, k, h);
    return moved(s, h, lines.solved());
}

}  // namespace single_precision

// Says: At the old places only the link above pulls a mass; the one below is forgotten there.
// Hint: What is k (x_below - x) with x1 in it? It goes to the right side, beside the pull from above.
namespace below_does_not_pull {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    Lines lines(s, m, k, h);
    for (std::size_t i = 0; i + 1 < s.size(); ++i) lines.right[i] -= h * k * (s[i + 1].x - s[i].x);
    return moved(s, h, lines.solved());
}

}  // namespace below_does_not_pull

// Says: Each mass is pulled by the link above it alone: what hangs below it does not pull it down.
// Hint: A link pulls both its ends. How many terms has the force on a mass in the middle?
namespace no_link_below {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    double v_above = 0, x_above = 0;
    for (auto& [t, x, v] : s) {
        const double pull = h * k * (x_above - x);
        x_above = x;
        v = v_above = (m * v + pull + h * h * k * v_above) / (m + h * h * k);
        t += h, x += h * v;
    }
    return s;
}

}  // namespace no_link_below

// The clock stands still, and something else is wrong beside it.
static Chain at_the_old_time(Chain next, const Chain& s) {
    for (std::size_t i = 0; i < next.size(); ++i) next[i].t = s[i].t;
    return next;
}

// Says: Two things are wrong: the clock stands still, and the links pull from the old places.
// Hint: At the end t is h later. And the force belongs to the x2, which are x1 + h v2: so v2 stands on both sides.
namespace clock_stands_and_explicit_pull {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return at_the_old_time(explicit_pull::chain_step(s, m, k, h), s);
}

}  // namespace clock_stands_and_explicit_pull

// Says: Two things are wrong: the clock stands still, and the last mass hangs between two links.
// Hint: At the end t is h later. And how many terms has the force on the mass that has nothing below it?
namespace clock_stands_and_floor_below {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return at_the_old_time(floor_below::chain_step(s, m, k, h), s);
}

}  // namespace clock_stands_and_floor_below

// Says: Two things are wrong: the clock stands still, and you go down the chain once, with the old velocity of the mass below.
// Hint: At the end t is h later. And the v2 of the mass below is unknown yet: a second pass, from the last mass up, finds it.
namespace clock_stands_and_one_sweep {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return at_the_old_time(one_sweep::chain_step(s, m, k, h), s);
}

}  // namespace clock_stands_and_one_sweep

// Says: Two things are wrong: the clock stands still, and the masses move with their old velocities.
// Hint: At the end t is h later, and x2 = x1 + h v2.
namespace clock_stands_and_moved_by_old_velocity {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return at_the_old_time(moved_by_old_velocity::chain_step(s, m, k, h), s);
}

}  // namespace clock_stands_and_moved_by_old_velocity
