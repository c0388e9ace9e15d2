// What ./course advise answers about springs, computed.

#include "spring_answer.hpp"

#include <timestep/run.hpp>

#include "advise.hpp"
#include "advise_scene.hpp"

namespace course {

SpringAnswer answer_spring(const Question& question) {
    const timestep::SpringScene scene = scene_of(question);
    const double h = scene.varying() ? scene.longest_frame : step_of(question);
    const double accuracy = question.accuracy.value_or(1);
    if (!(accuracy >= 1e-6 && accuracy <= 50))
        timestep::refuse("accuracy", accuracy, "from 1e-6 to 50 percent");
    timestep::detail::check_step(scene.fastest, timestep::State<double>{0, 1, 0}, h);  // what a run refuses
    const auto all = timestep::advise(scene, h, accuracy / 100);
    const timestep::Wish wish{question.accuracy.has_value(), question.keep_size, accuracy / 100};
    return {scene, h, accuracy, all, timestep::recommend(scene, h, wish, all)};
}

}  // namespace course
