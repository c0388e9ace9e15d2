// Chapter 7: which method reaches the accuracy that I need in the least time?

#include "scenes.hpp"
#include "sections.hpp"

int main(int argc, char** argv) {
    std::string scene = "all";
    std::vector<std::string> scenes{"all"};
    for (const auto& named : contest::all_scenes) scenes.push_back(named.id);
    lab::Program program("error_against_run_time", "every method in every scene: what does accuracy cost?");
    program.option("--scene", scene, scenes, "the scene to measure");
    return program.run(argc, argv, [&](lab::Findings& out) {
        const All all = diagrams(scene, out);
        if (scene == "all") claims(all, out);
        fooled(out);
    });
}
