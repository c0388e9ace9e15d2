// page: fills a page of the course from the run that belongs to it.
//
// A page's source is Markdown for Doxygen. It names the numbers, checks, figures, tables, code and
// output that it shows; this program puts them in, and fails where one of them does not exist.
// README.md beside this file tells what may stand in a source.

#include "directives.hpp"
#include "svg_for_web.hpp"
#include "text.hpp"

#include <iostream>
#include <map>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;
using Options = std::map<std::string, std::string>;

constexpr const char* usage =
    "usage: page --source ROOT --runs DIR --input FILE --output FILE\n"
    "            [--chapter NN_name] [--index FILE] [--figures DIR] [--depfile FILE]\n"
    "            [--indexes DIR] [--draft yes]\n"
    "Fills a page's source from the runs below DIR. --index writes where claims are taught,\n"
    "--figures copies what the page shows, --depfile lists what it quotes; --indexes is what\n"
    "{{talks}} is made of, with the tests below ROOT/tests. A draft has gaps where\n"
    "something comes from a run that is still to be made.\n";

/// What stands behind each option.
Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; i += 2) {
        const std::string option = argv[i];
        if (!option.starts_with("--") || std::string{usage}.find(option + " ") == std::string::npos)
            throw std::invalid_argument{"page: " + option + ": is none of the options"};
        options[option] = i + 1 < argc ? argv[i + 1] : "";
    }
    for (const char* needed : {"--source", "--runs", "--input", "--output"})
        if (options[needed].empty()) throw std::invalid_argument{std::string{"page: "} + needed + ": is missing"};
    return options;
}

/// Copies the figures that the page shows, still ones for light and dark pages, and of every film its first frame. The
/// frames of a film, and a live panel's module, come as scripts: `pageBytes["figures/…"] = "base64"`. (A page that is
/// opened from its file can read scripts alone.)
void copy_figures(const page::Context& context, const fs::path& folder) {
    const auto dark = page::load_dark_colours(context.root() / "tools/figures/dark.tsv");
    for (const auto& [name, drawn] : context.figures) {
        const std::string content = page::read_file(drawn);
        try {
            if (drawn.extension() == ".svg") {
                page::write_file(folder / name, page::svg_for_web(content, dark));
                continue;
            }
            page::write_file(folder / (name + ".js"),
                             "pageBytes[\"figures/" + name + "\"] = \"" + page::base64(content) + "\";\n");
            if (drawn.extension() == ".gif")
                page::write_file((folder / name).replace_extension(".still.gif"), page::first_frame(content));
        } catch (const std::invalid_argument& wrong) {
            throw page::Error{drawn.string(), 1, wrong.what()};
        }
    }
}

/// What make and ninja read to know when the page is out of date.
std::string depfile(const std::string& output, const page::Context& context) {
    std::string rule = page::replace_all(output, " ", "\\ ") + ":";
    for (const fs::path& input : context.inputs) rule += " \\\n  " + page::replace_all(input.string(), " ", "\\ ");
    return rule + "\n";
}

void make_page(Options& options) {
    page::Context context{options["--source"], options["--runs"]};
    context.indexes = options["--indexes"];
    context.draft = options["--draft"] == "yes";
    const fs::path input{options["--input"]};
    if (!options["--chapter"].empty()) context.set_chapter(options["--chapter"], input);
    const std::string shown = fs::proximate(input, options["--source"]).generic_string();
    const std::string content = page::fill(context, page::read_file(input), shown);

    if (!options["--figures"].empty()) {
        copy_figures(context, options["--figures"]);
        context.inputs.insert(context.root() / "tools/figures/dark.tsv");
    }
    if (!options["--index"].empty()) page::write_file(options["--index"], page::index_lines(context.index));
    if (!options["--depfile"].empty()) page::write_file(options["--depfile"], depfile(options["--output"], context));
    for (const auto& [name, text] : context.pages)
        page::write_file(fs::path{options["--output"]}.replace_filename(name), text);
    page::write_file(options["--output"], content);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 1) {
        std::cerr << usage;
        return 2;
    }
    Options options;
    try {
        options = parse(argc, argv);
        make_page(options);
        return 0;
    } catch (const std::exception& wrong) {
        // A page of an earlier build must not pass for this one's.
        for (const char* written : {"--output", "--index"}) {
            std::error_code ignored;
            if (fs::is_regular_file(options[written], ignored)) fs::remove(options[written], ignored);
        }
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
