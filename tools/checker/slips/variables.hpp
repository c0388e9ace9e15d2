#pragma once
/// \file
/// The variables of a function in an answer's code, and where each can be used.

#include <set>
#include <string>
#include <vector>

#include "code.hpp"

struct Variable {
    std::string name, type;
    std::size_t from, to;  ///< where it can be used
    bool bound;            ///< by a structured binding: no lambda has it
};

class Variables {
public:
    /// Of the function whose arguments begin at `open`, and whose body at `body`.
    Variables(const Code& code, std::size_t open, std::size_t body)
        : code_(code), begin_(body), end_(code.other(body)) {
        find_lambdas();
        find_arguments(open);
        find_locals();
    }

    const std::vector<Variable>& all() const { return all_; }
    std::size_t arguments() const { return arguments_; }  ///< so many of them, the first
    bool declares(std::size_t i) const { return declared_.count(i) > 0; }
    /// Is it a lambda that changes an argument?
    bool changes_argument(const std::string& lambda) const { return changing_.count(lambda) > 0; }
    /// The innermost variable of that name that can be used at i.
    const Variable* find(const std::string& name, std::size_t i) const {
        const Variable* found = nullptr;
        for (const Variable& each : all_)
            if (each.name == name && is_visible(each, i)) found = &each;
        return found;
    }

private:
    struct Lambda {
        std::size_t open, body;
        bool captures;
    };
    const std::string& text(std::size_t i) const { return code_.text(i); }

    void find_lambdas() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) != "[" || code_.operand_before(i) || text(i - 1) == "auto") continue;
            const std::size_t open = code_.other(i) + 1, close = code_.other(open);
            std::size_t body = close;
            while (text(body) != "{") ++body;
            lambdas_.push_back({open, body, open > i + 2});
            for (std::size_t j = open + 1; j < close; ++j)  // an argument that it changes is what it is
                if (text(j) == "&" && text(j - 2) != "const" && text(i - 1) == "=") changing_.insert(text(i - 2));
        }
    }

    void find_arguments(std::size_t open) {
        for (std::size_t i = open + 1; i < code_.other(open); ++i) {
            if (text(i + 1) != "," && text(i + 1) != ")") continue;
            const std::size_t type = text(i - 1) == "&" ? i - 2 : i - 1;
            const bool state = text(type) == ">" && code_.is_state(type - 3);
            if (is_name(text(i)) && (state || code_.is_type(type)))
                all_.push_back({text(i), state ? "State" : text(type), begin_, end_, false});
        }
        arguments_ = all_.size();
    }

    void find_locals() {
        for (std::size_t i = begin_; i < end_; ++i) {
            const bool is_auto = text(i) == "auto", is_state = code_.is_state(i);
            if (!code_.is_type(i) && !is_auto && !is_state) continue;
            std::size_t name = i + (is_state ? 4 : 1);
            if (text(name) == "&") ++name;
            const std::size_t scope = code_.scope_of(i);
            if (is_auto && text(name) == "[") {
                for (std::size_t j = name + 1; j < code_.other(name); ++j)
                    if (is_name(text(j)))
                        all_.push_back({text(j), "double", code_.until(name, {";"}), code_.other(scope), true});
                continue;
            }
            if (is_auto || !is_name(text(name))) continue;
            const std::string type = is_state ? "State" : text(i);
            if (text(scope) != "{") {  // an argument of a lambda, or a loop's
                declared_.insert(name);
                for (const Lambda& lambda : lambdas_)
                    if (lambda.open == scope)
                        all_.push_back({text(name), type, lambda.body, code_.other(lambda.body), false});
            } else if (text(name + 1) == "=") {
                for (const std::size_t end = code_.until(name, {";"}); name < end; ++name) {
                    all_.push_back({text(name), type, end, code_.other(scope), false});
                    declared_.insert(name);
                    name = code_.until(name, {",", ";"});
                }
            }
        }
    }

    bool is_visible(const Variable& variable, std::size_t i) const {
        if (i <= variable.from || i >= variable.to) return false;
        for (const Lambda& lambda : lambdas_)
            if (i > lambda.body && i < code_.other(lambda.body) && variable.from < lambda.body &&
                (!lambda.captures || variable.bound))
                return false;
        return true;
    }

    const Code& code_;
    std::size_t begin_, end_, arguments_ = 0;
    std::vector<Lambda> lambdas_;
    std::vector<Variable> all_;
    std::set<std::size_t> declared_;
    std::set<std::string> changing_;
};
