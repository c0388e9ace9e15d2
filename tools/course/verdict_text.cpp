#include "verdict_text.hpp"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "answer_lint.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// At most 200 characters. An assertion's text comes after the long name of its function, which is shortened.
std::string to_the_point(const std::string& line) {
    constexpr std::size_t most = 200;
    const auto point = line.find(": Assertion ");
    if (point == std::string::npos || width_of(line) <= most) return shortened(line, most);
    return shortened(line.substr(0, point), 80) + shortened(line.substr(point), most - 80);
}

// The first `most` lines, shortened, and how many more there are.
std::string head_of(const std::string& text, int most, const std::string& indent) {
    std::istringstream lines(text);
    std::string head;
    int seen = 0;
    for (std::string line; std::getline(lines, line);)
        if (++seen <= most) head += indent + to_the_point(line) + "\n";
    if (seen > most) head += indent + "… and " + std::to_string(seen - most) + " more lines\n";
    return head;
}

// What the linker says, in the words of the exercise.
std::string of_linker(const Exercise& exercise, const std::string& said) {
    // GNU ld's words, and lld's.
    if (said.find("undefined reference to `" + exercise.name + "(") != std::string::npos ||
        said.find("undefined reference to '" + exercise.name + "(") != std::string::npos ||
        said.find("undefined symbol: " + exercise.name + "(") != std::string::npos) {
        return "  The file has no function\n      " + exercise.declaration + "\n" +
               wrapped(
                   "Name and arguments must stay as they were, and the function must be neither static, inline nor "
                   "a template, nor part of a namespace or a class.",
                   2);
    }
    if (said.find("multiple definition of `main'") != std::string::npos ||
        said.find("multiple definition of 'main'") != std::string::npos ||
        said.find("duplicate symbol: main") != std::string::npos)
        return "  The file has a main of its own. The checker brings one: leave yours out.\n";
    return {};
}

// The compiler reads a header with the exercise's declaration before the learner's file.
std::string of_declaration(const Exercise& exercise, const std::string& said) {
    if (said.find("what the exercise declares:") == std::string::npos) return {};
    return "  The file declares the function otherwise than the exercise does:\n      " + exercise.declaration +
           "\n  The type it returns, name and arguments must stay as they were.\n\n";
}

std::string does_not_compile(const Exercise& exercise, const Verdict& verdict, const fs::path& file) {
    const std::string text = contents(file);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return wrapped("The file is in UTF-16, which the compiler cannot read. Save it as UTF-8.", 2);
    const std::string why = of_linker(exercise, verdict.compiler);
    return why.empty() ? of_declaration(exercise, verdict.compiler) + head_of(verdict.compiler, 12, "  ") : why;
}

// "" if there is no such line: #line can claim any number.
std::string line_of(const fs::path& file, int number) {
    std::istringstream lines(contents(file));
    std::string line;
    for (int i = 0; i < number; ++i)
        if (!std::getline(lines, line)) return {};
    return shortened(sanitized(line), 200);
}

// The line on which the function is defined; 1 if it is written in an unusual way.
int definition(const Exercise& exercise, const fs::path& file) {
    const std::string head = exercise.declaration.substr(0, exercise.declaration.find('(') + 1);
    std::istringstream lines(contents(file));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        if (line.starts_with(head)) return number;
    return 1;
}

std::string call(const Exercise& exercise, const Verdict& verdict) { return exercise.name + verdict.arguments; }

// Without arguments there was no call yet: the file's variables were initialised.
std::string when(const Exercise& exercise, const Verdict& verdict) {
    if (verdict.arguments == checker::at_the_end)
        return "after the last call of " + exercise.name + ", when the program ended";
    return verdict.arguments.empty() ? "before the first call of " + exercise.name
                                     : "in the call " + call(exercise, verdict);
}

std::string wrong(const Exercise& exercise, const Verdict& verdict, const fs::path& file) {
    std::string text = "  This must hold, and does not:\n" + wrapped(verdict.property, 6) + "\n";
    if (!verdict.right.empty())
        text += "  For example\n" +
                wrapped(call(exercise, verdict) + " returned " + verdict.result + "; right is " + verdict.right, 6) +
                "\n";
    else if (!verdict.result.empty())
        text += "  It was noticed after the call\n" +
                wrapped(call(exercise, verdict) + ", which returned " + verdict.result, 6) + "\n";
    if (!verdict.detail.empty()) text += wrapped(verdict.detail, 2) + "\n";
    const std::string mistake = told_of(exercise, verdict.diagnosis);
    const std::string seen = answer_lint(exercise, verdict, file);
    if (!mistake.empty()) return text + mistake + seen;
    if (!seen.empty()) return text + seen.substr(1);  // a blank line is there
    return text + wrapped(
                      "Your answer matches none of the mistakes that the course knows. Work the property out by hand "
                      "for the numbers above.",
                      2);
}

