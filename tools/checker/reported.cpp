#include "reported.hpp"

#include <cstring>

#include <unistd.h>

// The sanitizers' own names, which are there only where they are linked.
extern "C" {
[[gnu::weak]] void __asan_set_error_report_callback(void (*)(const char*));
[[gnu::weak]] const char* __asan_get_report_description();
[[gnu::weak]] void __sanitizer_set_report_fd(void*);
[[gnu::weak]] void __ubsan_get_current_report_data(const char** kind, const char** message, const char** file,
                                                   unsigned* line, unsigned* column, char** address);
}

namespace checker {

namespace {

void (*handed_to)(const char*) = nullptr;

struct Plain {
    const char *name, *words;
};

constexpr const char* too_much_memory = "more memory than there is";

// The first whose name is part of what was found.
constexpr Plain in_words[] = {
    {"use-after-free", "memory is used that was given back already"},
    {"use-after-scope", "a variable is used that is gone already"},
    {"use-after-return", "a variable is used whose function has returned"},
    {"double-free", "memory is given back twice"},
    {"heap-buffer-overflow", "an index or a pointer leads out of an array on the heap"},
    {"stack-buffer", "an index or a pointer leads out of an array"},
    {"container-overflow", "an index, a pointer or an iterator leads out of a vector"},
    {"global-buffer-overflow", "an index or a pointer leads out of a global array"},
    {"dynamic-stack-buffer-overflow", "an index or a pointer leads out of an array"},
    {"allocation-size-too-big", too_much_memory},
    {"calloc-overflow", too_much_memory},
    {"rss-limit-exceeded", too_much_memory},
    {"out-of-memory", too_much_memory},
    {"bad-free", "memory is given back that was never handed out"},
    {"alloc-dealloc-mismatch", "memory is given back otherwise than it was taken: new[] needs delete[]"},
    {"out-of-bounds-index", "an index is outside of its array"},
    {"insufficient-object-size", "an index or a pointer leads out of an array"},
    {"signed-integer-overflow", "a whole number becomes larger than its type can hold"},
    {"integer-divide-by-zero", "a whole number is divided by zero"},
    {"invalid-shift", "a number is shifted by too many places, or by less than none"},
    {"null-pointer", "a null pointer is followed"},
    {"misaligned-pointer", "a pointer leads to where no value of its type may stand"},
    {"float-cast-overflow", "a number is too large for the whole number it is made into"},
    {"invalid-bool", "a bool is neither true nor false: it was never written"},
    {"missing-return", "the function ends without a return"},
    {"unreachable-call", "the program gets to where it cannot"}};

void tell(const char* name) {
    for (const Plain& plain : in_words)
        if (std::strstr(name, plain.name)) handed_to(plain.words);
    handed_to(name);
}

}  // namespace

// Called by the one for undefined behaviour before it prints.
extern "C" [[gnu::visibility("default")]] void __ubsan_on_report() {
    const char *kind = "", *message, *file;
    unsigned line, column;
    char* address;
    if (!handed_to || !__ubsan_get_current_report_data) return;
    __ubsan_get_current_report_data(&kind, &message, &file, &line, &column, &address);
    tell(kind);
}

void hand_reports_to(void (*found)(const char*)) {
    handed_to = found;
    // What it prints is not for learners: it goes where nothing can be written.
    if (__sanitizer_set_report_fd) __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<long>(STDIN_FILENO)));
    if (__asan_set_error_report_callback)
        __asan_set_error_report_callback([](const char*) { tell(__asan_get_report_description()); });
}

bool is_of_too_much_memory(const char* words) { return words == too_much_memory; }

}  // namespace checker
