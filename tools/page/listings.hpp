#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace page {

/// What the listings of a site may link to. In a piece of a source Doxygen links each name that it knows from anywhere:
/// `dot` of one program to the product of two vectors. Of those links stay the ones that can mean but one thing there.
class Listings {
public:
    /// Reads the source pages in `site` and `tags`, the names that Doxygen left. Throws Error.
    Listings(const std::filesystem::path& site, const std::filesystem::path& tags);

    /// The page, in each listing of which a name is linked if the quoted file sees one thing of that name, itself or in
    /// what it includes, and declares nothing else by it. What would be shown beside the other links goes, too.
    std::string meant(std::string html) const;

    /// The page, in which code that quotes no file (a task's signature, a whole program) links types and headers only:
    /// of whose `step` it speaks nobody can tell.
    static std::string types_alone(std::string html);

    /// The page of the library, whose examples have variables of their own: a member that belongs to another, a
    /// function that is not called and a value without its enumeration are not linked.
    static std::string calls_alone(std::string html);

private:
    struct Thing {
        std::string name, owner;  ///< a class or namespace owns it
    };
    void read_tags(const std::filesystem::path& tags);
    void read_sources(const std::filesystem::path& site);
    std::set<std::string> seen_from(const std::string& file) const;
    bool in_namespace(const std::string& address) const;  ///< is it no member?
    bool means(const std::string& file, const std::set<std::string>& seen, const std::string& address) const;

    // A file is named by its page: "run_8hpp".
    std::map<std::string, Thing> things_;             // by address
    std::map<std::string, std::string> home_;         // the file of an address
    std::multimap<std::string, std::string> called_;  // addresses by name
    std::map<std::string, std::string> code_;         // of a file, without comments
    std::map<std::string, std::set<std::string>> includes_;
};

/// The page, in whose code every word of C++20 has the colour of its kind, and no part of a longer one (keywords.cpp).
std::string with_keywords(std::string html);

}  // namespace page