std::string why(const Exercise& exercise, const Verdict& verdict, const fs::path& file) {
    const std::string& kind = verdict.kind;
    if (kind == "does_not_compile") return does_not_compile(exercise, verdict, file);
    if (kind == "wrong") return wrong(exercise, verdict, file);
    if (kind == "not_finite") {
        std::string text = wrapped(call(exercise, verdict) + " returned " + verdict.result +
                                       ". Every answer "
                                       "must be a finite number.",
                                   2);
        const std::string mistake = told_of(exercise, verdict.diagnosis);
        return text + (mistake.empty() ? mistake : "\n" + mistake) + answer_lint(exercise, verdict, file);
    }
    if (kind == "crash") {
        std::string text = wrapped(verdict.detail + ", " + when(exercise, verdict), 2);
        if (verdict.line > 0)
            text += "  Line " + std::to_string(verdict.line) + ":  " + line_of(file, verdict.line) + "\n";
        return text + answer_lint(exercise, verdict, file);
    }
    if (kind == "too_slow" && verdict.detail == too_much_work_for_the_tests)
        return wrapped(
            "The hidden tests have worked for a minute on what your function returned, and were not done. "
            "Are its answers huge, or such that a loop over them never ends?",
            2);
    if (kind == "too_slow") {
        if (verdict.detail == checker::too_slow_by_the_clock)
            return wrapped("There was no answer in 20 s by the clock, " + when(exercise, verdict) +
                               ", though there was little work: does the code sleep, or wait for what does not come?",
                           2);
        return wrapped("There was no answer in time (2 s of work for one call, 8 s for all), " +
                           when(exercise, verdict) + ". Is there a loop that never ends?",
                       2);
    }
    if (kind == "too_much_memory")
        return wrapped(
            "The program asked for more memory than there is for an exercise, 1 GB, " + when(exercise, verdict) + ".",
            2);
    if (kind == "left_early") return wrapped(verdict.detail + ", " + when(exercise, verdict) + ".", 2);
    return wrapped("The checker itself failed, which is not your fault: " + verdict.detail, 2);
}

}  // namespace

std::string headline(const std::string& kind) {
    if (kind == "not_started") return "not started";
    if (kind == "does_not_compile") return "does not compile";
    if (kind == "wrong") return "not yet";
    if (kind == "not_finite") return "not a number";
    if (kind == "crash") return "crashes";
    if (kind == "too_slow") return "too slow";
    if (kind == "too_much_memory") return "too much memory";
    if (kind == "left_early") return "does not return";
    return "could not be checked";
}

std::string told(const Exercise& exercise, const Verdict& verdict, const fs::path& file) {
    std::string text;
    if (verdict.kind == "not_started")
        return bold(exercise.place() + " " + exercise.name) + ": not started\n" +
               wrapped("Your file is " + shown(file) +
                           ". The task stands in it; write your answer in place of "
                           "\"return not_started;\" and check again.",
                       2);
    char seconds[16];
    std::snprintf(seconds, sizeof seconds, "%.2f s", verdict.seconds);
    if (verdict.kind == "pass") {
        text = bold("✓ " + exercise.place() + " " + exercise.name) + ": right  (" + seconds + ")\n\n" +
               wrapped(exercise.learned, 2);
    } else {
        text = bold("✗ " + exercise.place() + " " + exercise.name) + ": " + headline(verdict.kind) + "\n\n" +
               why(exercise, verdict, file);
    }
    if (!verdict.remark.empty()) text += "\n" + wrapped(verdict.remark, 2);
    const bool has_report = verdict.watched && verdict.kind == "crash";
    if (!verdict.printed.empty())
        text += (has_report ? "\n  The sanitizer, or your code, printed:\n" : "\n  Your code printed:\n") +
                head_of(verdict.printed, 20, "      ");
    if (verdict.kind != "does_not_compile" && !verdict.compiler.empty())
        text += "\n  The compiler remarks:\n" + head_of(verdict.compiler, 12, "  ");
    return text;
}

std::string marked(const Exercise& exercise, const Verdict& verdict, const fs::path& file) {
    for (const char* nothing_to_mark : {"pass", "not_started", "does_not_compile", "course_error"})
        if (verdict.kind == nothing_to_mark) return {};
    int place = verdict.line;
    if (place <= 0 || line_of(file, place).empty()) place = definition(exercise, file);
    std::string name = shown(file);
    if (name.starts_with("..")) name = sanitized_line(file.string());
    return "\n  " + name + ":" + std::to_string(place) + ": error: " + headline(verdict.kind) + "\n";
}

std::string as_json(const Exercise& exercise, const Verdict& verdict) {
    const auto word_or_null = [](const std::string& word) {
        return word.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(word);
    };
    return nlohmann::ordered_json{{"exercise", exercise.name},
                                  {"verdict", verdict.kind},
                                  {"property", word_or_null(verdict.property)},
                                  {"misconception", word_or_null(verdict.diagnosis.label())},
                                  {"seed", verdict.seed},
                                  {"seconds", std::round(verdict.seconds * 1000) / 1000}}
        .dump();
}

}  // namespace course
