// What ./course advise answers about springs, computed.

#include "spring_answer.hpp"

#include <timestep/methods/implicit_euler.hpp>

#include "command.hpp"
#include "advise_scene.hpp"

namespace course {

SpringAnswer answer_spring(const Question& question) {
    timestep::SpringScene scene = scene_of(question);
    const double h = scene.varying() ? scene.longest_frame : step_of(question);
    const double accuracy = accuracy_of(question);
    scene.thrown = timestep::detail::thrown_counts(scene.fastest.zeta, scene.fastest.omega * h);
    timestep::implicit_euler.check_step(scene.fastest, timestep::State<double>{0, 1, 0}, h);
    const auto all = timestep::advise(scene, h, accuracy / 100);
    const timestep::Wish wish{question.accuracy.has_value(), question.keep_size, accuracy / 100};
    return {scene, h, accuracy, all, timestep::recommend(scene, h, wish, all)};
}

}  // namespace course
