// Links and colours of the code on the finished pages, as only then all names are known.
//
// In a listing Doxygen links each name that it knows from anywhere: `dot` of one program to the product of two vectors.
// The names that Doxygen left tell which of them mean one thing only. And Doxygen 1.9 colours parts of names as words
// of C++, the `float` and `int` of floating_point, and misses others.

#include "finish_site.hpp"
#include "text.hpp"

#include <set>
#include <string_view>

namespace page {
namespace {

// ---- Links to names ---------------------------------------------------------------------------------

/// A link of Doxygen's in a listing.
struct Link {
    std::size_t begin, end;
    std::string kind, address, name;

    /// Does the code declare the name there? A type stands before it.
    bool declares(const std::string& html) const {
        const std::string_view before = std::string_view{html}.substr(0, begin);
        const bool keyword = before.ends_with("</span> ");
        const std::string_view span = keyword ? before.substr(before.rfind("<span")) : "";
        return span.find("keywordtype") != span.npos || span.find(">auto<") != span.npos || before.ends_with("</a> ") ||
               before.ends_with("&gt; ") || before.ends_with("&amp; ");
    }
    bool is_type() const { return kind != "hl_function" && kind != "hl_variable" && kind != "hl_enumvalue"; }
};

Link next_link(const std::string& html, std::size_t from, std::size_t to) {
    Link link{html.find("<a class=\"code ", from), 0, "", "", ""};
    if (link.begin >= to) return {to, to, "", "", ""};
    link.end = html.find("</a>", link.begin) + 4;
    const std::string tag = html.substr(link.begin, link.end - link.begin);
    link.kind = between(tag, "code ", "\"");
    link.address = between(tag, "href=\"", "\"");
    link.name = between(tag, ">", "</a>");
    return link;
}

/// One listing of a page, and whether it quotes a header of the library.
struct Listing {
    std::size_t begin, end;
    bool of_library;
};

std::vector<Listing> listings_of(const std::string& html) {
    static const std::string open = "<div class=\"fragment\">", close = "<!-- fragment -->";
    std::vector<Listing> listings;
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at + 1)) {
        const std::size_t figure = html.rfind("<figure class=\"listing\"", at), end = html.find(close, at);
        if (end == std::string::npos) break;
        const bool quotes = figure != std::string::npos && html.find("</figure>", figure) > at;
        listings.push_back(
            {at, end, quotes && html.substr(figure, at - figure).find(">include/") != std::string::npos});
    }
    return listings;
}

// ---- Colours ----------------------------------------------------------------------------------------

/// Doxygen's class for a word of C++20; nothing for any other.
std::string kind_of(const std::string& word) {
    static const std::string
        types = " bool char double float int long short signed unsigned void ",
        flow = " break case catch continue default do else for goto if return switch throw try while ",
        others =
            " alignas auto class concept const const_cast consteval constexpr constinit decltype "
            "delete dynamic_cast enum explicit extern false friend inline mutable namespace new "
            "noexcept nullptr operator override private protected public requires sizeof static "
            "static_assert static_cast struct template this thread_local true typedef typename union "
            "using virtual volatile ";
    const std::string one = " " + word + " ";
    const auto in = [&one](const std::string& words) { return words.find(one) != std::string::npos; };
    return in(types) ? "keywordtype" : in(flow) ? "keywordflow" : in(others) ? "keyword" : "";
}

/// A listing without Doxygen's colours of words.
std::string without_keywords(const std::string& listing) {
    static const std::string open = "<span class=\"keyword", close = "</span>";
    std::string plain;
    std::size_t done = 0;
    for (std::size_t at; (at = listing.find(open, done)) != std::string::npos;) {
        const std::size_t begin = listing.find('>', at) + 1, end = listing.find(close, begin);
        plain += listing.substr(done, at - done) + listing.substr(begin, end - begin);
        done = end + close.size();
    }
    return plain + listing.substr(done);
}

std::string with_keywords(const std::string& listing) {
    std::string coloured;
    int inside = 0;  // of comments, texts and links, which have their colour
    for (std::size_t at = 0; at < listing.size();) {
        std::size_t end = at + 1;
        if (listing.compare(at, 16, "<div class=\"ttc\"") == 0) {  // what is shown beside a link
            end = std::min(listing.find('\n', at), listing.size());
        } else if (listing[at] == '<' || listing[at] == '&') {
            end = listing.find(listing[at] == '<' ? '>' : ';', at) + 1;
            const std::string tag = listing.substr(at, end - at);
            inside += (tag.starts_with("<span") || tag.starts_with("<a ")) - (tag == "</span>" || tag == "</a>");
        } else if (in_word(listing[at])) {
            while (end < listing.size() && in_word(listing[end])) ++end;
            const std::string word = listing.substr(at, end - at), kind = inside > 0 ? "" : kind_of(word);
            coloured += kind.empty() ? word : "<span class=\"" + kind + "\">" + word + "</span>";
            at = end;
            continue;
        }
        coloured += listing.substr(at, end - at);
        at = end;
    }
    return coloured;
}

}  // namespace

