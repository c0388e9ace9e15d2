#pragma once

#include "context.hpp"
#include "program.hpp"
#include "scanner.hpp"

#include <string>
#include <vector>

namespace page {

/// `{{code include/timestep/run.hpp loop}}`: a word that says what it is, its arguments, and (after
/// a colon) a text.
struct Directive {
    std::string name;
    std::vector<std::string> arguments;
    std::string text;
};
Directive parse_directive(const std::string& inner);

// Each of these returns the Markdown (with HTML where Markdown has no word for it) that takes the
// directive's place. What is wrong with it is a std::out_of_range or std::invalid_argument with one
// clear sentence; fill.cpp adds file and line.

/// `{{name}}`, `{{name.value}}`, `{{03_euler_variants/name}}`
std::string number_markdown(Context& context, const std::string& reference);
/// The same within a formula.
std::string number_tex(Context& context, const std::string& reference);
/// `{{check name}}`: a check mark that tells what the run confirmed.
std::string check_markdown(Context& context, const Directive& directive);
/// Marks with nothing but blanks between them become one, which tells all that they tell; it stands on the line of the
/// word before it.
std::string with_marks_joined(std::string page);
/// `{{line explicit_euler}}`: a piece of the line that figures draw for a method.
std::string line_markdown(Context& context, const Directive& directive);
/// `{{figure file.svg N22 N24: caption}}`; `caption` is the filled caption.
std::string figure_markdown(Context& context, const Directive& directive, const std::string& caption);
/// `{{see file.svg}}`, `{{see 03_euler_variants/portraits.svg}}`: "Figure 3.2", as a link.
std::string see_markdown(Context& context, const Directive& directive);
/// The id of a figure on its page.
std::string figure_anchor(const std::filesystem::path& drawn);
/// The figures of a page's source as they follow each other. `folder` and `page` are the chapter's,
/// or nothing.
std::vector<Numbered> figures_of(std::string_view source, const std::string& file, const std::string& folder,
                                 const std::string& page);
/// The figures of a chapter: those of its page, then those of its second one. Not those between a {{where name}} that
/// the chapter's run has not measured and its {{end}}; these go to `context.left_out` where the page is the chapter's.
std::vector<Numbered> figures_of(Context& context, const Chapter& chapter);
/// Did the run find a value for the number that `{{where name}}` names? `folder` is the chapter's whose page that is.
bool is_measured(Context& context, const Directive& directive, const std::string& folder);
/// The picture `drawn` as HTML, `folder/file` below the site's figures; on phones the narrow one, where there is one.
std::string picture_html(Context& context, const std::string& folder, const std::filesystem::path& drawn,
                         const std::string& words);
/// `{{live panel: caption}}`, `{{live 03_chapter/panel: caption}}`; `caption` is the filled caption.
std::string live_markdown(Context& context, const Directive& directive, const std::string& caption);
/// The caption's first sentence without marks, for those who cannot see the picture.
std::string first_sentence(const std::string& caption);
/// `{{code file tag}}`
std::string code_markdown(Context& context, const Directive& directive);
/// `{{run}}`, `{{run: Heading}}`
std::string run_markdown(Context& context, const Directive& directive);
/// `{{said file.txt}}`
std::string said_markdown(Context& context, const Directive& directive);
/// `{{table file.tsv}}`; cells are filled by the caller, for they may hold formulas.
std::string table_markdown(Context& context, const Directive& directive);
/// `{{claims N22 N24}}` below `heading`
std::string rows_markdown(Context& context, const Directive& directive, const Heading& heading);
/// `{{program: its first words}}`: the part of the chapter's program that begins with these words.
std::string part_markdown(const Context& context, const Part& part);
/// `{{program}}`: the whole of it, folded.
std::string program_markdown(const std::string& source);

/// `{{compile}}`: the command that stands at the program's top, in lines that no column cuts.
std::string compile_markdown(const std::string& source, const Directive& directive);
/// `{{which swing pull}}`: answers to "which method?", on a chapter's page as a table, elsewhere as a list.
std::string which_markdown(const Context& context, const Directive& directive);
/// `{{chapters}}`: every chapter with its question and picture.
std::string chapters_markdown(Context& context);
/// `{{exercises}}`: on a chapter's page its exercises, with links; elsewhere all of them in full.
std::string exercises_markdown(Context& context);
/// `{{talks}}`: every row that a chapter claims, with its section, figures and tests.
std::string talks_markdown(Context& context);

/// What stands above and below a chapter: its heading and facts, the way to its neighbours (from
/// its second page back to it).
std::string chapter_header(Context& context, const std::string& source);
std::string chapter_footer(const Context& context);

/// A link to a source file in the site, to be resolved by link_sources once the site is made.
std::string source_link(const std::string& file, int line, const std::string& text);

}  // namespace page
