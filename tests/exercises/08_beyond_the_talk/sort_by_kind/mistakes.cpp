#include "exercise.hpp"

// Says: order tells of each body where it goes. It is asked the other way round: which body stands at a
//       place.
// Hint: You know the place and the body at the same moment. Which of the two is the index, and which the
//       value?
namespace place_of_body {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[i] = next[kinds[i]]++;
    return {order, begins};
}

}  // namespace place_of_body

// Says: In each group the bodies stand backwards: the last of a kind comes first.
// Hint: Stable means that the first of a kind comes first. Are the bodies taken from the last to the first, and
//       each group filled from its front? Or is there a <= in the comparison of a sort? It must say no of equals.
namespace backwards_in_groups {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = n - 1; i >= 0; --i) order[next[kinds[i]]++] = i;
    return {order, begins};
}

}  // namespace backwards_in_groups

// Says: This sorts with std::sort, which may swap bodies of one kind.
// Hint: With few bodies it seems to keep their order, with more it does not. A body's own number could
//       decide between equals, or you need no comparison at all.
namespace unstable {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> order(n);
    for (int i = 0; i < n; ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](int a, int b) { return kinds[a] < kinds[b]; });
    return {order, begins};
}

}  // namespace unstable

// Says: begins tells where each group ends. Have its numbers moved on while the groups were filled, or is each group
//       in its own sum?
// Hint: Where does kind 0 begin, however many bodies are of it? Look at your begins[0] before the groups are filled,
//       and after.
namespace begins_moved {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> order(n);
    for (int i = 0; i < n; ++i) order[begins[kinds[i]]++] = i;
    return {order, begins};
}

}  // namespace begins_moved

// Says: begins tells how many bodies each group has, and not where it begins.
// Hint: A group begins where all the groups before it have ended: add up.
namespace counts {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> size(count + 1), next(count + 1), order(n);
    for (int kind : kinds) ++size[kind];
    for (int k = 0; k < count; ++k) next[k + 1] = next[k] + size[k];
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i;
    size[count] = n;
    return {order, size};
}

}  // namespace counts

// Says: begins lacks its last number: nobody knows where the last group ends.
// Hint: With count + 1 numbers each group ends where the next number says, and the last group needs no case
//       of its own.
namespace no_last {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i;
    begins.pop_back();
    return {order, begins};
}

}  // namespace no_last

// Says: Kinds without a body are left out of begins, so all later groups have moved up.
// Hint: The loop of kind k looks at begins[k] and begins[k + 1]. An empty group has two equal numbers there.
namespace empty_left_out {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i;
    std::vector<int> used{0};
    for (int k = 0; k < count; ++k)
        if (begins[k + 1] > begins[k]) used.push_back(begins[k + 1]);
    return {order, used};
}

}  // namespace empty_left_out

// Says: order holds the sorted kinds, and nobody can tell which body is which.
// Hint: Sort the numbers of the bodies. The kinds only decide where each goes.
namespace kinds_themselves {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = kinds[i];
    return {order, begins};
}

}  // namespace kinds_themselves

// Says: The groups are told, but the bodies still stand in their old order.
// Hint: Each body goes to the next free place of its own group.
namespace not_sorted {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[i] = i;
    return {order, begins};
}

}  // namespace not_sorted

// Says: The kinds are sorted downwards: the last kind comes first.
// Hint: Kind 0 is the first group, and begins[0] is zero.
namespace largest_first {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[count - kind];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[next[count - 1 - kinds[i]]++] = i;
    return {order, begins};
}

}  // namespace largest_first

// Says: The bodies are counted from one.
// Hint: The first body is kinds[0]: its number is 0.
namespace from_one {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i + 1;
    return {order, begins};
}

}  // namespace from_one

// Says: A body that is alone needs no sorting, but here it is missing in begins, which tells that there is
//       nobody.
// Hint: An early way out must return all that is asked. What is the last number in begins where there is one
//       body?
namespace alone {

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

}  // namespace alone

// Says: The bodies of the last kind are missing: the loop over the kinds ends one too early.
// Hint: There are count kinds, 0 to count - 1, and count + 1 numbers in begins. Which loop needs how many
//       rounds?
namespace last_kind_lost {

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

}  // namespace last_kind_lost

// Says: The two lists have changed places: first comes order, then begins.
// Hint: Look at the example. Which of its lists has count + 1 numbers?
namespace lists_swapped {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    std::vector<int> order, begins;
    for (int k = 0; k < count; ++k) {
        begins.push_back(static_cast<int>(order.size()));
        for (int i = 0; i < static_cast<int>(kinds.size()); ++i)
            if (kinds[i] == k) order.push_back(i);
    }
    begins.push_back(static_cast<int>(order.size()));
    return {begins, order};
}

}  // namespace lists_swapped

// Says: begins ends with the highest kind that occurs. The kinds above it are missing.
// Hint: How many numbers must begins have? That does not depend on the bodies.
namespace begins_to_the_highest {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    int most = -1;
    for (const int kind : kinds) most = std::max(most, kind);
    std::vector<int> order, begins;
    for (int k = 0; k <= most; ++k) {
        begins.push_back(static_cast<int>(order.size()));
        for (int i = 0; i < static_cast<int>(kinds.size()); ++i)
            if (kinds[i] == k) order.push_back(i);
    }
    begins.push_back(static_cast<int>(order.size()));
    return {order, begins};
}

}  // namespace begins_to_the_highest

// Says: begins is only set where a kind has a body. For a kind without one it stays zero.
// Hint: Where does an empty group begin? Where the next one does: no body stands between.
namespace empty_begin_at_zero {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    std::vector<int> order, begins(count + 1);
    for (int k = 0; k < count; ++k) {
        const int begin = static_cast<int>(order.size());
        for (int i = 0; i < static_cast<int>(kinds.size()); ++i)
            if (kinds[i] == k) order.push_back(i);
        if (static_cast<int>(order.size()) > begin) begins[k] = begin;
    }
    begins[count] = static_cast<int>(order.size());
    return {order, begins};
}

}  // namespace empty_begin_at_zero

// Says: begins has one number too many: there is a group of a kind that does not exist.
// Hint: The kinds are 0 to count - 1, and begins has one number more than there are kinds. Is the list made too
//       long, or does a loop run with <= where < belongs?
namespace one_begin_too_many {

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    std::vector<int> order, begins{0};
    for (int k = 0; k <= count; ++k) {
        for (int i = 0; i < static_cast<int>(kinds.size()); ++i)
            if (kinds[i] == k) order.push_back(i);
        begins.push_back(static_cast<int>(order.size()));
    }
    return {order, begins};
}

}  // namespace one_begin_too_many
