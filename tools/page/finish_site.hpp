#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace page {

/// A name in Doxygen's file of tags: a compound (file, class, namespace), or a member of one.
struct Name {
    std::string compound;    ///< the compound's kind
    std::string kind, name;  ///< of the name itself
    std::string path;        ///< a file's folder
    std::string address;     ///< below the site
};

// ---- Code on the pages (listings.cpp) ---------------------------------------------------------------

/// The page of each source file.
using SourcePages = std::map<std::string, std::string>;
/// `<title>Timestep: include/timestep/run.hpp Source File</title>` names the file of a source's page.
SourcePages find_source_pages(const std::filesystem::path& site);
/// The page with its links `source:tests/library/run.cpp#l00042` resolved; in the folder `unlinked` nothing is linked.
/// Throws Error for a source that the site does not show.
std::string with_source_links(std::string html, const SourcePages& pages, const std::string& name,
                              const std::string& unlinked);
/// The page with links to types and qualified names alone in its listings; what Doxygen shows beside another link goes
/// with it.
std::string with_sure_links(const std::string& html);
/// The page with the words of C++20 coloured in its listings.
std::string with_colours(const std::string& html);

// ---- Units and groups of the library (units.cpp) ----------------------------------------------------

/// What a parameter is measured in; in functions whose name holds one of the words `in`, or in all others.
struct Unit {
    std::string unit, in;
    int line;
    bool used = false;
};
using Units = std::multimap<std::string, Unit>;
Units read_units(const std::filesystem::path& file);
/// The page with the units beside its parameters. A parameter without a unit goes to `missing`, as a message.
std::string with_units(const std::string& html, Units& units, std::set<std::string>& missing);
/// Throw Error for a unit that stands for nothing, and for a header without a group or a group without a header.
void check_all_used(const std::filesystem::path& file, const Units& units);
void check_groups(const std::filesystem::path& file, const std::vector<Name>& names);

// ---- Search (search_index.cpp) ----------------------------------------------------------------------

/// The script that holds what the search looks through.
std::string search_places(const std::filesystem::path& site, const std::vector<Name>& names);

}  // namespace page
