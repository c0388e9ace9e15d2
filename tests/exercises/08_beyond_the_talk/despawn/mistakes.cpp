#include "exercise.hpp"

// From one lane to another. A pack holds 3 * width numbers, those of a lane `width` apart.
static void copy(std::vector<double>& packs, int width, int from, int to) {
    for (int part = 0; part < 3; ++part)
        packs[(to / width * 3 + part) * width + to % width] =
            packs[(from / width * 3 + part) * width + from % width];
}

// Says: The lanes left over still hold copies of the body that was the last before.
// Hint: One lane more is left over now, and all of them are copies of the body that is the last now.
namespace stale_tail {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    return packs;
}

}  // namespace stale_tail

// Says: Only the lane that has just become free is filled. The others left over are copies of the body that was the
//       last before.
// Hint: A last pack of 8 lanes with 3 bodies has 5 lanes left over. Fill them all.
namespace one_lane_mended {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    if (int lane = left; lane < used * width) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace one_lane_mended

// Says: The lanes left over are filled before the last body has moved. Where it moves to the place before its own, they
//       hold the body that has gone.
// Hint: Move first. Then ask who is the last, and copy that.
namespace tail_too_early {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    std::vector<double> last(3);
    for (int part = 0; part < 3; ++part)
        last[part] = packs[((n - 1) / width * 3 + part) * width + (n - 1) % width];
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(packs, width, left - 1, lane);
    if (i < left)
        for (int part = 0; part < 3; ++part)
            packs[(i / width * 3 + part) * width + i % width] = last[part];
    return packs;
}

}  // namespace tail_too_early

// Says: The lanes left over are copies of the first lane of their pack.
// Hint: Any body would be safe there, but the rule says the last one: then a new body next to it finds the pack as it
//       expects it.
namespace tail_of_first_lane {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(packs, width, left / width * width, lane);
    return packs;
}

}  // namespace tail_of_first_lane

// Says: The lanes left over are filled with zeros.
// Hint: Those lanes are computed with all the others, and must hold what a body could hold. The last body is at hand.
namespace zero_tail {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane)
        for (int part = 0; part < 3; ++part)
            packs[(lane / width * 3 + part) * width + lane % width] = 0;
    return packs;
}

}  // namespace zero_tail

