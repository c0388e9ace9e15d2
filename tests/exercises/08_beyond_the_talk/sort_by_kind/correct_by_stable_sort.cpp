#include "exercise.hpp"

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
