// Links and colours of the code on the finished pages, as only then all names are known.
//
// In a listing Doxygen links each name that it knows from anywhere: `dot` of one program to the product of two vectors.
// Only types and qualified names are sure to mean what it links. And Doxygen 1.9 colours parts of names as words of
// C++, the `float` and `int` of floating_point, and misses others.

#include "finish_site.hpp"
#include "text.hpp"

#include <set>
#include <string_view>

namespace page {
namespace {

/// Calls `change` with each listing of the page, and puts in what it returns.
template <class Change>
std::string with_listings(const std::string& html, Change change) {
    static const std::string open = "<div class=\"fragment\">", close = "<!-- fragment -->";
    std::string changed;
    std::size_t done = 0;
    for (std::size_t at; (at = html.find(open, done)) != std::string::npos;) {
        const std::size_t end = html.find(close, at);
        if (end == std::string::npos) break;
        changed += html.substr(done, at - done) + change(html.substr(at, end - at));
        done = end;
    }
    return changed + html.substr(done);
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

std::string with_sure_links(const std::string& html) {
    static const std::string open = "<a class=\"code ", close = "</a>", tip = "<div class=\"ttc\"";
    return with_listings(html, [](std::string listing) {
        std::set<std::string> kept;
        for (std::size_t at = 0; (at = listing.find(open, at)) != std::string::npos;) {
            const std::size_t end = listing.find(close, at) + close.size();
            const std::string link = listing.substr(at, end - at), kind = between(link, open, "\""),
                              name = between(link, ">", close);
            const bool is_type = kind != "hl_function" && kind != "hl_variable" && kind != "hl_enumvalue";
            // A type of one letter is a parameter of some template.
            const bool is_sure = (is_type && name.size() > 1) || name.find("::") != std::string::npos;
            if (is_sure)
                kept.insert(between(link, "href=\"", "\""));
            else
                listing.replace(at, end - at, name);
            at = is_sure ? end : at + name.size();
        }
        for (std::size_t at = 0; (at = listing.find(tip, at)) != std::string::npos;) {
            const std::size_t end = listing.find('\n', at) + 1;
            const bool is_shown =
                kept.count(between(listing.substr(at, end - at), "<div class=\"ttname\"><a href=\"", "\"")) > 0;
            is_shown ? void(at = end) : void(listing.erase(at, end - at));
        }
        return listing;
    });
}

std::string with_colours(const std::string& html) {
    return with_listings(html, [](const std::string& listing) {
        // Without a span it is a command, no C++.
        const bool is_code = listing.find("<span class=\"") != std::string::npos;
        return is_code ? with_keywords(without_keywords(listing)) : listing;
    });
}

}  // namespace page
