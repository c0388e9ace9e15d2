#include "exercise.hpp"

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> size(count + 1), next(count + 1), order(n);
    for (int kind : kinds) ++size[kind];
    for (int k = 0; k < count; ++k) next[k + 1] = next[k] + size[k];
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i;
    size[count] = n;
    return {order, size};
}
