// What the search of the site looks through: every page of words in its sections, the glossary's words with the place
// to which each leads, and the library's names. Each place has its address `u`, its title `t`, the title of its page
// `p` and its words `x`.

#include "finish_site.hpp"
#include "text.hpp"

#include <cctype>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

namespace page {
namespace {

namespace fs = std::filesystem;

nlohmann::json place(const std::string& address, const std::string& title, const std::string& page,
                     const std::string& words) {
    return {{"u", address}, {"t", title}, {"p", page}, {"x", words}};
}

/// Words without tags, formulas and listings.
std::string words_of(std::string html) {
    const std::pair<std::string, std::string> gone[] = {{"<div class=\"fragment\">", "<!-- fragment -->"},
                                                        {"<pre", "</pre>"},
                                                        {"<script", "</script>"},
                                                        {"<!--", "-->"},
                                                        {"\\(", "\\)"},
                                                        {"\\[", "\\]"},
                                                        {"<", ">"}};
    for (const auto& [open, close] : gone)
        for (std::size_t at = 0; (at = html.find(open, at)) != std::string::npos;) {
            const std::size_t end = html.find(close, at);
            html.replace(at, end == std::string::npos ? end : end - at + close.size(),
                         open[0] == '\\' ? " … " : " ");  // a formula leaves a gap
        }
    std::string text = html;
    for (const auto& [name, sign] :
         {std::pair{"&#39;", "'"}, {"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&#160;", " "}, {"&amp;", "&"}})
        text = replace_all(text, name, sign);
    std::string line;
    for (const std::string& word : split_words(text)) line += (line.empty() ? "" : " ") + word;
    for (const auto& [apart, close] :
         {std::pair{"( ", "("}, {" )", ")"}, {" .", "."}, {" ,", ","}, {" :", ":"}, {" ;", ";"}})
        line = replace_all(line, apart, close);
    return line;
}

/// Is that one of the pages that we have written?
bool has_words(const std::string& name) {
    static const std::set<std::string> pages{"chapter_",  "more_",         "index",         "which_method",
                                             "exercises", "exercises_",    "teaching",      "promises",
                                             "methods",   "rigid_methods", "in_your_engine"};
    if (!name.ends_with(".html")) return false;
    const std::string stem = name.substr(0, name.size() - 5);
    const std::size_t number = stem.find_last_not_of("0123456789") + 1;
    return pages.contains(stem.substr(0, number)) && (stem[number - 1] == '_') == (number < stem.size());
}

/// A page of words, section by section.
void add_sections(const fs::path& file, nlohmann::json& places) {
    const std::string html = read_file(file), name = file.filename().string();
    const std::string title = words_of(between(html, "<div class=\"title\">", "</div>"));
    const std::size_t begin = html.find("<div class=\"textblock\">");
    if (begin == std::string::npos) return;
    const std::string text = html.substr(begin, html.find("<!-- contents -->") - begin);
    static const std::string heading = "<a class=\"anchor\" id=\"";
    const auto next_heading = [&text](std::size_t from) {  // an anchor in a text begins no section
        std::size_t at = text.find(heading, from);
        while (at != std::string::npos && (at < 4 || text.compare(at - 4, 2, "<h") != 0))
            at = text.find(heading, at + 1);
        return at;
    };
    std::size_t at = next_heading(0);
    places.push_back(place(name, title, "", words_of(text.substr(0, at))));
    while (at != std::string::npos) {
        const std::size_t next = next_heading(at + 1);
        const std::string part = text.substr(at, next - at);
        const std::string id = between(part, heading, "\"");
        const std::size_t end = part.find("</h");
        if (end != std::string::npos && !id.starts_with("autotoc"))
            places.push_back(place(name + "#" + id, words_of(part.substr(0, end)), title, words_of(part.substr(end))));
        at = next;
    }
}

/// Each word of the glossary leads to where it is explained; one that only names another, to where that is.
void add_glossary(const fs::path& file, nlohmann::json& places) {
    struct Entry {
        std::string word, address, text;
    };
    std::map<std::string, Entry> entries;
    const std::string html = read_file(file);
    static const std::string open = "<li><b>";
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at + 1)) {
        const std::string entry = between(html, open, "</li>", at);
        std::size_t end = entry.find("</b>") + 4;
        if (end < 4) continue;
        const std::string word = words_of(entry.substr(0, end));
        if (entry.compare(end, 6, " (<em>") == 0) end = std::min(entry.find("</em>)", end), entry.size() - 6) + 6;
        const std::string rest = entry.substr(end), address = between(rest, "href=\"", "\"");
        const std::string other = address.empty() ? words_of(between(rest, "see <em>", "</em>")) : "";
        entries[word] = {words_of(entry.substr(0, end)), address.empty() ? other : address,
                         words_of(rest.substr(std::min(rest.find(' '), rest.size())))};
    }
    for (const auto& [word, entry] : entries) {
        const auto other = entries.find(entry.address);
        const std::string& address = other == entries.end() ? entry.address : other->second.address;
        if (address.find(".html") != std::string::npos)
            places.push_back(place(address, entry.word, "Glossary", entry.text));
    }
}

/// "SemiImplicitEuler" is found by its words, too.
std::string apart(const std::string& name) {
    std::string words;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (i > 0 && std::isupper(static_cast<unsigned char>(name[i])) &&
            std::islower(static_cast<unsigned char>(name[i - 1])))
            words += ' ';
        words += name[i] == '_' ? ' ' : name[i];
    }
    return words;
}

/// The library's names: classes, and the functions of its namespaces.
void add_names(const std::vector<Name>& names, nlohmann::json& places) {
    std::set<std::string> seen;
    for (const Name& each : names) {
        const bool is_class = each.kind == each.compound && (each.kind == "struct" || each.kind == "class");
        const bool is_function = each.kind == "function" && each.compound == "namespace";
        const std::string name = words_of(each.name), file = each.address.substr(0, each.address.find('#'));
        if ((!is_class && !is_function) || name.find("detail") != std::string::npos) continue;
        const std::string bare = name.substr(name.rfind(':') == std::string::npos ? 0 : name.rfind(':') + 1);
        if (bare.starts_with("operator") || !seen.insert(file + bare).second) continue;
        places.push_back(place(each.address, bare, "The library", apart(bare)));
    }
}

}  // namespace

std::string search_places(const fs::path& site, const std::vector<Name>& names) {
    nlohmann::json places;
    std::set<fs::path> files;
    for (const auto& entry : fs::directory_iterator{site}) files.insert(entry.path());
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        if (has_words(name)) add_sections(file, places);
        if (name == "glossary.html") add_glossary(file, places);
    }
    add_names(names, places);
    return "const searchPlaces = " + places.dump() + ";\n";
}

}  // namespace page
