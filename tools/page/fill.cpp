// Fills a page: each piece of its source becomes what stands on the page.

#include "directives.hpp"
#include "text.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace page {
namespace {

using Kind = Piece::Kind;

/// A directive, and what puts it on the page.
struct Form {
    enum Place {
        in_text,
        own_line,
        captioned,  ///< on its own line; its text is filled first
        generated   ///< on its own line; what it puts in is filled in turn, as cells hold formulas
    };
    Place place;
    std::string (*markdown)(Context&, const Directive&);
};

const std::map<std::string, Form> forms{
    {"check", {Form::in_text, check_markdown}},      {"see", {Form::in_text, see_markdown}},
    {"line", {Form::in_text, legend_line_markdown}}, {"code", {Form::own_line, code_markdown}},
    {"run", {Form::own_line, run_markdown}},         {"said", {Form::own_line, said_markdown}},
    {"claims", {Form::own_line, claims_markdown}},   {"exercises", {Form::own_line, exercises_markdown}},
    {"program", {Form::own_line, program_markdown}}, {"compile", {Form::own_line, compile_markdown}},
    {"figure", {Form::captioned, figure_markdown}},  {"live", {Form::captioned, live_markdown}},
    {"table", {Form::generated, table_markdown}},    {"which", {Form::generated, method_answers_markdown}},
    {"talks", {Form::generated, talks_markdown}},    {"chapters", {Form::generated, chapters_markdown}},
    {"ask", {Form::own_line, fold_markdown}},        {"answered", {Form::own_line, fold_markdown}},
};

/// Fills one source, piece by piece.
class Filler {
public:
    Filler(Context& context, const std::string& file) : context_{context}, file_{file} {}

    std::string fill(const std::vector<Piece>& pieces) {
        std::string page;
        const Piece* block = nullptr;  // the {{where …}} that we are in
        bool left_out = false;         // and that is not to be seen
        for (const Piece& piece : pieces) {
            try {
                if (const std::string word = block_word(piece); !word.empty()) {
                    if ((word == "where") == (block != nullptr))
                        throw std::invalid_argument{block != nullptr ? "{{where …}} within another one"
                                                                     : "{{end}} without a {{where …}}"};
                    block = block == nullptr ? &piece : nullptr;
                    left_out = block != nullptr && !is_measured(context_, parse_directive(piece.text), "");
                } else if (!left_out) {
                    page += fill(piece);
                }
            } catch (const NotYet& missing) {
                if (!context_.draft) throw Error{file_, piece.line, missing.what()};
                ++context_.gaps;
                page += gap(piece);
            } catch (const std::logic_error& wrong) {  // out_of_range, invalid_argument
                throw Error{file_, piece.line, wrong.what()};
            }
        }
        if (block != nullptr) throw Error{file_, block->line, "{{" + block->text + "}} without its {{end}}"};
        return with_marks_joined(page);
    }

private:
    /// "where" or "end" where the piece is one of those, else nothing.
    static std::string block_word(const Piece& piece) {
        const std::vector<std::string> words =
            piece.kind == Kind::directive ? split_words(piece.text) : std::vector<std::string>{};
        const bool is_one = !words.empty() && (words.front() == "where" || words.front() == "end");
        if (is_one && !piece.own_line)
            throw std::invalid_argument{"{{" + piece.text + "}} must stand on a line of its own"};
        return is_one ? words.front() : "";
    }

    /// What stands in a draft for what no run has left yet.
    static std::string gap(const Piece& piece) {
        if (piece.kind == Kind::directive && piece.text.starts_with("check ")) return {};  // nothing is confirmed yet
        if (piece.kind != Kind::directive || !piece.own_line) return "<span class=\"gap\">(…)</span>";
        const std::string id = !piece.text.starts_with("figure ")  // what refers to a figure leads to its gap
                                   ? ""
                                   : " id=\"" + figure_anchor(parse_directive(piece.text).arguments.at(0)) + "\"";
        return "\n<div class=\"gap\"" + id + ">Not there yet: this comes from a run that is still to be made.</div>\n";
    }

    std::string fill(const Piece& piece) {
        const bool is_claims = piece.kind == Kind::directive && piece.text.starts_with("claims");
        if (piece.kind == Kind::heading)
            context_.heading = parse_heading(piece.text);
        else if (!is_claims && (piece.kind != Kind::text || !trim(piece.text).empty()))
            context_.heading = {};
        switch (piece.kind) {
            case Kind::heading:
                return fill_heading(piece);
            case Kind::formula:
                return fill_formula(piece);
            case Kind::display:
                return "\\f[" + fill_tex(piece.text) + "\\f]";
            case Kind::directive:
                return fill_directive(piece);
            default:
                return piece.text;
        }
    }

