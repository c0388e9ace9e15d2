// Goes wrong in the way that its argument names. Under the sanitizers it must not get away with it.
#include <cstdio>
#include <cstdlib>
#include <limits>

int main(int argc, char** argv) {
    const int one = argc - 1;  // not known to the compiler
    const int which = std::atoi(argv[1]);
    if (which == 1) {
        int* a = new int[3];
        std::printf("%d\n", a[3 * one]);  // past the end
        delete[] a;
    }
    if (which == 2) std::printf("%d\n", std::numeric_limits<int>::max() + one);  // overflow
}
