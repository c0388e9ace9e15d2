#pragma once
/// \file
/// The options of a small program, refused in one line. (CLI11, which reads the course program's options, takes longer
/// to compile than everything else that the first page needs.)

#include <functional>
#include <string>
#include <vector>

namespace lab {

class Options {
public:
    /// Takes an option's value; returns what is wrong with it ("must be …"), or nothing.
    using Setter = std::function<std::string(const std::string& value)>;

    /// `program` is named where --help is recommended.
    explicit Options(std::string program);
    /// An option with a value, given once; with `often`, any number of times.
    void add(const std::string& flag, Setter set, bool often = false);
    /// An option without a value.
    void add(const std::string& flag, bool& given);
    /// Sets the options given, word by word; false at --help. Throws std::invalid_argument with one line.
    bool parse(int argc, char** argv) const;

private:
    struct Option {
        std::string flag;
        Setter set;
        bool has_value, often;
    };
    std::string program_;
    std::vector<Option> options_;
};

}  // namespace lab
