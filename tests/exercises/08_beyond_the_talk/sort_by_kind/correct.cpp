#include "exercise.hpp"

namespace by_lists {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    std::vector<std::vector<int>> groups(count);
    for (std::size_t i = 0; i < kinds.size(); ++i) groups[kinds[i]].push_back(static_cast<int>(i));
    std::vector<int> order, begins{0};
    for (const auto& group : groups) {
        order.insert(order.end(), group.begin(), group.end());
        begins.push_back(static_cast<int>(order.size()));
    }
    return {order, begins};
}

}  // namespace by_lists

namespace by_stable_sort {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    std::vector<int> order;
    for (std::size_t i = 0; i < kinds.size(); ++i) order.push_back(static_cast<int>(i));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return kinds[a] < kinds[b]; });
    std::vector<int> begins;
    for (int k = 0; k <= count; ++k) {
        const auto lower = [&](int kind) { return kind < k; };
        begins.push_back(static_cast<int>(std::count_if(kinds.begin(), kinds.end(), lower)));
    }
    return {order, begins};
}

}  // namespace by_stable_sort

namespace from_the_back {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    // The sums say where the groups end; filled from the back, they end as where the groups begin.
    std::vector<int> places(count + 1), order(kinds.size());
    for (int kind : kinds) ++places[kind];
    for (int k = 1; k <= count; ++k) places[k] += places[k - 1];
    for (int i = static_cast<int>(kinds.size()) - 1; i >= 0; --i) order[--places[kinds[i]]] = i;
    return {order, places};
}

}  // namespace from_the_back
