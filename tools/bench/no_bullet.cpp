// Stands in for gyroscopic.cpp where there is nothing to compare with.

#include <cstdio>

int main() {
    std::fputs("bench_gyroscopic: Bullet is not installed (package libbullet-dev)\n", stderr);
    return 3;
}