SourcePages find_source_pages(const std::filesystem::path& site) {
    SourcePages pages;
    for (const auto& entry : std::filesystem::directory_iterator{site}) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with("_source.html")) continue;
        const std::string title = between(page::read_file(entry.path()), "<title>", "</title>");
        pages[between(title, ": ", " Source File")] = name;
    }
    return pages;
}

Owners owners_in(const std::vector<Name>& names) {
    Owners owners;
    for (const Name& name : names) {
        const bool in_scope = name.compound == "struct" || name.compound == "class" || name.compound == "namespace";
        if (in_scope && (name.kind == "function" || name.kind == "variable")) owners[name.name].insert(name.owner);
    }
    return owners;
}

std::string with_source_links(std::string html, const SourcePages& pages, const std::string& name,
                              const std::string& unlinked) {
    static const std::string marker = "href=\"source:";
    for (std::size_t at = 0; (at = html.find(marker, at)) != std::string::npos;) {
        const std::size_t path = at + marker.size(), end = html.find_first_of("#\"", path);
        const std::string file = html.substr(path, end - path);
        const auto found = pages.find(file);
        if (!unlinked.empty() && file.starts_with(unlinked)) {
            html.erase(at, html.find('"', path) + 1 - at);
        } else if (found == pages.end()) {
            throw Error{name, 1, "links to " + file + ", which the site does not show"};
        } else {
            html.replace(at, end - at, "href=\"" + found->second);
        }
    }
    return html;
}

std::string with_meant_links(std::string html, const Owners& owners) {
    const auto declared = [&html](const Listing& in, std::set<std::string>& names) {
        for (Link link = next_link(html, in.begin, in.end); link.begin < in.end;
             link = next_link(html, link.end, in.end))
            if (!link.is_type() && link.declares(html)) names.insert(link.name);
    };
    std::set<std::string> own;  // what the programs on this page declare
    for (const Listing& listing : listings_of(html))
        if (!listing.of_library) declared(listing, own);

    const auto stays = [&](const Link& link, const Listing& in, const std::set<std::string>& own_here) {
        if (link.is_type()) return link.name.size() > 1;  // V is a parameter of some template
        if (link.name.find("::") != std::string::npos) return true;
        const char after = html[link.end];
        if (html[link.begin - 1] == '.' || link.kind == "hl_enumvalue") return false;
        if (link.kind == "hl_function" && after != '(' && after != '&' && after != '{') return false;
        const auto found = owners.find(link.name);
        const bool one = found == owners.end() || found->second.size() == 1;
        if (!in.of_library) return one && own.count(link.name) == 0;
        const bool of_class = link.address.starts_with("struct") || link.address.starts_with("class");
        return one || (!of_class && own_here.count(link.name) == 0);
    };
    std::vector<Listing> listings = listings_of(html);
    for (auto each = listings.rbegin(); each != listings.rend(); ++each) {
        std::set<std::string> own_here, kept;
        declared(*each, own_here);
        std::string code = html.substr(each->begin, each->end - each->begin), linked;
        std::size_t done = each->begin;
        for (Link link = next_link(html, done, each->end); link.begin < each->end;
             link = next_link(html, link.end, each->end)) {
            const bool keep = stays(link, *each, own_here);
            if (keep) kept.insert(link.address);
            linked += html.substr(done, link.begin - done) +
                      (keep ? html.substr(link.begin, link.end - link.begin) : link.name);
            done = link.end;
        }
        linked += html.substr(done, each->end - done);
        static const std::string tip = "<div class=\"ttc\"";
        for (std::size_t at = 0; (at = linked.find(tip, at)) != std::string::npos;) {
            const std::size_t line = linked.find('\n', at);
            const bool shown =
                kept.count(between(linked.substr(at, line - at), "<div class=\"ttname\"><a href=\"", "\""));
            shown ? void(at = line) : void(linked.erase(at, line + 1 - at));
        }
        html.replace(each->begin, each->end - each->begin, linked);
    }
    return html;
}

std::string with_colours(std::string html) {
    const std::vector<Listing> listings = listings_of(html);
    for (auto each = listings.rbegin(); each != listings.rend(); ++each) {
        const std::string listing = html.substr(each->begin, each->end - each->begin);
        if (listing.find("<span class=\"") != std::string::npos)  // else it is a command, no C++
            html.replace(each->begin, listing.size(), with_keywords(without_keywords(listing)));
    }
    return html;
}

}  // namespace page
