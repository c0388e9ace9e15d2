#include "fill.hpp"

#include "directives.hpp"
#include "error.hpp"
#include "scanner.hpp"
#include "skeleton.hpp"
#include "text.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

namespace page {
namespace {

using Kind = Piece::Kind;

/// Fills one source, piece by piece.
class Filler {
public:
    Filler(Context& context, const std::string& file) : context_{context}, file_{file} {}

    /// Cuts the chapter's program where the page's pieces ask for it. Each line of it has to be shown.
    void cut_program(const std::vector<Piece>& pieces) {
        program_ = read_file(context_.root() / context_.chapter()->program());
        context_.inputs.insert(context_.root() / context_.chapter()->program());
        std::vector<std::string> beginnings;
        bool whole = false;
        int line = 1;
        for (const Piece& piece : pieces) {
            if (piece.kind != Kind::directive || !piece.text.starts_with("program")) {
                continue;
            }
            const Directive directive = parse_directive(piece.text);
            if (directive.name == "program" && !directive.text.empty()) {
                beginnings.push_back(directive.text);
                line = beginnings.size() == 1 ? piece.line : line;
            }
            whole = whole || (directive.name == "program" && directive.text.empty());
        }
        try {
            if (beginnings.empty() || !whole) {
                throw std::out_of_range{
                    "the page does not show the chapter's program, in parts and then whole "
                    "({{program: its first words}}, {{program}})"};
            }
            parts_ = parts_of(program_, beginnings);
        } catch (const std::out_of_range& wrong) {
            throw Error{file_, line, wrong.what()};
        }
    }

    std::string fill(const std::vector<Piece>& pieces) {
        std::string page;
        const Piece* block = nullptr;  // the {{where …}} that we are in
        bool left_out = false;         // and is not to be seen
        for (const Piece& piece : pieces) {
            try {
                if (const std::string word = block_word(piece); !word.empty()) {
                    if ((word == "where") == (block != nullptr)) {
                        throw std::invalid_argument{block != nullptr ? "{{where …}} within another one"
                                                                     : "{{end}} without a {{where …}}"};
                    }
                    block = block == nullptr ? &piece : nullptr;
                    left_out = block != nullptr && !is_measured(context_, parse_directive(piece.text), "");
                    continue;
                }
                if (left_out) {
                    continue;
                }
                page += fill(piece);
            } catch (const NotYet& missing) {
                if (!context_.draft) {
                    throw Error{file_, piece.line, missing.what()};
                }
                ++context_.gaps;
                page += gap(piece);
            } catch (const std::logic_error& wrong) {  // out_of_range, invalid_argument
                throw Error{file_, piece.line, wrong.what()};
            }
        }
        if (block != nullptr) {
            throw Error{file_, block->line, "{{" + block->text + "}} without its {{end}}"};
        }
        return with_marks_joined(page);
    }

    /// To be asked when all of the page is filled.
    void check_answered(int last_line) const {
        if (asked_) {
            throw Error{file_, last_line, "an {{ask: …}} without its {{answered}}"};
        }
    }

private:
    /// "where" or "end" where the piece is one of those, else nothing.
    static std::string block_word(const Piece& piece) {
        const std::vector<std::string> words =
            piece.kind == Kind::directive ? split_words(piece.text) : std::vector<std::string>{};
        const bool is_one = !words.empty() && (words.front() == "where" || words.front() == "end");
        if (is_one && !piece.own_line) {
            throw std::invalid_argument{"{{" + piece.text + "}} must stand on a line of its own"};
        }
        return is_one ? words.front() : "";
    }

    /// What stands in a draft for what no run has left yet.
    static std::string gap(const Piece& piece) {
        if (piece.kind == Kind::directive && piece.text.starts_with("check ")) {
            return {};  // nothing is confirmed yet
        }
        const bool is_block = piece.kind == Kind::directive && piece.own_line;
        std::string id;  // what refers to a figure leads to its gap
        if (is_block && piece.text.starts_with("figure ")) {
            id = " id=\"" + figure_anchor(parse_directive(piece.text).arguments.at(0)) + "\"";
        }
        return is_block ? "\n<div class=\"gap\"" + id +
                              ">Not there yet: this comes from a run that is still "
                              "to be made.</div>\n"
                        : "<span class=\"gap\">(…)</span>";
    }

