#include "listings.hpp"

#include "error.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace page {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view source_page = "_source.html", page_end = ".html";

std::string between(const std::string& text, const std::string& open, const std::string& close, std::size_t from = 0) {
    const std::size_t begin = text.find(open, from);
    const std::size_t end = begin == std::string::npos ? begin : text.find(close, begin + open.size());
    return end == std::string::npos ? "" : text.substr(begin + open.size(), end - begin - open.size());
}

/// "run_8hpp.html" and "run_8hpp_source.html" without their ends.
std::string file_of_page(const std::string& page) {
    const std::string_view end = page.ends_with(source_page) ? source_page : page_end;
    return page.ends_with(end) ? page.substr(0, page.size() - end.size()) : "";
}

std::string without(std::string html, const std::string& open, const std::string& close) {
    for (std::size_t at = 0; (at = html.find(open, at)) != std::string::npos;) {
        const std::size_t end = html.find(close, at);
        html.erase(at, end == std::string::npos ? end : end + close.size() - at);
    }
    return html;
}

/// The code on a source page, without comments and texts.
std::string code_of(std::string html) {
    for (const char* kind : {"lineno", "comment", "stringliteral", "preprocessor"})
        html = without(html, std::string{"<span class=\""} + kind + "\">", "</span>");
    html = without(html, "<div class=\"ttc\"", "\n");
    html = without(html, "<", ">");
    for (const auto& [sign, is] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}, {"&#160;", " "}})
        html = replace_all(html, sign, is);
    return html;
}

/// Does the text before a name end in a type, as in `double `, `Vector3<Real>& ` and `auto [x, `?
bool ends_in_type(const std::string& code, std::size_t at) {
    if (at < 2 || code[at - 1] != ' ')
        return at > 0 && code[at - 1] == '[' && code.substr(0, at - 1).ends_with("auto ");
    const char last = code[at - 2];
    if (last == ',') {
        const std::size_t open = code.find_last_of("[]{}();", at);
        return open != std::string::npos && code[open] == '[' && code.substr(0, open).ends_with("auto ");
    }
    if (last == '>' || last == '&' || last == '*') return at > 2 && code[at - 3] != ' ' && code[at - 3] != last;
    if (!in_word(last)) return false;
    std::size_t begin = at - 2;
    while (begin > 0 && in_word(code[begin - 1])) --begin;
    const std::string word = code.substr(begin, at - 1 - begin);
    static constexpr std::array<std::string_view, 8> no_types{"return", "throw", "case", "new",
                                                              "delete", "else",  "goto", "using"};
    return std::find(no_types.begin(), no_types.end(), word) == no_types.end();
}

/// Does it declare something of that name, or assign to it?
bool declares(const std::string& code, const std::string& name) {
    for (std::size_t at = code.find(name); at != std::string::npos; at = code.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at > 0 && in_word(code[at - 1])) || (end < code.size() && in_word(code[end]))) continue;
        const std::string next = code.substr(end, 3);
        const bool assigned = next.starts_with(" =") && next != " ==" && (at == 0 || code[at - 1] != '.');
        if (assigned) return true;
        if (!next.empty() && std::string_view{",);{(]"}.find(next[0]) != std::string_view::npos &&
            ends_in_type(code, at))
            return true;
    }
    return false;
}

}  // namespace

Listings::Listings(const fs::path& site, const fs::path& tags) {
    read_tags(tags);
    read_sources(site);
}

