#include "option_errors.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "terminal.hpp"

namespace course {

namespace {

// The command that was given, without ./course: "bench loops"; "./course" if there was none.
std::string command_of(const CLI::App& app) {
    std::string command;
    for (auto named = app.get_subcommands(); !named.empty(); named = named.front()->get_subcommands())
        command += (command.empty() ? "" : " ") + named.front()->get_name();
    return command.empty() ? "./course" : command;
}

// Is this an option without a value, of the command given or of all commands?
bool is_flag(const CLI::App& app, const std::string& name) {
    const CLI::Option* const own = app.get_option_no_throw(name);
    const auto named = app.get_subcommands();
    return (own != nullptr && own->get_expected_min() == 0) || (!named.empty() && is_flag(*named.front(), name));
}

// CLI11's words between these.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const auto begin = text.find(before);
    if (begin == std::string::npos) return {};
    const auto from = begin + before.size();
    return text.substr(from, text.find(after, from) - from);
}

}  // namespace

std::string no_double(const std::string& word) {
    if (word.empty()) return "'' is no number";
    if (const std::size_t comma = word.find(',');
        comma != std::string::npos && word.find_first_not_of("0123456789,-+eE") == std::string::npos) {
        std::string point = word;
        point[comma] = '.';
        return sanitized_line(word) + " is not a number; write " + sanitized_line(point);
    }
    const double value = std::strtod(word.c_str(), nullptr);
    const auto shown = [&] { return "'" + sanitized_line(word) + "' is "; };
    if (std::isinf(value) && word.find_first_of("iI") == std::string::npos)
        return shown() + "beyond what a double can hold, 1.8e308";
    const std::string digits = word.substr(0, word.find_first_of("eE"));
    if (value == 0 && std::isdigit(static_cast<unsigned char>(word.back())) &&
        digits.find_first_of("123456789") != std::string::npos)
        return shown() + "nearer to zero than a double can be";
    return "";
}

std::string see_help(const CLI::App& app) {
    const std::string command = command_of(app);
    return " (" + (command == "./course" ? "" : std::string("./course ")) + command + " --help)";
}

std::string in_our_words(const CLI::ParseError& error, const CLI::App& app) {
    const std::string said = error.what(), kind = error.get_name(), option = said.substr(0, said.find(':'));
    const bool extras =
        error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);  // which names the command
    auto words = app.remaining(true);
    if (extras && words.empty()) words.push_back(between(said, " expected: ", "\n"));
    if ((extras || kind == "RequiredError") && !words.empty()) {
        const std::string command = command_of(app);
        const auto odd =
            std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with("-"); });
        return odd != words.end() ? command + " has no option " + sanitized_line(*odd)
                                  : command + " does not take '" + sanitized_line(words.front()) + "'";
    }
    if (said == "A subcommand is required")
        return app.got_subcommand("new") ? "new takes chapter or exercise" : "a command is required";
    if (kind == "ArgumentMismatch" && said.find(" required ") != std::string::npos) {
        const std::string most = between(said, "At least ", " required");
        return most.empty() ? option + " needs a value, " + between(said, " required ", " missing")
                            : option + " needs " + most + " values, with commas between";
    }
    if (kind == "ConversionError") {
        const std::string given = between(said, "Could not convert: ", "\n"), flag = given.substr(0, given.find(' '));
        return is_flag(app, flag) ? flag + " takes no value" : given + ": it takes numbers";
    }
    if (const std::string value = between(said, ": Value ", " not in range "); !value.empty())
        return option + " " + value + ": must be a whole number from " + between(said, " not in range ", "\n");
    if (kind == "ExcludesError")
        return option.substr(0, option.find(' ')) + " and " + between(said, " excludes ", "\n") + " do not go together";
    return said;
}

std::string forgotten_dashes(const CLI::App& app, const std::string& chapter) {
    const std::vector<std::string> words = app.remaining(true);
    if (chapter.empty() || words.empty() || !words.front().starts_with("--")) return {};
    std::string line = "./course run " + chapter + " --study --";
    for (const auto& word : words) line += " " + word;
    return "run has no option " + words.front() + "; those of the chapter's study go after --: " + line;
}

}  // namespace course
