#include "exercise.hpp"

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    std::vector<int> order, begins{0};
    for (int k = 0; k + 1 < count; ++k) {
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (kinds[i] == k) order.push_back(static_cast<int>(i));
        begins.push_back(static_cast<int>(order.size()));
    }
    begins.push_back(static_cast<int>(order.size()));
    return {order, begins};
}