    /// A chapter's title comes from about.json, with the header; its second page has one of its own.
    std::string fill_heading(const Piece& piece) {
        if (piece.text.find('$') != std::string::npos || piece.text.find("{{") != std::string::npos)
            throw std::invalid_argument{
                "a heading stands in the tree and in the search as plain text: no formula and no number in it"};
        const bool title = context_.heading.level == 1 && context_.chapter() != nullptr;
        return !title ? piece.text : context_.is_more() ? piece.text + "\n\n[TOC]\n" : "";
    }

    std::string fill_formula(const Piece& piece) {
        std::string tex = replace_all(fill_tex(piece.text), "\n", " ");
        if (piece.in_table)  // a bar would end the cell
            tex = replace_all(replace_all(tex, "\\|", "\\Vert "), "|", "\\vert ");
        return "\\f$" + tex + "\\f$";
    }

    /// Numbers within a formula.
    std::string fill_tex(std::string tex) {
        for (std::size_t open; (open = tex.find("{{")) != std::string::npos;) {
            const std::size_t close = tex.find("}}", open);
            if (close == std::string::npos) throw std::invalid_argument{"this formula has a {{ without its }}"};
            tex.replace(open, close + 2 - open, number_tex(context_, tex.substr(open + 2, close - open - 2)));
        }
        return tex;
    }

    std::string fill_directive(const Piece& piece) {
        Directive directive = parse_directive(piece.text);
        const auto form = forms.find(directive.name);
        if (form == forms.end()) {
            if (!directive.arguments.empty() || !directive.text.empty())
                throw std::invalid_argument{"there is no {{" + directive.name + " …}}"};
            return number_markdown(context_, directive.name);
        }
        const auto& [place, markdown] = form->second;
        if (place != Form::in_text && !piece.own_line)
            throw std::invalid_argument{"{{" + directive.name + " …}} must stand on a line of its own"};
        if (place == Form::captioned) {
            const auto text = piece.text.end() - static_cast<std::ptrdiff_t>(directive.text.size());
            const auto lines_before = std::count(piece.text.begin(), text, '\n');
            directive.text = fill(scan(directive.text, file_, piece.line + static_cast<int>(lines_before)));
        }
        const std::string text = markdown(context_, directive);
        if (place != Form::generated) return text;
        try {
            return fill(scan(text, file_, piece.line));
        } catch (const Error& wrong) {
            throw Error{file_, piece.line, "what {{" + piece.text + "}} puts in is wrong (" + wrong.what() + ")"};
        }
    }

