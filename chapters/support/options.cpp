// Options of a chapter program: few, plain, and strict.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "lab.hpp"

namespace lab {

const Rule any_number{[](double) { return true; }, "a finite number"};
const Rule above_zero{[](double v) { return v > 0; }, "finite and greater than zero"};
const Rule zero_or_more{[](double v) { return v >= 0; }, "finite and zero or more"};

namespace {

[[noreturn]] void refuse(const std::string& flag, const std::string& value, const std::string& rule) {
    throw std::invalid_argument(flag + " " + value + ": must be " + rule);
}

template <class Number>
bool read(const std::string& text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end;
}

std::string shown(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

}  // namespace

Program::Program(std::string name, std::string summary)
    : name_(std::move(name)), summary_(std::move(summary)) {}

void Program::option(const std::string& flag, double& value, Rule rule, const std::string& help) {
    const auto set = [&value, flag, rule](const std::string& text) {
        double given = 0;
        if (!read(text, given) || !std::isfinite(given) || !rule.holds(given))
            refuse(flag, text, rule.words);
        value = given;
    };
    options_.push_back({flag, help, set, shown(value)});
}

void Program::option(const std::string& flag, long& value, long least, long most,
                     const std::string& help) {
    const auto set = [&value, flag, least, most](const std::string& text) {
        long given = 0;
        if (!read(text, given) || given < least || given > most)
            refuse(flag, text,
                   "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        value = given;
    };
    options_.push_back({flag, help, set, std::to_string(value)});
}

void Program::option(const std::string& flag, std::string& value, std::vector<std::string> choices,
                     const std::string& help) {
    std::string words;
    for (const auto& choice : choices) words += (words.empty() ? "" : ", ") + choice;
    const auto set = [&value, flag, choices, words](const std::string& text) {
        for (const auto& choice : choices)
            if (choice == text) {
                value = text;
                return;
            }
        refuse(flag, text, "one of " + words);
    };
    options_.push_back({flag, help + ": " + words, set, value});
}

Program::Parsed Program::parse(int argc, char** argv) {
    const auto out = [this](const std::string& text) {
        if (text.empty()) throw std::invalid_argument("--out: must be the name of a folder");
        folder_ = text;
    };
    std::vector<Option> known = options_;
    known.push_back({"--out", "", out, ""});

    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        if (word == "--help" || word == "-h") return Parsed::help;
        const auto equals = word.find('=');
        const std::string flag = word.substr(0, equals);
        const Option* option = nullptr;
        for (const auto& candidate : known)
            if (candidate.flag == flag) option = &candidate;
        if (!option)
            throw std::invalid_argument(word + ": unknown option (" + name_ + " --help lists them)");
        if (equals == std::string::npos && i + 1 == argc)
            throw std::invalid_argument(flag + ": needs a value");
        option->set(equals == std::string::npos ? argv[++i] : word.substr(equals + 1));
        changed_ = changed_ || flag != "--out";
    }
    return Parsed::go;
}

void Program::print_help() const {
    std::printf("%s: %s\n\n", name_.c_str(), summary_.c_str());
    for (const auto& option : options_)
        std::printf("  %-11s %s (%s)\n", option.flag.c_str(), option.help.c_str(),
                    option.initial.c_str());
    std::printf("  %-11s %s\n  %-11s %s\n", "--out DIR", "leave data, numbers and checks in DIR",
                "--help", "this text");
}

int Program::run(int argc, char** argv, const std::function<void(Findings&)>& body) {
    try {
        Findings findings;
        if (parse(argc, argv) == Parsed::help)
            print_help();
        else
            body(findings);
        // A full disk shows when the buffer is written out.
        if (std::fflush(stdout) != 0 || std::ferror(stdout))
            throw std::runtime_error("standard output: cannot be written");
        for (const auto& statement : findings.failed())
            std::fprintf(stderr, "%s: does not hold%s: %s\n", name_.c_str(),
                         changed_ ? " with these options" : "", statement.c_str());
        if (!findings.failed().empty() && !changed_) return 1;
        if (!folder_.empty()) findings.save(folder_);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name_.c_str(), error.what());
        return 2;
    }
}

}  // namespace lab
