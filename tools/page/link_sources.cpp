// link_sources: turns links to source files into links to their pages in the finished site.
//
// A page links to a source as `source:tests/library/run.cpp#l00042`, for the name that Doxygen
// gives to that file's page depends on all the other files. Here, after Doxygen, the names are
// known: each source page carries its file in its title.
//
// And of the links that Doxygen guesses in listings stay those that are meant (listings.hpp), and who
// hears a page read is told which part of it is what.
//
//     link_sources SITE TAGS [UNLINKED]
//
// A source in the folder UNLINKED is left without a link: the learner's edition shows no tests.

#include "error.hpp"
#include "listings.hpp"
#include "text.hpp"

#include <filesystem>
#include <iostream>
#include <map>
#include <string_view>

namespace {

namespace fs = std::filesystem;
using SourcePages = std::map<std::string, std::string>;

/// `<title>Timestep: include/timestep/run.hpp Source File</title>` tells
/// `include/timestep/run.hpp`.
SourcePages find_source_pages(const fs::path& site) {
    SourcePages pages;
    for (const auto& entry : fs::directory_iterator{site}) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with("_source.html")) {
            continue;
        }
        const std::string html = page::read_file(entry.path());
        const std::size_t begin = html.find("<title>");
        const std::size_t colon = html.find(": ", begin);
        const std::size_t end = html.find(" Source File</title>", begin);
        if (begin != std::string::npos && colon < end && end != std::string::npos) {
            pages[html.substr(colon + 2, end - colon - 2)] = name;
        }
    }
    return pages;
}

/// The page with its links resolved. A source that the site does not show is an Error, but for one
/// that is to be left without a link.
std::string resolve(const std::string& html, const SourcePages& pages, const std::string& name,
                    const std::string& unlinked) {
    const std::string marker = "href=\"source:";
    std::string resolved;
    std::size_t at = 0;
    while (true) {
        const std::size_t link = html.find(marker, at);
        resolved += html.substr(at, link - at);
        if (link == std::string::npos) {
            return resolved;
        }
        const std::size_t path = link + marker.size();
        const std::size_t end = html.find_first_of("#\"", path);
        const std::string file = html.substr(path, end - path);
        if (!unlinked.empty() && file.starts_with(unlinked)) {
            at = html.find('"', path) + 1;
            continue;
        }
        const auto found = pages.find(file);
        if (found == pages.end()) {
            throw page::Error{name, 1, "links to " + file + ", which the site does not show"};
        }
        resolved += "href=\"" + found->second;
        at = end;
    }
}

/// A source's page whose lines have their place by `id` alone: by `name`, too, they weigh a tenth more.
std::string named_once(const std::string& html) {
    static const std::string open = "<a id=\"l", again = " name=\"l";
    std::string once;
    std::size_t done = 0;
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at)) {
        at = html.find('"', at + open.size()) + 1;
        if (html.compare(at, again.size(), again) == 0) {
            once += html.substr(done, at - done);
            done = at = html.find('"', at + again.size()) + 1;
        }
    }
    return once + html.substr(done);
}

/// Is it a page of what the library has, whose examples speak of nothing else?
bool is_of_library(const std::string& name) {
    return name.starts_with("group__") || name.starts_with("struct") || name.starts_with("class") ||
           name.starts_with("namespace") || name.starts_with("concept");
}

/// What Doxygen does not say of its page: which part is what, for those who hear it read.
std::string with_named_parts(std::string html) {
    struct Part {
        std::string_view begin, said;
    };
    static constexpr Part parts[]{
        {"<div id=\"doc-content\"", " role=\"main\""},
        {"<div id=\"titlearea\"", " role=\"banner\""},
        {"<div id=\"side-nav\"", " role=\"navigation\" aria-label=\"Contents\""},
        {"<div id=\"nav-path\"", " role=\"navigation\" aria-label=\"Where this page is\""},
        {"<div class=\"headertitle\"><div class=\"title\"", " role=\"heading\" aria-level=\"1\""}};
    for (const auto& [begin, said] : parts) {
        const std::size_t at = html.find(begin);
        if (at != std::string::npos) {
            html.insert(at + begin.size(), said);
        }
    }
    static constexpr std::string_view icon = "><span class=\"icondoc\"", label = " aria-label=\"Source\"";
    for (std::size_t at = html.find(icon); at != std::string::npos; at = html.find(icon, at + label.size() + 1)) {
        html.insert(at, label);
    }
    return html;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) {
        std::cerr << "usage: link_sources SITE TAGS [UNLINKED]\n";
        return 2;
    }
    try {
        const SourcePages pages = find_source_pages(argv[1]);
        const page::Listings listings{argv[1], argv[2]};
        for (const auto& entry : fs::directory_iterator{argv[1]}) {
            const std::string name = entry.path().filename().string();
            if (entry.path().extension() == ".html") {
                const std::string html = page::read_file(entry.path());
                std::string resolved;
                if (name.ends_with("_source.html")) {
                    resolved = named_once(html);
                } else {
                    resolved = listings.meant(resolve(html, pages, name, argc == 4 ? argv[3] : ""));
                    resolved = is_of_library(name) ? page::Listings::calls_alone(resolved)
                                                   : page::Listings::types_alone(resolved);
                }
                resolved = with_named_parts(page::with_keywords(resolved));
                if (resolved != html) {
                    page::write_file(entry.path(), resolved);
                }
            }
        }
        return 0;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
