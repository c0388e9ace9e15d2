#include "options.hpp"

#include <stdexcept>

namespace lab {

namespace {

// What was typed, as it is shown.
std::string shown(const std::string& word) { return word.empty() ? "\"\"" : word; }

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
    std::vector<std::vector<std::string>> given(options_.size());
    std::vector<std::string> unknown;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        bool known = false;
        for (std::size_t k = 0; k < options_.size() && !known; ++k) {
            const auto& [flag, setter, has_value, often] = options_[k];
            if (word == flag) {
                if (has_value && i + 1 == argc) throw std::invalid_argument(flag + ": needs a value");
                given[k].push_back(has_value ? argv[++i] : "");
            } else if (has_value && word.starts_with(flag + "=")) {
                given[k].push_back(word.substr(flag.size() + 1));
            } else {
                continue;
            }
            known = true;
        }
        if (!known) unknown.push_back(word);
    }
    for (const std::string& word : unknown) {
        if (word == "--help" || word == "-h") return false;
        throw std::invalid_argument(shown(word) + ": unknown option (" + program_ + " --help lists them)");
    }
    for (std::size_t k = 0; k < options_.size(); ++k) {
        const Option& option = options_[k];
        if (given[k].size() > 1 && !option.often)
            throw std::invalid_argument(option.flag + ": must be given once only");
        for (const std::string& value : given[k]) set(option.flag, option.set, value);
    }
    return true;
}

}  // namespace lab
