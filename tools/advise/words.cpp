// Reads words.txt: "[section] head", then a line "key: text" for each text. Lines with # are remarks.

#include "words.hpp"

#include <algorithm>
#include <stdexcept>

namespace timestep {

extern const char* const words_txt;  // made by the build

const std::vector<Section>& sections() {
    static const std::vector<Section> all = [] {
        std::vector<Section> made;
        for (std::string_view rest = words_txt; !rest.empty();) {
            const std::string line(rest.substr(0, rest.find('\n')));
            rest.remove_prefix(std::min(rest.size(), line.size() + 1));
            if (line.empty() || line.front() == '#') continue;
            const std::size_t end = line.find(line.front() == '[' ? ']' : ':');
            const std::string after = end + 2 < line.size() ? line.substr(end + 2) : "";
            if (line.front() == '[')
                made.push_back({line.substr(1, end - 1), after, {}});
            else
                made.back().texts.emplace_back(line.substr(0, end), after);
        }
        return made;
    }();
    return all;
}

std::string Section::text(std::string_view key, Values values) const {
    const auto found = std::find_if(texts.begin(), texts.end(), [&](const auto& each) { return each.first == key; });
    if (found == texts.end()) throw std::logic_error("words.txt has no " + std::string(key) + " in [" + name + "]");
    std::string words = found->second;
    for (const auto& [value_name, value] : values) {
        const std::string mark = "{" + std::string(value_name) + "}";
        for (std::size_t at = words.find(mark); at != std::string::npos; at = words.find(mark, at + value.size()))
            words.replace(at, mark.size(), value);
    }
    if (words.find('{') != std::string::npos) throw std::logic_error("words.txt names an unknown value: " + words);
    return words;
}

std::string phrase(std::string_view name, Values values) {
    const std::size_t dot = name.find('.');
    for (const Section& section : sections())
        if (section.name == name.substr(0, dot)) return section.text(name.substr(dot + 1), values);
    throw std::logic_error("words.txt has no section for " + std::string(name));
}

}  // namespace timestep
