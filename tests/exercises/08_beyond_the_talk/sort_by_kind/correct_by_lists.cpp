#include "exercise.hpp"

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
