// Steps a crowd of 64 bodies of one kind, kept in one of the ways of mixed.hpp, until COUNT bodies
// have been stepped: a program for a profiler to count. `kinds sorted ball 6400`.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "count.hpp"
#include "chapters/06_stability/study/mixed.hpp"

namespace {

using namespace timestep;

const BodyScene scene{Weight(9.81), Gyroscopic(passive_gyroscopic)};

template <class Crowd, class Scene>
[[gnu::noinline]] void step(Crowd& crowd, Scene scene, long n) {
    for (long i = 0; i < n; ++i) crowd.step(scene, 0.001);
}

template <class Crowd, class Scene>
void step(Crowd crowd, const Scene& scene, const std::string& kind, long count) {
    for (int i = 0; i < 64; ++i) {
        if (kind == "ball")
            mixed::add_ball(crowd, i);
        else if (kind == "capsule")
            mixed::add_capsule(crowd, i);
        else
            mixed::add_box(crowd, i);
    }
    step(crowd, scene, count / 64);
}

void take(const std::string& way, const std::string& kind, long n) {
    if (way == "sorted")
        step(mixed::Sorted(), scene, kind, n);
    else if (way == "no_torque")
        step(mixed::Sorted(), BodyScene{Weight(9.81)}, kind, n);
    else if (way == "variant")
        step(mixed::Variants(), scene, kind, n);
    else if (way == "virtual")
        step(mixed::Virtuals<decltype(scene)>(), scene, kind, n);
    else if (way == "alike")
        step(mixed::Alike(), scene, kind, n);
    else
        std::exit((std::fprintf(stderr, "kinds: %s: no such way\n", way.c_str()), 2));
}

}  // namespace

int main(int argc, char** argv) {
    const auto one = [](char** words, long n) { take(words[0], words[1], n); };
    if (!count_all(argc, argv, 2, one))
        return std::fputs("kinds: usage: kinds WAY ball|capsule|box COUNT ...\n", stderr), 2;
}
