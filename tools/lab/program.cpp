// A chapter's program: its options are few, plain, and strict.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "lab.hpp"
#include "options.hpp"

namespace lab {

const Rule any_number{[](double) { return true; }, "a finite number"};
const Rule above_zero{[](double v) { return v > 0; }, "finite and greater than zero"};
const Rule zero_or_more{[](double v) { return v >= 0; }, "finite and zero or more"};

namespace {

// What the user typed, as it may stand in a message of one line.
std::string one_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        char code[8];
        std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(c));
        const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        line += control ? std::string(code) : std::string(1, c);
    }
    return line;
}

template <class Number>
std::errc read(const std::string& text, Number& value) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars knows none
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + plus, end, value);
    return stop == end ? error : std::errc::invalid_argument;
}

std::string shown(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

}  // namespace

Program::Program(std::string name, std::string summary) : name_(std::move(name)), summary_(std::move(summary)) {}

void Program::option(const std::string& flag, double& value, Rule rule, const std::string& help) {
    const auto set = [&value, rule](const std::string& text) {
        double given = 0;
        const std::errc error = read(text, given);
        if (error == std::errc::invalid_argument) return "is no number (must be " + std::string(rule.words) + ")";
        if (error != std::errc() || !std::isfinite(given) || !rule.holds(given))
            return "must be " + std::string(rule.words);
        value = given;
        return std::string();
    };
    options_.push_back({flag, help, rule.words, shown(value), set});
}

void Program::option(const std::string& flag, long& value, long least, long most, const std::string& help) {
    const std::string rule = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    const auto set = [&value, least, most, rule](const std::string& text) {
        long given = 0;
        if (read(text, given) != std::errc() || given < least || given > most) return "must be " + rule;
        value = given;
        return std::string();
    };
    options_.push_back({flag, help, rule, std::to_string(value), set});
}

void Program::option(const std::string& flag, std::string& value, std::vector<std::string> choices,
                     const std::string& help) {
    std::string words;
    for (const auto& choice : choices) words += (words.empty() ? "" : ", ") + choice;
    const std::string rule = "one of " + words;
    const auto set = [&value, choices, rule](const std::string& text) {
        if (std::find(choices.begin(), choices.end(), text) == choices.end()) return "must be " + rule;
        value = text;
        return std::string();
    };
    options_.push_back({flag, help, rule, value, set});
}

bool Program::set_folder(const std::string& text) {
    folder_ = text;
    std::error_code error;
    std::filesystem::path path = text;  // goes up to the innermost thing that is there
    while (!path.empty() && !exists(path, error)) path = path.parent_path();
    return !text.empty() && (path.empty() || is_directory(path, error));
}

bool Program::parse(int argc, char** argv) {
    Options options(name_);
    for (const Option& option : options_)
        options.add(option.flag, [this, &option](const std::string& text) {
            changed_ = true;
            return option.set(text);
        });
    options.add("--out", [this](const std::string& text) {
        return std::string(set_folder(text) ? "" : "must be a folder, or the name of a new one");
    });
    return options.parse(argc, argv);
}

void Program::print_help() const {
    std::printf("%s: %s\n\n", name_.c_str(), summary_.c_str());
    for (const auto& option : options_)
        std::printf("  %-11s %s (%s; must be %s)\n", option.flag.c_str(), option.help.c_str(), option.initial.c_str(),
                    option.rule.c_str());
    std::printf("  %-11s %s\n  %-11s %s\n", "--out DIR", "leave data, numbers and checks in DIR", "--help",
                "this text");
}

int Program::run(int argc, char** argv, const std::function<void(Findings&)>& body) {
    try {
        Findings findings;
        if (parse(argc, argv)) {
            body(findings);
        } else {
            print_help();
        }
        // A full disk shows when the buffer is written out.
        if (std::fflush(stdout) != 0 || std::ferror(stdout))
            throw std::runtime_error("standard output: cannot be written");
        // Other options are there to be played with: what no longer holds then is no error.
        if (!changed_ && !findings.finite()) throw std::logic_error("a NaN or an infinity was written");
        const bool failed = !findings.failed().empty() && !changed_;
        if (!failed && !folder_.empty()) findings.save(folder_);
        for (const auto& statement : findings.failed())
            std::fprintf(stderr, "%s: does not hold%s: %s\n", name_.c_str(), changed_ ? " with these options" : "",
                         statement.c_str());
        return failed ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name_.c_str(), one_line(error.what()).c_str());
        return 2;
    }
}

}  // namespace lab
