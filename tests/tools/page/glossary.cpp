// The glossary: in order, nothing twice, and each word where its link leads.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "text.hpp"

namespace {

// Small letters; a dash, an underscore or the end of a line is a blank.
std::string plain(std::string text) {
    for (const char* dash : {"–", "-", "_", "\n"}) text = page::replace_all(text, dash, " ");
    text = page::replace_all(text, "ö", "o");
    text = std::regex_replace(text, std::regex{" +"}, " ");
    for (char& letter : text)
        if (letter >= 'A' && letter <= 'Z') letter = char(letter - 'A' + 'a');
    return text;
}

struct Entry {
    std::string term;
    std::vector<std::string> words;  // the term without brackets and the plainer word
    std::string section;             // where it comes in, or
    std::string other;               // the entry to see instead
};

// - **term** (*plainer*): what it is. [Chapter 3](@ref ch3_order) or [More on chapter 3](@ref
// more3_…), or - **term**: see *other*.
std::vector<Entry> entries_of(const std::string& glossary) {
    static const std::regex item{R"(^- \*\*([^*]+)\*\*( \(\*([^*]+)\*\))?[:,] (.*)$)"},
        link{R"(\(@ref ((?:ch|more)\d_\w+)\)$)"}, see{R"(^see \*([^*]+)\*\.$)"}, bracket{R"( \(.*\))"};
    std::vector<Entry> entries;
    std::smatch found, end;
    for (const std::string& line : page::split_lines(glossary)) {
        if (!line.starts_with("- ")) continue;
        INFO(line);
        REQUIRE(std::regex_match(line, found, item));
        Entry entry{found[1], {std::regex_replace(found[1].str(), bracket, "")}, "", ""};
        if (found[3].matched) entry.words.push_back(found[3]);
        const std::string rest = found[4];
        if (std::regex_search(rest, end, link))
            entry.section = end[1];
        else if (std::regex_match(rest, end, see))
            entry.other = end[1];
        entries.push_back(entry);
    }
    return entries;
}

std::vector<Entry> entries() { return entries_of(page::read_file(std::string{SOURCE} + "/docs/glossary.md")); }

// The chapters' pages that are made from files of these names.
std::vector<std::string> chapters(std::initializer_list<const char*> files = {"chapter.md", "more.md"}) {
    std::vector<std::string> pages;
    for (const auto& folder : std::filesystem::directory_iterator{std::string{SOURCE} + "/chapters"})
        for (const char* file : files)
            if (std::filesystem::exists(folder.path() / file)) pages.push_back(page::read_file(folder.path() / file));
    return pages;
}

// The text below each heading, by its id.
std::map<std::string, std::string> sections() {
    std::map<std::string, std::string> texts;
    static const std::regex heading{R"(^##+ .*\{#(\w+)\}$)"};
    std::smatch id;
    for (const std::string& page : chapters()) {
        std::string name;
        for (const std::string& line : page::split_lines(page)) {
            if (std::regex_match(line, id, heading)) name = id[1];
            texts[name] += line + "\n";
        }
    }
    return texts;
}

}  // namespace

TEST_CASE("the glossary is in alphabetical order, and has nothing twice") {
    const std::vector<Entry> all = entries();
    REQUIRE(all.size() > 100);
    for (std::size_t i = 1; i < all.size(); ++i) {
        INFO(all[i - 1].term << " before " << all[i].term);
        CHECK(plain(all[i - 1].term) < plain(all[i].term));
    }
}

TEST_CASE("a word of the glossary stands in the section to which its link leads") {
    const std::map<std::string, std::string> texts = sections();
    const std::vector<Entry> all = entries();
    for (const Entry& entry : all) {
        INFO(entry.term);
        if (!entry.other.empty()) {
            CHECK(std::any_of(all.begin(), all.end(),
                              [&](const Entry& to) { return to.term == entry.other && to.other.empty(); }));
            continue;
        }
        REQUIRE(texts.count(entry.section) == 1);
        const std::string text = plain(texts.at(entry.section));
        CHECK(std::any_of(entry.words.begin(), entry.words.end(),
                          [&](const std::string& word) { return text.find(plain(word)) != std::string::npos; }));
    }
}

// Bold is for the words of the field. What begins with a capital letter may be the head of a paragraph.
TEST_CASE("what a chapter prints bold, three words at most with a small first letter, is in the glossary") {
    static const std::regex bold{R"(\*\*([a-z][^*.,;:]*)\*\*)"};
    std::set<std::string> known;
    for (const Entry& entry : entries())
        for (const std::string& word : entry.words) known.insert(plain(word));
    for (const std::string& page : chapters()) {
        for (std::sregex_iterator each{page.begin(), page.end(), bold}, end; each != end; ++each) {
            const std::string word = plain((*each)[1]);
            if (page::split_words(word).size() > 3) continue;
            INFO(word);
            CHECK(known.count(word) == 1);
        }
    }
}
