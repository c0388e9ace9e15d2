// What Doxygen's pages of the library lack: units beside parameters, and a group for every header.

#include "finish_site.hpp"
#include "text.hpp"

#include <filesystem>
#include <map>
#include <set>

namespace page {
namespace {

/// The unit of `parameter` in `function`: the row that names the function, else the one for all.
Unit* find_unit(Units& units, const std::string& parameter, const std::string& function) {
    Unit* found = nullptr;
    const auto [first, last] = units.equal_range(parameter);
    for (auto row = first; row != last; ++row) {
        bool fits = row->second.in.empty() && found == nullptr;
        for (const std::string& word : split_words(row->second.in))
            fits = fits || function.find(word) != std::string::npos;
        found = fits ? &row->second : found;
    }
    if (found != nullptr) found->used = true;
    return found;
}

/// What stands between tags.
std::string without_tags(std::string html) {
    for (std::size_t at; (at = html.find('<')) != std::string::npos;) html.erase(at, html.find('>', at) + 1 - at);
    return replace_all(replace_all(html, "&lt;", "<"), "&gt;", ">");
}

}  // namespace

Units read_units(const std::filesystem::path& file) {
    Units units;
    for (const auto& [cells, line] : rows_of(file, 3)) units.emplace(cells[0], Unit{cells[1], cells[2], line});
    return units;
}

std::string with_units(const std::string& html, Units& units, std::set<std::string>& missing) {
    static const std::string cell = "<td class=\"paramname\">", open = "<em>", close = "</em>",
                             of = "<td class=\"memname\">";
    std::string filled;
    std::size_t done = 0;
    for (std::size_t at = 0; (at = html.find(cell, at)) != std::string::npos;) {
        at += cell.size();
        const std::size_t begin = html.find(open, at), end = html.find(close, at);
        if (begin == std::string::npos || html.find("</td>", at) < begin) {
            continue;  // it has no name: nothing reads it
        }
        const std::size_t function = html.rfind(of, at);
        const std::string where = without_tags(html.substr(function, html.find("</td>", function) - function));
        const std::string parameter = html.substr(begin + open.size(), end - begin - open.size());
        const Unit* unit = find_unit(units, parameter, where);
        if (unit == nullptr) {
            missing.insert("docs/library/units.tsv:1: has no unit for the parameter " + parameter + " of " +
                           std::string{trim(where)});
            continue;
        }
        filled += html.substr(done, end + close.size() - done);
        if (!unit->unit.empty()) filled += "<span class=\"unit\">" + escape_html(unit->unit) + "</span>";
        done = end + close.size();
    }
    return filled + html.substr(done);
}

void check_groups(const std::filesystem::path& file, const std::vector<Name>& names) {
    std::set<std::string> headers;
    for (const Name& name : names)
        if (const std::size_t at = name.path.find("include/timestep/"); at != std::string::npos)
            headers.insert(name.path.substr(at + 8) + name.name);
    for (const auto& [cells, line] : rows_of(file, 2)) {
        if (headers.erase(cells[0]) == 0)
            throw Error{file.string(), line, "there is no second header " + cells[0] + ", and perhaps no first"};
    }
    if (!headers.empty()) throw Error{file.string(), 1, "has no group for " + *headers.begin()};
}

void check_all_used(const std::filesystem::path& file, const Units& units) {
    for (const auto& [parameter, unit] : units)
        if (!unit.used) throw Error{file.string(), unit.line, "no function has a parameter " + parameter + " there"};
}

}  // namespace page
