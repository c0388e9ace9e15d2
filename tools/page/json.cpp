#include "json.hpp"

#include "error.hpp"

#include <algorithm>

namespace page {
namespace {

class Reader {
public:
    Reader(std::string_view text, const std::string& file) : text_{text}, file_{file} {}

    Json object() {
        Json object;
        members(object, "");
        skip_blanks();
        if (at_ != text_.size()) {
            fail("nothing may follow the object");
        }
        return object;
    }

private:
    void members(Json& object, const std::string& prefix) {
        expect('{');
        if (accept('}')) {
            return;
        }
        do {
            const std::string key = prefix + string();
            expect(':');
            skip_blanks();
            if (at_ < text_.size() && text_[at_] == '{') {
                members(object, key + ".");
            } else {
                object[key] = value();
            }
        } while (accept(','));
        expect('}');
    }

    std::vector<std::string> value() {
        static constexpr std::string_view plain = "0123456789.+-eEtrufals";  // true and false, too
        if (at_ < text_.size() && plain.find(text_[at_]) != std::string_view::npos) {
            const std::size_t begin = at_;
            at_ = std::min(text_.find_first_not_of(plain, at_), text_.size());
            return {std::string{text_.substr(begin, at_ - begin)}};
        }
        if (!accept('[')) {
            return {string()};
        }
        std::vector<std::string> list;
        if (accept(']')) {
            return list;
        }
        do {
            list.push_back(string());
        } while (accept(','));
        expect(']');
        return list;
    }

    std::string string() {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != '"') {
            fail("a string in double quotes is expected");
        }
        std::string result;
        while (++at_ < text_.size() && text_[at_] != '"') {
            if (text_[at_] == '\n') {
                fail("a string ends on its line");
            }
            result += text_[at_] == '\\' ? escaped() : text_[at_];
        }
        if (at_ == text_.size()) {
            fail("a string has no closing quote");
        }
        ++at_;
        return result;
    }

    /// Files are UTF-8, so \u escapes are never needed.
    char escaped() {
        if (++at_ == text_.size()) {
            fail("a string has no closing quote");
        }
        switch (text_[at_]) {
            case 'n':
                return '\n';
            case 't':
                return '\t';
            case '"':
            case '\\':
            case '/':
                return text_[at_];
            default:
                fail("write the character itself instead of an escape");
        }
    }

    void expect(char wanted) {
        if (!accept(wanted)) {
            fail(std::string{"'"} + wanted + "' is expected");
        }
    }

    bool accept(char wanted) {
        skip_blanks();
        const bool found = at_ < text_.size() && text_[at_] == wanted;
        at_ += found ? 1 : 0;
        return found;
    }

    void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

    [[noreturn]] void fail(const std::string& message) const {
        const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
        throw Error{file_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n')), message};
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
};

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
    return Reader{text, file}.object();
}

}  // namespace page
