#include "exercise.hpp"

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1), order(n);
    if (n <= 1) return {order, begins};
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins;
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i;
    return {order, begins};
}
