// A crowd of 64 bodies of one kind, kept in one of the ways of mixed.hpp: what a body's step takes.

#include "cases.hpp"
#include "chapters/06_stability/study/mixed.hpp"

namespace {

using namespace timestep;

const BodyScene scene{Weight(9.81), Gyroscopic(passive_gyroscopic)};

template <class Crowd, class Scene>
[[gnu::noinline]] void step(Crowd& crowd, Scene scene, long n) {
    for (long i = 0; i < n; ++i) crowd.step(scene, 0.001);
}

template <class Crowd, class Scene>
void add(std::vector<Case>& all, const std::string& way, const Scene& scene) {
    const auto add_kind = [&](const std::string& kind, auto add_body) {
        all.push_back({way + "_" + kind, 6400, [=](long count) {
                           Crowd crowd;
                           for (int i = 0; i < 64; ++i) add_body(crowd, i);
                           step(crowd, scene, count / 64);
                       }});
    };
    add_kind("ball", [](Crowd& crowd, int i) { mixed::add_ball(crowd, i); });
    add_kind("capsule", [](Crowd& crowd, int i) { mixed::add_capsule(crowd, i); });
    add_kind("box", [](Crowd& crowd, int i) { mixed::add_box(crowd, i); });
}

}  // namespace

std::vector<Case> crowds() {
    std::vector<Case> all;
    add<mixed::Sorted>(all, "sorted", scene);
    add<mixed::Sorted>(all, "no_torque", BodyScene{Weight(9.81)});
    add<mixed::Variants>(all, "variant", scene);
    add<mixed::Virtuals<decltype(scene)>>(all, "virtual", scene);
    add<mixed::Alike>(all, "alike", scene);
    return all;
}
