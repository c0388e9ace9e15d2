#pragma once
/// \file
/// What sanitizers find in the worker, where the learner's code is compiled with them.

namespace checker {

/// From now on `found` is called, once and in plain words, where a sanitizer finds an error; it
/// does not return. Without sanitizers nothing happens.
void hand_reports_to(void (*found)(const char* words));

/// Was it memory that was not to be had? Then `words` are those.
bool is_of_too_much_memory(const char* words);

}  // namespace checker
