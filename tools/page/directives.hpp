#pragma once

#include "context.hpp"
#include "scanner.hpp"

#include <map>
#include <string>
#include <string_view>
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

/// Fills a page's source: the Markdown that Doxygen reads. `file` is the source's name in errors.
/// Throws Error.
std::string fill(Context& context, std::string_view source, const std::string& file);

// Each `…_markdown` returns the Markdown (with HTML where Markdown has no word for it) that takes a directive's place.
// What is wrong with it is a std::out_of_range or std::invalid_argument with one clear sentence; fill.cpp adds file and
// line, and has the table of all directives.

// ---- Numbers, checks, tables (checks_and_tables.cpp) ------------------------------------------------

/// `{{name}}`, `{{name.value}}`, `{{03_euler_variants/name}}`
std::string number_markdown(Context& context, const std::string& reference);
/// The same within a formula.
std::string number_tex(Context& context, const std::string& reference);
/// `{{check name}}`: a check mark that tells what the run confirmed.
std::string check_markdown(Context& context, const Directive& directive);
/// Marks with nothing but blanks between them become one, which tells all that they tell; it stands on the line of the
/// word before it.
std::string with_marks_joined(std::string page);
/// Did the run find a value for the number that `{{where name}}` names? `folder` is the chapter's whose page that is.
bool is_measured(Context& context, const Directive& directive, const std::string& folder);
/// `{{table file.tsv}}`; cells may hold formulas.
std::string table_markdown(Context& context, const Directive& directive);

// ---- Figures, panels, legends (figures.cpp) ---------------------------------------------------------

/// `{{figure file.svg N22 N24: caption}}`
std::string figure_markdown(Context& context, const Directive& directive);
/// `{{live panel: caption}}`, `{{live 03_chapter/panel: caption}}`
std::string live_markdown(Context& context, const Directive& directive);
/// `{{see file.svg}}`, `{{see 03_euler_variants/portraits.svg}}`: "Figure 3.2", as a link.
std::string see_markdown(Context& context, const Directive& directive);
/// `{{line explicit_euler}}`: a piece of the line that figures draw for a method.
std::string legend_line_markdown(Context& context, const Directive& directive);
/// The id of a figure on its page.
std::string figure_anchor(const std::filesystem::path& drawn);
/// The figures of a page's source as they follow each other. `folder` and `page` are the chapter's, or nothing. Those
/// between a {{where name}} that the run has not measured and its {{end}} go to `context.left_out`.
std::vector<Numbered> figures_of(Context& context, std::string_view source, const std::string& file,
                                 const std::string& folder, const std::string& page);
/// The figures of a chapter: those of its page, then those of its second one.
std::vector<Numbered> figures_of(Context& context, const Chapter& chapter);
/// The picture `drawn` as HTML, `folder/file` below the site's figures; on phones the narrow one, where there is one.
std::string picture_html(Context& context, const std::string& folder, const std::filesystem::path& drawn,
                         const std::string& words);

// ---- Code and output (quotes.cpp) -------------------------------------------------------------------

/// `{{code file tag}}`
std::string code_markdown(Context& context, const Directive& directive);
/// `{{program: its first words}}`, a part of the chapter's program; `{{program}}`, the whole of it, folded.
std::string program_markdown(Context& context, const Directive& directive);
/// `{{compile}}`: the command that stands at the program's top, in lines that no column cuts.
std::string compile_markdown(Context& context, const Directive& directive);
/// `{{run}}`, `{{run: Heading}}`
std::string run_markdown(Context& context, const Directive& directive);
/// `{{said file.txt}}`
std::string said_markdown(Context& context, const Directive& directive);
/// `{{ask: question}}`, `{{answered}}` (fill.cpp)
std::string fold_markdown(Context& context, const Directive& directive);
/// Cuts a program into parts, each from the line that begins with its words to where the next one begins. Together
/// they are the program: the first words must stand at its beginning, and all of them in their order. Throws
/// std::out_of_range.
std::vector<Part> parts_of(const std::string& source, const std::vector<std::string>& beginnings);
/// A link to a source file in the site, to be resolved by finish_site once the site is made.
std::string source_link(const std::string& file, int line, const std::string& text);

/// Lines quoted from a source file: what stands between two marker lines, `/// [tag]`.
struct Snippet {
    std::string code;  ///< moved to the left margin, without markers of other snippets
    int first_line;    ///< of the quoted lines in the file
};
/// A tag that does not stand in the file exactly twice, or has nothing between, is a std::out_of_range.
Snippet quote(const std::filesystem::path& root, const std::string& file, const std::string& tag);
/// The tag on a marker line (`/// [tag]`, `//! [tag]`, `// [tag]`, `# [tag]`), else empty.
std::string marker_tag(std::string_view line);

// ---- Claims of the talks (talks.cpp) ----------------------------------------------------------------

/// `{{claims N22 N24}}`, directly below a heading: badges.
std::string claims_markdown(Context& context, const Directive& directive);
/// `{{talks}}`: every row that a chapter claims, with its section, figures and evidence.
std::string talks_markdown(Context& context, const Directive& directive);
/// docs/talks.tsv: id, talk, what the talks show, erratum (or nothing), checks. Throws Error.
std::map<std::string, TalkRow> load_talks(const std::filesystem::path& file);
/// What the option --index leaves for the page of the talks.
std::string index_lines(const std::vector<IndexEntry>& index);

/// Where a Catch2 test stands that is tagged with a claim of the talks.
struct TestPlace {
    std::string row, name, file;
    int line;
};
/// The tests in the text of one source file whose tags name rows, [N22]. A test for several types is one test.
std::vector<TestPlace> tagged_tests(const std::string& text, const std::string& file);

// ---- The course as a whole --------------------------------------------------------------------------

/// `{{which swing pull}}`: answers to "which method?", on a chapter's page as a table, elsewhere as a list.
std::string method_answers_markdown(Context& context, const Directive& directive);
/// `{{chapters}}`: every chapter with its question and picture.
std::string chapters_markdown(Context& context, const Directive& directive);
/// `{{exercises}}`: on a chapter's page its exercises, with links; elsewhere all of them in full.
std::string exercises_markdown(Context& context, const Directive& directive);
int number_of_exercises(Context& context, const Chapter& chapter);
/// What stands above and below a chapter: its heading and facts, the way to its neighbours (from its second page back
/// to it).
std::string chapter_header(Context& context, const std::string& source);
std::string chapter_footer(const Context& context);

}  // namespace page