// First come the files, with what is in each; then classes and namespaces, with what each owns.
void Listings::read_tags(const fs::path& tags) {
    std::string kind, owner, file, name, page;
    std::map<std::string, std::string> home_of_class;
    for (const std::string& line : split_lines(read_file(tags))) {
        const auto inner = [&line](const std::string& tag) { return between(line, "<" + tag + ">", "</" + tag + ">"); };
        if (const std::string opened = between(line, "<compound kind=\"", "\""); !opened.empty()) {
            kind = opened;
            owner.clear(), file.clear();
        }
        if (kind == "file") {
            if (const std::string named = inner("filename"); !named.empty()) file = file_of_page(named);
            if (const std::string id = between(line, "<includes id=\"", "\""); !id.empty()) includes_[file].insert(id);
            if (const std::string one = between(line, "<class kind=\"", "</class>"); !one.empty())
                home_of_class[one.substr(one.find('>') + 1)] = file;
            if (const std::string anchored = inner("anchorfile"); !anchored.empty()) page = anchored;
            if (const std::string anchor = inner("anchor"); !anchor.empty()) home_[page + "#" + anchor] = file;
        }
        if (kind != "struct" && kind != "class" && kind != "namespace") continue;
        if (const std::string named = inner("name"); !named.empty()) (owner.empty() ? owner : name) = named;
        if (const std::string filename = inner("filename"); !filename.empty() && kind != "namespace") {
            const std::size_t last = owner.rfind("::");
            things_[filename] = {last == std::string::npos ? owner : owner.substr(last + 2),
                                 owner.substr(0, std::min(last, owner.size()))};
            if (home_of_class.contains(owner)) home_[filename] = home_of_class[owner];
        }
        if (const std::string anchored = inner("anchorfile"); !anchored.empty()) page = anchored;
        if (const std::string anchor = inner("anchor");
            !anchor.empty() && !owner.ends_with("::" + name)) {  // a constructor is no other thing
            things_[page + "#" + anchor] = {name, owner};
            if (home_of_class.contains(owner)) home_[page + "#" + anchor] = home_of_class[owner];
        }
    }
    for (const auto& [address, thing] : things_) called_.emplace(thing.name, address);
}

void Listings::read_sources(const fs::path& site) {
    std::map<std::string, std::string> by_path;
    for (const auto& entry : fs::directory_iterator{site}) {
        const std::string page = entry.path().filename().string();
        if (!page.ends_with(source_page)) continue;
        const std::string html = read_file(entry.path()), file = file_of_page(page);
        by_path[between(html, "<title>Timestep: ", " Source File</title>")] = file;
        code_[file] = code_of(html);
        static const std::string include = "#include ";
        for (std::size_t at = html.find(include); at != std::string::npos; at = html.find(include, at + 1)) {
            const std::string line = html.substr(at, html.find('\n', at) - at);
            const std::string linked = file_of_page(between(line, "href=\"", "\""));
            includes_[file].insert(linked.empty() ? between(line, "&quot;", "&quot;") : linked);
        }
    }
    // Files without documentation have no page to be linked to: "derivatives.hpp" is that of the same folder.
    for (const auto& [path, file] : by_path) {
        const std::set<std::string> named = includes_[file];
        for (const std::string& name : named)
            for (const auto& [other, id] : by_path)
                if (!name.empty() && (other == name || other.ends_with("/" + name)) && (id != file))
                    includes_[file].insert(id);
    }
}

std::set<std::string> Listings::seen_from(const std::string& file) const {
    std::set<std::string> seen{file}, todo{file};
    while (!todo.empty()) {
        const auto found = includes_.find(todo.extract(todo.begin()).value());
        if (found == includes_.end()) continue;
        for (const std::string& next : found->second)
            if (seen.insert(next).second) todo.insert(next);
    }
    return seen;
}

bool Listings::means(const std::string& file, const std::set<std::string>& seen, const std::string& address) const {
    const auto thing = things_.find(address);
    if (thing == things_.end()) return true;  // a header, a macro: nothing to guess
    const auto is_seen = [&](const std::string& place) {
        const auto home = home_.find(place);
        return home != home_.end() && seen.contains(home->second);
    };
    if (!is_seen(address)) return false;
    const auto [first, last] = called_.equal_range(thing->second.name);
    const bool one = std::all_of(first, last, [&](const auto& other) {
        return !is_seen(other.second) || things_.at(other.second).owner == thing->second.owner;
    });
    const auto code = code_.find(file);
    return one && (home_.at(address) == file || code == code_.end() || !declares(code->second, thing->second.name));
}