// Says: A pack without any body is still there.
// Hint: How many packs do n - 1 bodies need? Where n - 1 is a multiple of the width, one fewer than before.
namespace empty_pack_stays {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    const int left = n - 1;
    if (left > 0)
        for (int lane = left; lane < int(packs.size()) / 3; ++lane) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace empty_pack_stays

// Says: Only full packs are counted: a last pack with lanes left over is cut off, and its bodies with it.
// Hint: Division of whole numbers rounds down. Here a part of a pack needs a whole one.
namespace pack_too_few {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    copy(packs, width, n - 1, i);
    const int left = n - 1, used = left / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace pack_too_few

// Says: All bodies behind the one that goes have moved up by one place.
// Hint: Whoever remembers that his body is number 700 would find another one. Only the last body may move.
namespace moved_up {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    std::vector<std::array<double, 3>> bodies;
    for (int b = 0; b < n; ++b) {
        const double* const x = &packs[b / width * width * 3 + b % width];
        if (b != i) bodies.push_back({x[0], x[width], x[2 * width]});
    }
    std::vector<double> result;
    for (int first = 0; first < n - 1; first += width)
        for (std::size_t part = 0; part < 3; ++part)
            for (int lane = first; lane < first + width; ++lane)
                result.push_back(bodies[std::min(lane, n - 2)][part]);
    return result;
}

}  // namespace moved_up

// Says: The last body is gone, and the one that should go is still there.
// Hint: Before the last place is given up, its body must be copied to place i.
namespace not_moved {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace not_moved

// Says: Only the x of the last body moves; y and z are those of the body that should go.
// Hint: A body is three numbers, and they stand width numbers apart.
namespace only_x {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    packs[i / width * 3 * width + i % width] =
        packs[(n - 1) / width * 3 * width + (n - 1) % width];
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace only_x

// Says: Body b is looked for at 3 b, as if the three numbers of a body stood side by side.
// Hint: In a pack the x of all lanes stand side by side. How far is it from the x of a lane to its y?
namespace one_list {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    // A pack holds 3 * width numbers, those of a lane `width` apart.
    const auto copy = [&](int from, int to) {
        for (int part = 0; part < 3; ++part)
            packs[3 * to + part] =
                packs[3 * from + part];
    };
    copy(n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(left - 1, lane);
    return packs;
}

}  // namespace one_list

// Says: Body b is looked for as if the x of all bodies stood first, then all y, then all z.
// Hint: That is so within a pack only. How many numbers stand before the pack that b is in?
namespace whole_columns {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const int lanes = (n + width - 1) / width * width;
    // A pack holds 3 * width numbers, those of a lane `width` apart.
    const auto copy = [&](int from, int to) {
        for (int part = 0; part < 3; ++part)
            packs[part * lanes + to] =
                packs[part * lanes + from];
    };
    copy(n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    if (left > 0)
        for (int lane = left; lane < used * width; ++lane) copy(left - 1, lane);
    packs.resize(3 * width * used);
    return packs;
}

}  // namespace whole_columns

// Says: A pack is taken to hold width numbers. It holds three times as many.
// Hint: Pack 1 begins behind the x, the y and the z of all lanes of pack 0.
namespace narrow_packs {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    // A pack holds 3 * width numbers, those of a lane `width` apart.
    const auto copy = [&](int from, int to) {
        for (int part = 0; part < 3; ++part)
            packs[(to / width + part) * width + to % width] =
                packs[(from / width + part) * width + from % width];
    };
    copy(n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(left - 1, lane);
    return packs;
}

}  // namespace narrow_packs

// Says: It is the last body but one that takes the place: off by one. The last body is lost.
// Hint: Bodies are counted from 0. Which number has the last of n?
namespace last_but_one {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    std::vector<std::array<double, 3>> bodies;
    for (int b = 0; b < n; ++b) {
        const double* const x = &packs[b / width * width * 3 + b % width];
        bodies.push_back({x[0], x[width], x[2 * width]});
    }
    if (n > 1) bodies[i] = bodies[n - 2];
    bodies.pop_back();
    std::vector<double> result;
    for (int first = 0; first < n - 1; first += width)
        for (std::size_t part = 0; part < 3; ++part)
            for (int lane = first; lane < first + width; ++lane)
                result.push_back(bodies[std::min(lane, n - 2)][part]);
    return result;
}

}  // namespace last_but_one

// Says: The last body of the same pack takes the place, and the bodies behind it move up. It is the last body of all
//       that must come.
// Hint: Only one body moves: the one in the last lane that is used, of the last pack.
namespace last_of_its_pack {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    std::vector<std::array<double, 3>> bodies;
    for (int b = 0; b < n; ++b) {
        const double* const x = &packs[b / width * width * 3 + b % width];
        bodies.push_back({x[0], x[width], x[2 * width]});
    }
    const int last = std::min((i / width + 1) * width, n) - 1;
    bodies[i] = bodies[last];
    bodies.erase(bodies.begin() + last);
    std::vector<double> result;
    for (int first = 0; first < n - 1; first += width)
        for (std::size_t part = 0; part < 3; ++part)
            for (int lane = first; lane < first + width; ++lane)
                result.push_back(bodies[std::min(lane, n - 2)][part]);
    return result;
}

}  // namespace last_of_its_pack

// Says: The last pack is too short: it has no lanes left over, and its numbers stand closer together.
// Hint: A pack always holds 3 * width numbers. What stands in the lanes that no body needs?
namespace no_lanes_left_over {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    std::vector<std::array<double, 3>> bodies;
    for (int b = 0; b < n; ++b) {
        const double* const x = &packs[b / width * width * 3 + b % width];
        bodies.push_back({x[0], x[width], x[2 * width]});
    }
    bodies[i] = bodies.back();
    bodies.pop_back();
    std::vector<double> result;
    for (int first = 0; first < n - 1; first += width)
        for (std::size_t part = 0; part < 3; ++part)
            for (int lane = first; lane < std::min(first + width, n - 1); ++lane)
                result.push_back(bodies[std::min(lane, n - 2)][part]);
    return result;
}

}  // namespace no_lanes_left_over

// Says: The list is as long as before: where the last pack loses its only body, it stays, with what stood in it.
// Hint: How many numbers do the packs of n - 1 bodies have? The list of n bodies must shrink to that, by resize say.
namespace length_kept {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    for (int row = 0; row < 3; ++row) {
        const auto at = [&](int body) { return body / width * 3 * width + row * width + body % width; };
        packs[at(i)] = packs[at(n - 1)];
        for (int body = n - 1; body % width != 0; ++body) packs[at(body)] = packs[at(n - 2)];
    }
    return packs;
}

}  // namespace length_kept

// Says: Only two of the three numbers of the last body are moved: one keeps that of the body that is gone.
// Hint: Each body has x, y and z, and they lie `width` apart.
namespace two_of_three {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const double z = packs[static_cast<std::size_t>((i / width * 3 + 2) * width + i % width)];
    copy(packs, width, n - 1, i);
    packs[static_cast<std::size_t>((i / width * 3 + 2) * width + i % width)] = z;
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(packs, width, left - 1, lane);
    return packs;
}

}  // namespace two_of_three
