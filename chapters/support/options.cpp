#include "options.hpp"

#include <stdexcept>

#include <CLI/CLI.hpp>

namespace lab {

namespace {

// What was typed, as it is shown.
std::string shown(const std::string& word) {
    return word.empty() ? "\"\"" : word;
}

void set(const std::string& flag, const Options::Setter& setter, const std::string& value) {
    const std::string wrong = setter(value);
    if (!wrong.empty()) throw std::invalid_argument(flag + " " + shown(value) + ": " + wrong);
}

}  // namespace

Options::Options(std::string program) : program_(std::move(program)) {}

void Options::add(const std::string& flag, Setter set, bool often) {
    options_.push_back({flag, std::move(set), true, often});
}

void Options::add(const std::string& flag, bool& given) {
    const auto set = [&given](const std::string&) {
        given = true;
        return std::string();
    };
    options_.push_back({flag, set, false, false});
}

bool Options::parse(int argc, char** argv) const {
    CLI::App app;
    app.set_help_flag();  // CLI11's own takes --help=1, too
    app.allow_extras();
    std::vector<const CLI::Option*> given;
    for (const Option& option : options_) {
        CLI::Option* const known =
            option.has_value ? app.add_option(option.flag) : app.add_flag(option.flag);
        given.push_back(known->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
        for (int i = 1; i < argc; ++i)  // CLI11 would take the next word for its value
            if (option.has_value && argv[i] == option.flag + "=") set(option.flag, option.set, "");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string words = error.what();
        throw std::invalid_argument(words.substr(0, words.find(':')) + ": needs a value");
    }
    for (const std::string& word : app.remaining()) {
        if (word == "--help" || word == "-h") return false;
        throw std::invalid_argument(shown(word) + ": unknown option (" + program_ +
                                    " --help lists them)");
    }
    for (std::size_t i = 0; i < options_.size(); ++i) {
        const Option& option = options_[i];
        if (given[i]->count() > 1 && !option.often)
            throw std::invalid_argument(option.flag + ": must be given once only");
        for (const std::string& value : given[i]->results()) set(option.flag, option.set, value);
    }
    return true;
}

}  // namespace lab