    std::string fill(const Piece& piece) {
        switch (piece.kind) {
            case Kind::heading:
                return fill_heading(piece);
            case Kind::formula:
                below_heading_ = false;
                return fill_formula(piece);
            case Kind::display:
                below_heading_ = false;
                return "\\f[" + fill_tex(piece.text) + "\\f]";
            case Kind::directive:
                return fill_directive(piece);
            case Kind::text:
                below_heading_ = below_heading_ && trim(piece.text).empty();
                return piece.text;
            case Kind::code:
                below_heading_ = false;
                return piece.text;
        }
        return {};
    }

    /// A chapter's title comes from about.json, with the header; its second page has one of its
    /// own.
    std::string fill_heading(const Piece& piece) {
        if (piece.text.find_first_of("$") != std::string::npos || piece.text.find("{{") != std::string::npos) {
            throw std::invalid_argument{
                "a heading stands in the tree and in the search as plain text: "
                "no formula and no number in it"};
        }
        heading_ = parse_heading(piece.text);
        below_heading_ = true;
        const bool title = heading_.level == 1 && context_.chapter() != nullptr;
        return !title ? piece.text : context_.is_more() ? piece.text + "\n\n[TOC]\n" : "";
    }

    std::string fill_formula(const Piece& piece) {
        std::string tex = replace_all(fill_tex(piece.text), "\n", " ");
        if (piece.in_table) {  // a bar would end the cell
            tex = replace_all(replace_all(tex, "\\|", "\\Vert "), "|", "\\vert ");
        }
        return "\\f$" + tex + "\\f$";
    }

    /// Numbers within a formula.
    std::string fill_tex(const std::string& tex) {
        std::string filled;
        std::size_t at = 0;
        while (true) {
            const std::size_t open = tex.find("{{", at);
            filled += tex.substr(at, open - at);
            if (open == std::string::npos) {
                return filled;
            }
            const std::size_t close = tex.find("}}", open);
            if (close == std::string::npos) {
                throw std::invalid_argument{"this formula has a {{ without its }}"};
            }
            filled += number_tex(context_, tex.substr(open + 2, close - open - 2));
            at = close + 2;
        }
    }

    std::string fill_directive(const Piece& piece) {
        const Directive directive = parse_directive(piece.text);
        const std::string& name = directive.name;
        const bool below_heading = below_heading_;
        below_heading_ = below_heading_ && name == "claims";
        if (name == "check") {
            return check_markdown(context_, directive);
        }
        if (name == "see") {
            return see_markdown(context_, directive);
        }
        if (name == "line") {
            return line_markdown(context_, directive);
        }
        static const std::set<std::string> blocks{"figure",  "code",     "run",  "table",     "claims",
                                                  "talks",   "chapters", "said", "exercises", "which",
                                                  "program", "compile",  "live", "ask",       "answered"};
        if (blocks.count(name) == 0) {
            if (!directive.arguments.empty() || !directive.text.empty()) {
                throw std::invalid_argument{"there is no {{" + name + " …}}"};
            }
            return number_markdown(context_, name);
        }
        if (!piece.own_line) {
            throw std::invalid_argument{"{{" + name + " …}} must stand on a line of its own"};
        }
        if (name == "ask" || name == "answered") {
            return fold(directive);
        }
        if (name == "figure" || name == "live") {
            const std::size_t before = piece.text.size() - directive.text.size();
            const int lines_before = static_cast<int>(
                std::count(piece.text.begin(), piece.text.begin() + static_cast<std::ptrdiff_t>(before), '\n'));
            const std::vector<Piece> caption = scan(directive.text, file_, piece.line + lines_before);
            return (name == "live" ? live_markdown : figure_markdown)(context_, directive, fill(caption));
        }
        if (name == "code") {
            return code_markdown(context_, directive);
        }
        if (name == "program") {
            return fill_program(directive);
        }
        if (name == "compile") {
            return compile_markdown(program_, directive);
        }
        if (name == "run") {
            return run_markdown(context_, directive);
        }
        if (name == "said") {
            return said_markdown(context_, directive);
        }
        if (name == "exercises") {
            return exercises_markdown(context_);
        }
        if (name == "table") {
            return fill_generated(table_markdown(context_, directive), piece);
        }
        if (name == "which") {
            return fill_generated(which_markdown(context_, directive), piece);
        }
        if (name == "claims") {
            return rows_markdown(context_, directive, below_heading ? heading_ : Heading{});
        }
        return fill_generated(name == "talks" ? talks_markdown(context_) : chapters_markdown(context_), piece);
    }