namespace {

/// Can it be what its link says? A function is called, and a value stands behind its enumeration: else a variable of
/// the same name is meant.
bool can_be(const std::string& link, char before, char after) {
    if (link.find("hl_function") != std::string::npos) return after == '(' || after == '&' || after == '{';
    return link.find("hl_enumvalue") == std::string::npos || before == ':';
}

/// Names linked in a listing: `keeps` says whether a link stays, by itself and what stands before it. What would be
/// shown beside the others goes with them.
template <class Keeps>
std::string with_links(std::string listing, const Keeps& keeps) {
    static const std::string link = "<a class=\"code ", tip = "<div class=\"ttc\"";
    std::set<std::string> kept;
    for (std::size_t in = listing.find(link); in != std::string::npos; in = listing.find(link, in)) {
        const std::string address = between(listing, "href=\"", "\"", in),
                          opened = listing.substr(in, listing.find('>', in) - in);
        const char before = in > 0 ? listing[in - 1] : ' ',
                   after = listing[std::min(listing.find("</a>", in) + 4, listing.size() - 1)];
        if (can_be(opened, before, after) && keeps(opened, address, before)) {
            kept.insert(address);
            ++in;
            continue;
        }
        listing.erase(listing.find("</a>", in), 4);
        listing.erase(in, listing.find('>', in) + 1 - in);
    }
    for (std::size_t in = listing.find(tip); in != std::string::npos; in = listing.find(tip, in)) {
        const bool stays = kept.contains(between(listing, "<div class=\"ttname\"><a href=\"", "\"", in));
        const std::size_t line = listing.find('\n', in);
        stays ? void(in = line) : void(listing.erase(in, line + 1 - in));
    }
    return listing;
}

}  // namespace

std::string Listings::meant(std::string html) const {
    static const std::string open = "<figure class=\"listing\"", close = "</figure>";
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at + 1)) {
        const std::size_t end = html.find(close, at);
        const std::string figure = html.substr(at, end - at), file = file_of_page(between(figure, "href=\"", "#"));
        if (file.empty() || !code_.contains(file)) continue;
        const std::set<std::string> seen = seen_from(file);
        html.replace(at, end - at, with_links(figure, [&](const std::string&, const std::string& address, char before) {
                         return means(file, seen, address) && !(before == '.' && in_namespace(address));
                     }));
    }
    return html;
}

namespace {

/// The page, in those pieces of code that quote no file: `keeps` as above.
template <class Keeps>
std::string in_own_code(std::string html, const Keeps& keeps) {
    static const std::string open = "<div class=\"fragment\"", close = "<!-- fragment -->";
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at + 1)) {
        const std::size_t figure = html.rfind("<figure class=\"listing\"", at), end = html.find(close, at);
        if (end == std::string::npos || (figure != std::string::npos && html.find("</figure>", figure) > at)) continue;
        html.replace(at, end - at, with_links(html.substr(at, end - at), keeps));
    }
    return html;
}

}  // namespace

std::string Listings::types_alone(std::string html) {
    return in_own_code(std::move(html), [](const std::string& link, const std::string&, char) {
        return link.find("hl_function") == std::string::npos && link.find("hl_variable") == std::string::npos;
    });
}

std::string Listings::calls_alone(std::string html) {
    return in_own_code(std::move(html), [](const std::string& link, const std::string&, char before) {
        return before != '.' || link.find("hl_function") == std::string::npos;
    });
}

bool Listings::in_namespace(const std::string& address) const {
    const auto thing = things_.find(address);
    if (thing == things_.end()) return false;
    const std::string& owner = thing->second.owner;
    const std::size_t last = owner.rfind("::");
    return std::islower(static_cast<unsigned char>(owner[last == std::string::npos ? 0 : last + 2])) != 0;
}

}  // namespace page
