// Are the tests that the page of the talks finds in the sources those that Catch2 has?
//
//     timestep_tests --list-tests --reporter xml | same_tests ROOT

#include "tagged_tests.hpp"
#include "text.hpp"

#include <cstdio>
#include <iostream>
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

/// A test and a row that it is tagged with. (Compilers differ in where a macro of several lines
/// stands.)
struct Tagged {
    std::string file, row, name;
};

std::string element(const std::string& xml, const std::string& name) {
    const std::size_t begin = xml.find("<" + name + ">") + name.size() + 2;
    return xml.substr(begin, xml.find("</" + name + ">") - begin);
}

std::string unescaped(std::string text) {
    for (const auto& [entity, sign] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
        text = page::replace_all(text, entity, sign);
    }
    return text;
}

std::vector<Tagged> tests_that_run(const std::string& xml) {
    std::vector<Tagged> tests;
    const std::string mark = "<TestCase>";
    for (std::size_t at = xml.find(mark); at != std::string::npos; at = xml.find(mark, at + 1)) {
        const std::string test = xml.substr(at, xml.find("</TestCase>", at) - at);
        const std::string path = element(test, "File"), tags = element(test, "Tags");
        for (std::size_t open = tags.find('['); open != std::string::npos; open = tags.find('[', open + 1)) {
            const std::string tag = tags.substr(open + 1, tags.find(']', open) - open - 1);
            if (page::is_row(tag)) {
                // The file as seen from the root, however the compiler was told of it.
                tests.push_back({path.substr(path.rfind("tests/")), tag, unescaped(element(test, "Name"))});
            }
        }
    }
    return tests;
}

/// A test for several types, "grows", runs as "grows - float" and "grows - double".
bool is_same(const Tagged& run, const page::TestPlace& named) {
    return run.file == named.file && run.row == named.row &&
           (run.name == named.name || run.name.starts_with(named.name + " - "));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "same_tests: takes ROOT, and a list of tests on its input\n");
        return 2;
    }
    const std::string xml{std::istreambuf_iterator<char>{std::cin}, {}};
    const std::vector<Tagged> run = tests_that_run(xml);
    const std::vector<page::TestPlace> named = page::load_tests(argv[1]);
    int faults = 0;
    for (const Tagged& test : run) {
        if (std::none_of(named.begin(), named.end(), [&](const auto& place) { return is_same(test, place); })) {
            std::printf("%s: [%s] %s runs, and is not found in the source\n", test.file.c_str(), test.row.c_str(),
                        test.name.c_str());
            ++faults;
        }
    }
    for (const page::TestPlace& place : named) {
        if (std::any_of(run.begin(), run.end(), [&](const auto& test) { return is_same(test, place); })) {
            continue;
        }
        // What is beside another library is left out where that is not installed.
        const bool left_out =
            page::read_file(std::filesystem::path{argv[1]} / place.file).find("TIMESTEP_WITH_") != std::string::npos;
        std::printf("%s:%d: [%s] %s stands in the source, and does not run%s\n", place.file.c_str(), place.line,
                    place.row.c_str(), place.name.c_str(), left_out ? ", for want of another library" : "");
        faults += left_out ? 0 : 1;
    }
    std::printf("%zu tags run, %zu stand in the sources\n", run.size(), named.size());
    return faults == 0 && !run.empty() ? 0 : 1;
}