    Context& context_;
    const std::string& file_;
};

/// Cuts the chapter's program where the page's pieces ask for it. Each line of it has to be shown.
void cut_program(Context& context, const std::vector<Piece>& pieces, const std::string& file) {
    const std::filesystem::path program = context.root() / context.chapter()->program();
    context.program = read_file(program);
    context.inputs.insert(program);
    std::vector<std::string> beginnings;
    bool whole = false;
    int line = 1;
    for (const Piece& piece : pieces) {
        if (piece.kind != Kind::directive || !piece.text.starts_with("program")) continue;
        const Directive directive = parse_directive(piece.text);
        if (directive.name != "program") continue;
        if (beginnings.empty()) line = piece.line;
        if (directive.text.empty())
            whole = true;
        else
            beginnings.push_back(directive.text);
    }
    try {
        if (beginnings.empty() || !whole)
            throw std::out_of_range{
                "the page does not show the chapter's program, in parts and then whole "
                "({{program: its first words}}, {{program}})"};
        context.parts = parts_of(context.program, beginnings);
    } catch (const std::out_of_range& wrong) {
        throw Error{file, line, wrong.what()};
    }
}

/// The rows that a chapter's second page teaches.
std::set<std::string> rows_of_more(const Context& context) {
    const Chapter& chapter = *context.chapter();
    std::set<std::string> rows;
    if (chapter.has_more) {
        const std::string file = chapter.source(true);
        for (const Piece& piece : scan(read_file(context.root() / file), file)) {
            if (piece.kind == Piece::Kind::directive && piece.text.starts_with("claims ")) {
                const Directive directive = parse_directive(piece.text);
                rows.insert(directive.arguments.begin(), directive.arguments.end());
            }
        }
    }
    return rows;
}

/// A chapter's page has the title of its about.json, its second page one of its own; their sections have ids that tell
/// whose they are. Throws Error.
void check_headings(const std::vector<Piece>& pieces, const Chapter& chapter, bool more, const std::string& file) {
    bool is_titled = false;
    for (const Piece& piece : pieces) {
        if (piece.kind != Kind::heading) continue;
        const Heading heading = parse_heading(piece.text);
        const std::string prefix = chapter.section_prefix(more);
        if (!more && heading.level == 1 && heading.title != chapter.title)
            throw Error{file, piece.line, "the page's title must be that of about.json: " + chapter.title};
        if (more && is_titled == (heading.level == 1))
            throw Error{file, piece.line, "the first heading, and no other, must be a title, # with one sign"};
        if (more && !is_titled && heading.id != chapter.id(true))
            throw Error{file, piece.line, "the title must have the id {#" + chapter.id(true) + "}"};
        if ((heading.level == 2 || (more && is_titled)) && !heading.id.starts_with(prefix))
            throw Error{file, piece.line, "a section must have an id that begins {#" + prefix};
        is_titled = true;
    }
    if (more && !is_titled) throw Error{file, 1, "the page has no title, with the id {#" + chapter.id(true) + "}"};
}

/// A chapter shows all its figures and teaches all its rows, on this page or the other of its two. Throws Error where
/// this one should have. To be asked when all of the page is filled.
void check_complete(const Context& context) {
    const Chapter& chapter = *context.chapter();
    for (const std::string& figure : chapter.figures) {
        const std::string name = chapter.folder + "/" + figure;
        const auto found = std::find_if(context.order.begin(), context.order.end(),
                                        [&](const Numbered& each) { return each.figure == name; });
        const bool belongs_here = found == context.order.end() ? !context.is_more() : found->page == context.page();
        if (belongs_here && context.figures.count(name) == 0 && context.left_out.count(name) == 0)
            throw Error{chapter.about(), 1, "the page does not show " + figure};
    }
    if (context.is_more()) return;
    const std::set<std::string> beside = rows_of_more(context);
    for (const std::string& row : chapter.claims) {
        const auto teaches = [&](const IndexEntry& entry) { return entry.row == row && entry.kind == "section"; };
        if (beside.count(row) == 0 && std::none_of(context.index.begin(), context.index.end(), teaches)) {
            throw Error{chapter.about(), 1,
                        row + " is claimed, but no section of the page teaches it ({{claims " + row + "}})"};
        }
    }
}

/// A draft says that it is one, below the page's title.
std::string with_notice(std::string page) {
    return page.insert(
        page.find('\n') + 1,
        "\n<div class=\"draft\"><b>This page is being made.</b> Where something is still to "
        "come it says so, or shows <span class=\"gap\">(…)</span> for a number. "
        "Load it again while ./course tour is at work; if that was stopped, it goes on from there.</div>\n");
}

}  // namespace

Directive parse_directive(const std::string& inner) {
    const std::size_t colon = inner.find(':');
    std::vector<std::string> words = split_words(std::string_view{inner}.substr(0, colon));
    if (words.empty()) throw std::invalid_argument{"there is nothing between {{ and }}"};
    return {words.front(),
            {words.begin() + 1, words.end()},
            colon == std::string::npos ? "" : std::string{trim(std::string_view{inner}.substr(colon + 1))}};
}

std::string fold_markdown(Context& context, const Directive& directive) {
    const bool asks = directive.name == "ask";
    if (asks == context.asked || !directive.arguments.empty() || directive.text.empty() == asks)
        throw std::invalid_argument{"{{ask: question}} and {{answered}} come by turns, with the answer between them"};
    context.asked = asks;
    return asks ? "\n\\htmlonly[block]<details class=\"ask\"><summary>" + escape_html(directive.text) +
                      "</summary><div>\\endhtmlonly\n"
                : "\n\\htmlonly[block]</div></details>\\endhtmlonly\n";
}

std::string fill(Context& context, std::string_view source, const std::string& file) {
    const std::vector<Piece> pieces = scan(source, file);
    const Chapter* chapter = context.chapter();
    context.order = chapter == nullptr ? figures_of(context, source, file, "", "") : figures_of(context, *chapter);
    Filler filler{context, file};
    std::string page;
    if (chapter == nullptr) {
        page = filler.fill(pieces);
    } else {
        const bool more = context.is_more();
        check_headings(pieces, *chapter, more, file);
        if (!more) cut_program(context, pieces, file);
        page = filler.fill(pieces);
        page = (more ? "" : chapter_header(context, std::string{source})) + page + chapter_footer(context);
    }
    if (chapter != nullptr && context.gaps == 0) check_complete(context);
    if (context.asked)
        throw Error{file, pieces.empty() ? 1 : pieces.back().line, "an {{ask: …}} without its {{answered}}"};
    return context.gaps > 0 ? with_notice(page) : page;
}

}  // namespace page
