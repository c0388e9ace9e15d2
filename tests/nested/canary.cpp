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
    } else if (which == 2) {
        std::printf("%d\n", std::numeric_limits<int>::max() + one);  // overflow
    } else if (which == 3) {
        std::printf("%d\n", static_cast<int>(1e300 * one));  // does not fit
    } else if (which == 4) {
        std::printf("%p\n", static_cast<void*>(new int[one]));  // never deleted
    }
}
