// library_pages: what Doxygen's pages of the library lack.
//
//     library_pages SITE TAGS FOLDER
//
// Puts the unit beside every parameter of a function of the library, from FOLDER/units.tsv, and holds FOLDER/groups.tsv
// to the headers that Doxygen's file TAGS names. A parameter without a unit, a header without a group, and a row that
// stands for nothing are errors.

#include "text.hpp"

#include <filesystem>
#include <iostream>
#include <map>
#include <set>

namespace {

namespace fs = std::filesystem;

/// What a parameter is measured in; in functions whose name holds one of the words `in`, or in all others.
struct Unit {
    std::string unit, in;
    int line;
    bool used = false;
};
using Units = std::multimap<std::string, Unit>;

/// The unit of `parameter` in `function`: the row that names the function, else the one for all.
Unit* find_unit(Units& units, const std::string& parameter, const std::string& function) {
    Unit* found = nullptr;
    const auto [first, last] = units.equal_range(parameter);
    for (auto row = first; row != last; ++row) {
        bool fits = row->second.in.empty() && found == nullptr;
        for (const std::string& word : page::split_words(row->second.in))
            fits = fits || function.find(word) != std::string::npos;
        found = fits ? &row->second : found;
    }
    if (found != nullptr) found->used = true;
    return found;
}

/// What stands between tags.
std::string words_of(std::string html) {
    for (std::size_t at; (at = html.find('<')) != std::string::npos;) html.erase(at, html.find('>', at) + 1 - at);
    return page::replace_all(page::replace_all(html, "&lt;", "<"), "&gt;", ">");
}

/// The page with the units beside its parameters.
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
        const std::string where = words_of(html.substr(function, html.find("</td>", function) - function));
        const std::string parameter = html.substr(begin + open.size(), end - begin - open.size());
        const Unit* unit = find_unit(units, parameter, where);
        if (unit == nullptr) {
            missing.insert("docs/library/units.tsv:1: has no unit for the parameter " + parameter + " of " +
                           std::string{page::trim(where)});
            continue;
        }
        filled += html.substr(done, end + close.size() - done);
        if (!unit->unit.empty()) filled += "<span class=\"unit\">" + page::escape_html(unit->unit) + "</span>";
        done = end + close.size();
    }
    return filled + html.substr(done);
}

/// The headers of the library, from Doxygen's tags: "timestep/run.hpp".
std::set<std::string> headers_in(const fs::path& tags) {
    std::set<std::string> headers;
    std::string name;
    for (const std::string& line : page::split_lines(page::read_file(tags))) {
        const auto inner = [&](const std::string& tag) {
            return page::between(line, "<" + tag + ">", "</" + tag + ">");
        };
        name = inner("name").empty() ? name : inner("name");
        const std::string path = inner("path"), root = "include/timestep/";
        if (const std::size_t at = path.find(root); at != std::string::npos)
            headers.insert("timestep/" + path.substr(at + root.size()) + name);
    }
    return headers;
}

void hold_groups(const fs::path& file, const fs::path& tags) {
    std::set<std::string> headers = headers_in(tags);
    for (const auto& [cells, line] : page::rows_of(file, 2)) {
        if (headers.erase(cells[0]) == 0)
            throw page::Error{file.string(), line, "there is no second header " + cells[0] + ", and perhaps no first"};
    }
    if (!headers.empty()) throw page::Error{file.string(), 1, "has no group for " + *headers.begin()};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: library_pages SITE TAGS FOLDER\n";
        return 2;
    }
    try {
        const fs::path site{argv[1]}, folder{argv[3]};
        hold_groups(folder / "groups.tsv", argv[2]);
        Units units;
        for (const auto& [cells, line] : page::rows_of(folder / "units.tsv", 3))
            units.emplace(cells[0], Unit{cells[1], cells[2], line});
        std::set<std::string> missing;
        for (const auto& entry : fs::directory_iterator{site}) {
            const std::string name = entry.path().filename().string();
            if (name.ends_with(".html") && !name.ends_with("_source.html")) {
                const std::string html = page::read_file(entry.path()), filled = with_units(html, units, missing);
                if (filled != html) page::write_file(entry.path(), filled);
            }
        }
        for (const std::string& line : missing) std::cerr << line << "\n";
        if (!missing.empty()) return 2;
        for (const auto& [parameter, unit] : units) {
            if (!unit.used) {
                throw page::Error{(folder / "units.tsv").string(), unit.line,
                                  "no function has a parameter " + parameter + " there"};
            }
        }
        return 0;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
