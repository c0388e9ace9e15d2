// finish_site: gives Doxygen's pages what only the finished site knows.
//
//     finish_site SITE TAGS LIBRARY [UNLINKED]
//
// Links and colours the code on the pages, writes units beside the library's parameters, and holds LIBRARY's groups.tsv
// and units.tsv to what Doxygen has found; TAGS are the names that it left. A source in the folder UNLINKED is left
// without a link, since the learner's edition shows no tests. Where SITE has lunr, what it searches is written, too.

#include "finish_site.hpp"
#include "text.hpp"

#include <iostream>

namespace {

namespace fs = std::filesystem;

std::vector<page::Name> read_names(const fs::path& tags) {
    std::vector<page::Name> names;
    std::string compound;
    for (const std::string& line : page::split_lines(page::read_file(tags))) {
        const auto inner = [&](const std::string& tag) {
            return page::between(line, "<" + tag + ">", "</" + tag + ">");
        };
        const std::string begun = page::between(line, "<compound kind=\"", "\""),
                          member = page::between(line, "<member kind=\"", "\"");
        if (!begun.empty()) compound = begun;
        if (!begun.empty() || !member.empty()) names.push_back({compound, begun + member, "", "", ""});
        if (names.empty()) continue;
        page::Name& name = names.back();
        if (name.name.empty()) name.name = inner("name");
        if (name.path.empty()) name.path = inner("path");
        if (name.address.empty()) name.address = inner("filename") + inner("anchorfile");
        if (const std::string anchor = inner("anchor"); !anchor.empty()) name.address += "#" + anchor;
    }
    return names;
}

void finish(const fs::path& site, const fs::path& tags, const fs::path& library, const std::string& unlinked) {
    const std::vector<page::Name> names = read_names(tags);
    page::check_groups(library / "groups.tsv", names);
    page::Units units = page::read_units(library / "units.tsv");
    const page::SourcePages sources = page::find_source_pages(site);
    std::set<std::string> missing;
    for (const auto& entry : fs::directory_iterator{site}) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".html") continue;
        const std::string html = page::read_file(entry.path());
        std::string finished = html;
        if (!name.ends_with("_source.html")) {
            finished = page::with_source_links(page::with_sure_links(html), sources, name, unlinked);
            finished = page::with_units(finished, units, missing);
        }
        finished = page::with_colours(finished);
        if (finished != html) page::write_file(entry.path(), finished);
    }
    std::string all;
    for (const std::string& line : missing) all += (all.empty() ? "" : "\n") + line;
    if (!missing.empty()) throw std::runtime_error{all};
    page::check_all_used(library / "units.tsv", units);
    if (fs::exists(site / "lunr.min.js")) page::write_file(site / "search_places.js", page::search_places(site, names));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 5) {
        std::cerr << "usage: finish_site SITE TAGS LIBRARY [UNLINKED]\n";
        return 2;
    }
    try {
        finish(argv[1], argv[2], argv[3], argc == 5 ? argv[4] : "");
        return 0;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
