#pragma once
// Instructions, counted by callgrind: a program starts itself a second time below it.

#include <functional>
#include <string>
#include <vector>

namespace bench {

// Where the program runs below callgrind, this work is counted.
void counted(const std::function<void()>& work);

struct Counts {
    std::vector<double> instructions;  // of each call of `counted`, in their order
    std::string failure;               // why there are none
};

// Starts this program again below callgrind, with these arguments: plain words, without blanks or quotes.
Counts count_instructions(const std::vector<std::string>& arguments);

}  // namespace bench