    /// A question whose answer is folded: `{{ask: question}}`, the answer, `{{answered}}`.
    std::string fold(const Directive& directive) {
        const bool asks = directive.name == "ask";
        if (asks == asked_ || !directive.arguments.empty() || directive.text.empty() == asks) {
            throw std::invalid_argument{
                "{{ask: question}} and {{answered}} come by turns, with the answer between them"};
        }
        asked_ = asks;
        return asks ? "\n\\htmlonly[block]<details class=\"ask\"><summary>" + escape_html(directive.text) +
                          "</summary><div>\\endhtmlonly\n"
                    : "\n\\htmlonly[block]</div></details>\\endhtmlonly\n";
    }

    /// Takes the next part of the program, or the whole of it.
    std::string fill_program(const Directive& directive) {
        if (!directive.arguments.empty() || program_.empty()) {
            throw std::invalid_argument{"{{program: its first words}} or {{program}} stands on a chapter's page"};
        }
        if (directive.text.empty()) {
            return program_markdown(program_);
        }
        const Part& part = parts_.at(parts_shown_);
        ++parts_shown_;
        return part_markdown(context_, part);
    }

    /// Tables and lists hold words from data files, and those may hold formulas.
    std::string fill_generated(const std::string& text, const Piece& directive) {
        try {
            return fill(scan(text, file_, directive.line));
        } catch (const Error& wrong) {
            throw Error{file_, directive.line,
                        "what {{" + directive.text + "}} puts in is wrong (" + wrong.what() + ")"};
        }
    }

    Context& context_;
    const std::string& file_;
    std::string program_{};
    std::vector<Part> parts_{};
    std::size_t parts_shown_ = 0;
    Heading heading_{};
    bool below_heading_ = false;
    bool asked_ = false;
};

/// Says of a draft that it is one, below the page's title.
std::string with_notice(std::string page) {
    const std::size_t title_end = page.find('\n') + 1;
    return page.insert(
        title_end,
        "\n<div class=\"draft\"><b>This page is being made.</b> Where something is still to "
        "come it says so, or shows <span class=\"gap\">(…)</span> for a number. "
        "Load it again while ./course tour is at work; if that was stopped, it goes on from there.</div>\n");
}

}  // namespace

Directive parse_directive(const std::string& inner) {
    const std::size_t colon = inner.find(':');
    Directive directive{};
    std::vector<std::string> words = split_words(std::string_view{inner}.substr(0, colon));
    if (words.empty()) {
        throw std::invalid_argument{"there is nothing between {{ and }}"};
    }
    directive.name = words.front();
    directive.arguments.assign(words.begin() + 1, words.end());
    directive.text = colon == std::string::npos ? "" : std::string{trim(std::string_view{inner}.substr(colon + 1))};
    return directive;
}

std::string fill(Context& context, std::string_view source, const std::string& file) {
    const std::vector<Piece> pieces = scan(source, file);
    context.order =
        context.chapter() == nullptr ? figures_of(source, file, "", "") : figures_of(context, *context.chapter());
    Filler filler{context, file};
    std::string page;
    if (context.chapter() == nullptr) {
        page = filler.fill(pieces);
    } else if (context.is_more()) {
        check_more(pieces, *context.chapter(), file);
        page = filler.fill(pieces) + chapter_footer(context);
    } else {
        check_skeleton(pieces, *context.chapter(), file);
        filler.cut_program(pieces);
        page = filler.fill(pieces);
        page = chapter_header(context, std::string{source}) + page + chapter_footer(context);
    }
    if (context.chapter() != nullptr && context.gaps == 0) {
        check_complete(context);
    }
    filler.check_answered(pieces.empty() ? 1 : pieces.back().line);
    return context.gaps > 0 ? with_notice(page) : page;
}

}  // namespace page
