#pragma once
// Instructions, counted by callgrind: a program starts itself a second time under it.

#include <functional>
#include <string>
#include <vector>

namespace bench {

// The work between the brackets is counted where the program runs under callgrind.
void counted(const std::function<void()>& work);

struct Counts {
    std::vector<double> instructions;  // of each call of `counted`, in their order
    std::string failure;               // why there are none
};

// Starts this program again, with these arguments, under callgrind. `tick` is called every second.
Counts count_instructions(
    const std::vector<std::string>& arguments, const std::function<void()>& tick = [] {});

}  // namespace bench
