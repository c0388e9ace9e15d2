// The words of C++20 in listings: Doxygen 1.9 colours the double in <double> not at all, and two parts of
// floating_point.

#include "listings.hpp"
#include "text.hpp"

#include <set>
#include <string_view>

namespace page {

namespace {

/// Doxygen's class for a word of the language; nothing for any other.
std::string_view kind_of(std::string_view word) {
    static const std::set<std::string_view> types{"bool", "char",  "double", "float",    "int",
                                                  "long", "short", "signed", "unsigned", "void"};
    static const std::set<std::string_view> flow{"break", "case", "catch",  "continue", "default", "do",  "else", "for",
                                                 "goto",  "if",   "return", "switch",   "throw",   "try", "while"};
    static const std::set<std::string_view> others{
        "alignas",   "auto",         "class",    "concept",       "const",        "const_cast", "consteval",
        "constexpr", "constinit",    "decltype", "delete",        "dynamic_cast", "enum",       "explicit",
        "extern",    "false",        "friend",   "inline",        "mutable",      "namespace",  "new",
        "noexcept",  "nullptr",      "operator", "override",      "private",      "protected",  "public",
        "requires",  "sizeof",       "static",   "static_assert", "static_cast",  "struct",     "template",
        "this",      "thread_local", "true",     "typedef",       "typename",     "union",      "using",
        "virtual",   "volatile"};
    return types.contains(word)    ? "keywordtype"
           : flow.contains(word)   ? "keywordflow"
           : others.contains(word) ? "keyword"
                                   : "";
}

/// A line of code without the spans of keywords that are a part of a longer word.
std::string with_whole_words(std::string line) {
    static const std::string open = "<span class=\"keyword", close = "</span>";
    for (std::size_t at = line.find(open); at != std::string::npos; at = line.find(open, at)) {
        const std::size_t begin = line.find('>', at) + 1, end = line.find(close, begin), after = end + close.size();
        const bool is_part = (at > 0 && in_word(line[at - 1])) || (after < line.size() && in_word(line[after]));
        // Of two that touch, as in unsigned_int, the first is seen to be a part by what follows it.
        if (!is_part) {
            at = begin;
            continue;
        }
        line.erase(end, close.size());
        line.erase(at, begin - at);
    }
    return line;
}

std::string with_all_words(const std::string& line) {
    std::string coloured;
    int inside = 0;  // of spans and links, which have their colour
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '<') {
            const std::size_t end = line.find('>', at);
            const std::string tag = line.substr(at, end + 1 - at);
            if (tag.starts_with("<span") || tag.starts_with("<a ")) ++inside;
            if (tag == "</span>" || tag == "</a>") --inside;
            coloured += tag;
            at += tag.size();
        } else if (in_word(line[at]) || line[at] == '&') {
            const bool is_entity = line[at] == '&';
            std::size_t end = at + 1;
            while (end < line.size() && in_word(line[end])) ++end;
            if (is_entity && end < line.size()) ++end;  // its semicolon
            const std::string word = line.substr(at, end - at);
            const std::string_view kind = inside == 0 && !is_entity ? kind_of(word) : "";
            coloured += kind.empty() ? word : "<span class=\"" + std::string{kind} + "\">" + word + "</span>";
            at = end;
        } else {
            coloured += line[at++];
        }
    }
    return coloured;
}

}  // namespace

std::string with_keywords(std::string html) {
    static const std::string open = "<div class=\"fragment\">", close = "<!-- fragment -->",
                             line_open = "<div class=\"line\">";
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at + 1)) {
        const std::size_t last = html.find(close, at);
        const std::string fragment = html.substr(at, last - at);
        if (last == std::string::npos || fragment.find("<span class=\"") == std::string::npos)
            continue;  // no code of C++, but a command
        std::string coloured;
        for (std::size_t begin = 0; begin < fragment.size();) {
            std::size_t end = fragment.find('\n', begin);
            if (end == std::string::npos) end = fragment.size();
            const std::string line = fragment.substr(begin, end - begin);
            coloured += (line.find(line_open) == std::string::npos ? line : with_all_words(with_whole_words(line))) +
                        (end < fragment.size() ? "\n" : "");
            begin = end + 1;
        }
        html.replace(at, fragment.size(), coloured);
    }
    return html;
}

}  // namespace page
