#pragma once
// ./course advise: what its two kinds of question share.

#include <string>

#include "commands.hpp"
#include "stop.hpp"

namespace course {

[[noreturn]] inline void refuse(const std::string& line) {
    throw Stop(Status::bad_use, line + " (./course advise --help)");
}

double step_of(const Question& question);
double accuracy_of(const Question& question);  // percent

void advise_spring(const Question& question, bool json);
void advise_damper(const Question& question, bool json);
void advise_body(const Question& question, bool json);

}  // namespace course
