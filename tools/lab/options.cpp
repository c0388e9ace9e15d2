#include "options.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace lab {

// What was typed, as a message shows it.
static std::string shown(const std::string& word) { return word.empty() ? "\"\"" : word; }

Options::Options(std::string program) : program_(std::move(program)) {}

void Options::add(const std::string& flag, Setter set, bool often) {
    options_.push_back({flag, std::move(set), true, often});
}

void Options::add(const std::string& flag, bool& given) {
    options_.push_back({flag, [&](const std::string&) { return given = true, std::string(); }, false, false});
}

bool Options::parse(int argc, char** argv) const {
    std::set<std::string> given;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i], flag = word.substr(0, word.find('='));
        if (word == "--help" || word == "-h") return false;
        const auto option = std::find_if(options_.begin(), options_.end(), [&](const Option& o) {
            return o.flag == word || (o.has_value && o.flag == flag);
        });
        if (option == options_.end())
            throw std::invalid_argument(shown(word) + ": unknown option (" + program_ + " --help lists them)");
        if (!given.insert(flag).second && !option->often)
            throw std::invalid_argument(flag + ": must be given once only");
        std::string value;
        if (flag != word)
            value = word.substr(flag.size() + 1);
        else if (option->has_value && ++i < argc)
            value = argv[i];
        else if (option->has_value)
            throw std::invalid_argument(flag + ": needs a value");
        const std::string wrong = option->set(value);
        if (!wrong.empty()) throw std::invalid_argument(flag + " " + shown(value) + ": " + wrong);
    }
    return true;
}

}  // namespace lab
