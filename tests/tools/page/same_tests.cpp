// Are the tests that the page of the talks finds in the sources those that Catch2 has?
//
//     timestep_tests --list-tests --reporter xml | same_tests ROOT

#include "tagged_tests.hpp"
#include "text.hpp"

#include <cstdio>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

namespace {

/// "file:line row" for each row that a test is tagged with.
using Places = std::set<std::string>;

std::string element(const std::string& xml, const std::string& name) {
    const std::size_t begin = xml.find("<" + name + ">") + name.size() + 2;
    return xml.substr(begin, xml.find("</" + name + ">") - begin);
}

Places places_in(const std::string& xml, const std::filesystem::path& root) {
    Places places;
    const std::string mark = "<TestCase>";
    for (std::size_t at = xml.find(mark); at != std::string::npos; at = xml.find(mark, at + 1)) {
        const std::string test = xml.substr(at, xml.find("</TestCase>", at) - at);
        const std::string file =
            std::filesystem::proximate(element(test, "File"), root).generic_string();
        const std::string tags = element(test, "Tags");
        for (std::size_t open = tags.find('['); open != std::string::npos;
             open = tags.find('[', open + 1)) {
            const std::string tag = tags.substr(open + 1, tags.find(']', open) - open - 1);
            if (page::is_row(tag)) {
                places.insert(file + ":" + element(test, "Line") + " " + tag);
            }
        }
    }
    return places;
}

int missing(const Places& places, const Places& others, const char* words) {
    int count = 0;
    for (const std::string& place : places) {
        if (others.count(place) == 0) {
            std::printf("%s: %s\n", place.c_str(), words);
            ++count;
        }
    }
    return count;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "same_tests: takes ROOT, and a list of tests on its input\n");
        return 2;
    }
    const std::string xml{std::istreambuf_iterator<char>{std::cin}, {}};
    const Places run = places_in(xml, argv[1]);
    Places named;
    for (const page::TestPlace& test : page::load_tests(argv[1])) {
        named.insert(test.file + ":" + std::to_string(test.line) + " " + test.row);
    }
    std::printf("%zu tags run, %zu named\n", run.size(), named.size());
    const int faults = missing(run, named, "runs, and is not found in the source") +
                       missing(named, run, "stands in the source, and does not run");
    return faults == 0 && !run.empty() ? 0 : 1;
}
