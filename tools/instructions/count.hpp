#pragma once
// What the programs here share: each takes many questions, as it is started below a profiler, which takes longer than
// to count. A question is some words and a number of steps.

#include <cstdlib>
#include <cstring>
#include <string>

// Callgrind, told so (--dump-after=counted), writes what it has counted since the last call.
extern "C" [[gnu::noinline]] inline void counted() { asm volatile(""); }

// A number that the compiler does not know: 1. And where results go, or it would leave out the steps.
inline volatile double unknown_one = 1, kept;

// Takes each question thrice, and calls counted() after each: once to warm up, then with its number of steps, then with
// twice as many. `take` is given its words and the number. False if the arguments are no questions of so many words.
template <class Take>
bool count_all(int argc, char** argv, int words, const Take& take) {
    if (argc < 2 || (argc - 1) % (words + 1) != 0) return false;
    for (char** at = argv + 1; at < argv + argc; at += words + 1)
        for (const int times : {1, 1, 2}) {
            take(at, times * std::atol(at[words]));
            counted();
        }
    return true;
}
