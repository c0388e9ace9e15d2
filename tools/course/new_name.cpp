#include "new_name.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include <dlfcn.h>

#include "paths.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& rule) {
    throw Stop(Status::bad_use, "'" + shortened(sanitized_line(name), 60) + "': " + rule);
}

// Of C++.
const std::vector<std::string> taken_words{
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch", "char",
    "class", "co_await", "co_return", "co_yield", "compl", "concept", "const", "const_cast", "consteval", "constexpr",
    "constinit", "continue", "decltype", "default", "delete", "do", "double", "dynamic_cast", "else", "enum",
    "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if", "inline", "int", "long", "mutable",
    "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected",
    "public", "register", "reinterpret_cast", "requires", "return", "short", "signed", "sizeof", "static",
    "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local", "throw", "true", "try",
    "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual", "void", "volatile", "wchar_t", "while",
    "xor", "xor_eq",
    // Of what the checker compiles together with a learner's function.
    "checker", "close", "correct", "draw_direction", "draw_moments", "draw_rod", "draw_rotation", "draw_vector",
    "exercise", "exercise_tag", "is_of_a_body", "is_within", "known", "learner", "main", "mistakes", "not_started",
    "order", "solution", "solve_linear", "std", "stub", "timestep",
    // Macros and types of the system's headers, which are no functions.
    "assert", "errno", "fpclassify", "isfinite", "isgreater", "isgreaterequal", "isinf", "isless", "islessequal",
    "islessgreater", "isnan", "isnormal", "isunordered", "lconv", "offsetof", "setjmp", "signbit", "timespec",
    "timeval", "tm"};

// What CMake itself makes, in one generator or another, besides the targets that it is told of.
const std::set<std::string> cmakes_own{"all",        "clean",          "codegen",    "depend",
                                       "edit_cache", "help",           "install",    "list_install_components",
                                       "package",    "package_source", "preinstall", "rebuild_cache",
                                       "test"};

// All that can be built, as CMake has written it when it configured (tools/cmake/targets.cmake).
std::set<std::string> targets() {
    std::set<std::string> names;
    std::ifstream lines(paths().build / "targets.txt");
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) names.insert(line);
    return names;
}

void check_targets(const std::string& name, const std::vector<std::string>& made) {
    const auto there = targets();
    for (const auto& target : made) {
        if (!there.contains(target)) continue;
        refuse(name, target == name ? "is a target of the build, and none may be there twice"
                                    : "makes the target " + target + ", which the build has already");
    }
}

}  // namespace

void check_name(const std::string& name) {
    const bool plain = std::all_of(name.begin(), name.end(),
                                   [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
    if (!plain || name.empty() || name.front() < 'a' || name.back() == '_' || name.find("__") != std::string::npos)
        refuse(name, "a name is small letters, digits and single _ between them, and begins with a letter");
    if (name.size() > 40) refuse(name, "a name has at most 40 letters");
    if (std::find(taken_words.begin(), taken_words.end(), name) != taken_words.end())
        refuse(name, "is a word of C++ or of the checker");
    if (cmakes_own.contains(name)) refuse(name, "is a target that CMake makes itself");
}

void check_chapter_is_new(const std::string& name) { check_targets(name, {name, name + "_study", "run_" + name}); }

void check_exercise_is_new(const std::string& name) {
    if (name.ends_with("_t")) refuse(name, "names that end in _t are the system's, for its types");
    if (dlsym(RTLD_DEFAULT, name.c_str()) != nullptr) refuse(name, "is a function of C");
    // exercises/generated gets NAME.hpp and NAME_declared.hpp, which would be read in place of others.
    if (name.ends_with("_declared"))
        refuse(name, "names that end in _declared are for what the build writes of exercises");
    std::error_code error;
    const fs::path headers = paths().source / "tools/checker";
    for (fs::recursive_directory_iterator header(headers, error), end; !error && header != end; header.increment(error))
        if (header->path().filename() == name + ".hpp") refuse(name, "is a header of the checker");
    check_targets(
        name, {name, "hidden_" + name, "hidden_objects_" + name, "worker_" + name, "ready_" + name, "check_" + name});
}

}  // namespace course
