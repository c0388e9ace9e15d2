#include "exercise.hpp"

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    // The sums say where the groups end; filled from the back, they end as where the groups begin.
    std::vector<int> places(count + 1), order(kinds.size());
    for (int kind : kinds) ++places[kind];
    for (int k = 1; k <= count; ++k) places[k] += places[k - 1];
    for (int i = static_cast<int>(kinds.size()) - 1; i >= 0; --i) order[--places[kinds[i]]] = i;
    return {order, places};
}
