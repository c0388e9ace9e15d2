#pragma once
/// \file
/// The options of a small program, refused in one line. (CLI11, which reads the course program's,
/// would take longer to compile than all else that the first page needs.)

#include <functional>
#include <string>
#include <vector>

namespace lab {

class Options {
public:
    /// Takes an option's value; says what is wrong with it ("must be …"), or nothing.
    using Setter = std::function<std::string(const std::string& value)>;

    /// `program` is named where --help is recommended.
    explicit Options(std::string program);
    /// An option with a value, given once; or where `often`, as often as one likes.
    void add(const std::string& flag, Setter set, bool often = false);
    /// An option without a value.
    void add(const std::string& flag, bool& given);
    /// Sets what was given; false where --help was asked for. Throws std::invalid_argument, one
    /// line.
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
