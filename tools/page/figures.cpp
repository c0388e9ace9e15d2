// Figures: what a run has drawn, with a caption; live panels; and pieces of their lines between words.

#include "directives.hpp"
#include "svg_for_web.hpp"
#include "text.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace page {

/// The caption's first sentence without marks, for those who cannot see the picture.
static std::string first_sentence(const std::string& caption) {
    std::string plain;
    bool in_tag = false;
    for (const char c : replace_all(caption, "\\f$", "")) {
        in_tag = in_tag || c == '<';
        if (!in_tag && std::string_view{"\\{}*`_"}.find(c) == std::string_view::npos) plain += c == '\n' ? ' ' : c;
        in_tag = in_tag && c != '>';
    }
    const std::size_t end = plain.find(". ");
    return std::string{trim(end == std::string::npos ? plain : plain.substr(0, end + 1))};
}

/// The picture that stands in the page: of a film its first frame, until the script film.js plays it.
static std::string shown_file(const std::filesystem::path& drawn) {
    return drawn.extension() == ".gif" ? drawn.stem().string() + ".still.gif" : drawn.filename().string();
}

std::string picture_html(Context& context, const std::string& folder, const std::filesystem::path& drawn,
                         const std::string& words) {
    const auto size_of = [](const std::filesystem::path& file) {
        const ImageSize size = image_size(file);
        return " width=\"" + std::to_string(size.width) + "\" height=\"" + std::to_string(size.height) + "\"";
    };
    const std::string file = drawn.filename().string(), source = "figures/" + folder + "/" + shown_file(drawn);
    context.figures.emplace(folder + "/" + file, drawn);
    const std::string image =
        "<img src=\"" + source + "\" alt=\"" + words + "\"" + size_of(drawn) + " loading=\"lazy\">";
    const std::filesystem::path narrow = drawn.parent_path() / "narrow" / file;
    if (drawn.extension() == ".gif" || !std::filesystem::exists(narrow.parent_path())) return image;
    context.figures.emplace(folder + "/narrow/" + file, narrow);
    return "<picture><source srcset=\"figures/" + folder + "/narrow/" + file +
           "\" media=\"screen and (max-width: 560px)\"" + size_of(narrow) + ">" + image + "</picture>";
}

namespace {

/// A film may say in its file's name that it is one; its id and its title say so anyway.
std::string figure_name(const std::filesystem::path& drawn, bool moves) {
    const std::string stem = drawn.stem().string();
    const bool says_so = moves && stem.size() > 5 && stem.ends_with("_film");
    return says_so ? stem.substr(0, stem.size() - 5) : stem;
}

using Order = std::vector<Numbered>;

/// "Figure 3.2" in a chapter, "Figure 2" elsewhere.
std::string label(const Chapter* chapter, const Order& order, Order::const_iterator found) {
    const std::string number = std::to_string(found - order.begin() + 1);
    return "Figure\u00a0" + (chapter == nullptr ? number : std::to_string(chapter->number) + "." + number);
}

Order::const_iterator find(const Order& order, const std::string& figure) {
    return std::find_if(order.begin(), order.end(), [&](const Numbered& each) { return each.figure == figure; });
}

}  // namespace

std::string figure_anchor(const std::filesystem::path& drawn) {
    const bool moves = drawn.extension() == ".gif";
    return "fig-" + figure_name(drawn, moves) + (moves ? "-film" : "");
}

std::vector<Numbered> figures_of(Context& context, std::string_view source, const std::string& file,
                                 const std::string& folder, const std::string& page) {
    Order order;
    bool is_seen = true;
    for (const Piece& piece : scan(source, file)) {
        if (piece.kind != Piece::Kind::directive) continue;
        const std::vector<std::string> words = split_words(piece.text.substr(0, piece.text.find(':')));
        const std::string kind = words.empty() ? "" : words[0];
        if (kind == "where" || kind == "end") is_seen = true;
        if (kind == "where") {
            try {
                is_seen = is_measured(context, parse_directive(piece.text), folder);
            } catch (const std::logic_error&) {  // no such run or number yet: the page itself says so
            }
        } else if (kind == "figure" && words.size() > 1) {
            const std::string name = words[1].find('/') == std::string::npos ? folder + "/" + words[1] : words[1];
            is_seen ? order.push_back({name, page}) : void(context.left_out.insert(name));
        }
    }
    return order;
}

std::vector<Numbered> figures_of(Context& context, const Chapter& chapter) {
    Order order;
    for (const bool more : {false, true}) {
        if (more && !chapter.has_more) continue;
        const std::string file = chapter.source(more);
        context.inputs.insert(context.root() / file);
        const Order of_page =
            figures_of(context, read_file(context.root() / file), file, chapter.folder, chapter.id(more));
        order.insert(order.end(), of_page.begin(), of_page.end());
    }
    return order;
}

std::string see_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1 || !directive.text.empty())
        throw std::invalid_argument{"to refer to a figure is {{see file.svg}} or {{see 03_chapter/file.svg}}"};
    std::string file;
    const std::string& reference = directive.arguments.front();
    context.run_of(reference, file);
    const std::string& folder = context.folder_of(reference);
    const auto link = [&](const Chapter* chapter, const Order& order) {
        const auto found = find(order, folder + "/" + file);
        return found == order.end() ? std::string{}
                                    : "<a href=\"" + (found->page == context.page() ? "" : found->page + ".html") +
                                          "#" + figure_anchor(file) + "\">" + label(chapter, order, found) + "</a>";
    };
    std::string html = link(context.chapter(), context.order);
    for (const Chapter& chapter : context.chapters()) {
        if (html.empty() && chapter.folder == folder) {  // another chapter's
            html = link(&chapter, figures_of(context, chapter));
        }
    }
    if (html.empty()) throw std::out_of_range{reference + " is no figure of this page nor of its chapter's"};
    return html;
}

std::string figure_markdown(Context& context, const Directive& directive) {
    const std::string& caption = directive.text;
    if (directive.arguments.empty() || trim(caption).empty())
        throw std::invalid_argument{"a figure is {{figure file.svg N22: caption}}"};
    const std::string& reference = directive.arguments.front();
    std::string file;
    RunData& run = context.run_of(reference, file);
    const std::string& folder = context.folder_of(reference);
    for (const Chapter& chapter : context.chapters()) {
        if (chapter.folder == folder && std::count(chapter.figures.begin(), chapter.figures.end(), file) == 0)
            throw std::out_of_range{file + " is not among the figures in " + chapter.about()};
    }
    for (const Numbered& each : context.order) {
        if (each.figure == folder + "/" + file && each.page != context.page()) {
            throw std::out_of_range{file + " stands on the page " + each.page +
                                    ", too: a figure stands on one of a chapter's two"};
        }
    }
    const std::filesystem::path drawn = run.existing(file);
    if (context.figures.count(folder + "/" + file) != 0) throw std::out_of_range{file + " is shown twice on this page"};

    const bool moves = drawn.extension() == ".gif";
    const std::string name = figure_name(drawn, moves), anchor = figure_anchor(drawn);
    if (!context.anchors.insert(anchor).second)
        throw std::out_of_range{file + ": another figure on this page has the id " + anchor};
    for (std::size_t i = 1; i < directive.arguments.size(); ++i) {
        const std::string& row = directive.arguments[i];
        const Chapter* chapter = context.chapter();
        if (chapter == nullptr || std::count(chapter->claims.begin(), chapter->claims.end(), row) == 0)
            throw std::out_of_range{"\"" + row + "\" is none of this chapter's claims"};
        context.index.push_back(
            {row, "figure", context.page() + ".html", anchor, replace_all(name, "_", " ") + (moves ? ", film" : "")});
    }

    const std::string picture = picture_html(context, folder, drawn, escape_html(first_sentence(caption)));
    return "\n\\htmlonly[block]<figure id=\"" + anchor + "\" class=\"" + (moves ? "picture animation" : "picture") +
           "\" style=\"--width:" + std::to_string(image_size(drawn).width) + "px\"><a class=\"card\" href=\"figures/" +
           folder + "/" + shown_file(drawn) + "\">" + picture +
           "</a><figcaption>\\endhtmlonly\n<span class=\"figure-number\">" +
           label(context.chapter(), context.order, find(context.order, folder + "/" + file)) + ".</span> " +
           std::string{trim(caption)} + "\n\\htmlonly[block]</figcaption></figure>\\endhtmlonly\n";
}

std::string live_markdown(Context& context, const Directive& directive) {
    const std::string& caption = directive.text;
    if (directive.arguments.size() != 1 || trim(caption).empty())
        throw std::invalid_argument{"a live panel is {{live panel: caption}} or {{live 03_chapter/panel: caption}}"};
    const std::string& reference = directive.arguments.front();
    const std::size_t slash = reference.find('/');
    if (slash == std::string::npos && context.chapter() == nullptr) {
        throw std::invalid_argument{"{{live " + reference +
                                    "}}: outside of a chapter a panel is named 03_chapter/panel"};
    }
    const std::string folder = slash == std::string::npos ? context.chapter()->folder : reference.substr(0, slash);
    const std::string name = reference.substr(slash + 1);  // npos + 1 is 0
    const std::string source = "chapters/" + folder + "/live/" + name + ".cpp";
    if (!std::filesystem::exists(context.root() / source)) throw std::out_of_range{source + ": there is no such panel"};
    const std::string anchor = "live-" + name;
    if (!context.anchors.insert(anchor).second) throw std::out_of_range{name + " is shown twice on this page"};
    const std::filesystem::path made = context.runs() / folder / "live";
    const std::filesystem::path still = made / (name + ".svg"), module = made / (name + ".wasm");
    if (!std::filesystem::exists(still) && context.draft) {
        ++context.gaps;
        return "\n<div class=\"gap\">(a live panel is to come here)</div>\n";
    }
    const std::string shown = folder + "/live_" + name;
    context.figures.emplace(shown + ".svg", still);
    context.inputs.insert(still);
    std::string attributes;
    if (std::filesystem::exists(module)) {  // else there is no compiler for it here, and the picture stands still
        context.figures.emplace(shown + ".wasm", module);
        context.inputs.insert(module);
        attributes = " data-live=\"" + folder + "/" + name + "\" data-module=\"figures/" + shown + ".wasm\"";
    }
    const ImageSize size = image_size(still);
    return "\n\\htmlonly[block]<figure id=\"" + anchor + "\" class=\"picture live\"" + attributes +
           " style=\"--width:" + std::to_string(size.width) + "px\"><a class=\"card\" href=\"figures/" + shown +
           ".svg\"><img src=\"figures/" + shown + ".svg\" alt=\"" + escape_html(first_sentence(caption)) +
           "\" width=\"" + std::to_string(size.width) + "\" height=\"" + std::to_string(size.height) +
           "\" loading=\"lazy\"></a><figcaption>\\endhtmlonly\n" + std::string{trim(caption)} + " (" +
           source_link(source, 1, "Its C++") + ".)" + "\n\\htmlonly[block]</figcaption></figure>\\endhtmlonly\n";
}

std::string legend_line_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1)
        throw std::invalid_argument{"{{line passive_gyroscopic}} takes one name out of tools/figures/style.gp"};
    const std::string& name = directive.arguments[0];
    const std::filesystem::path style = context.root() / "tools/figures/style.gp";
    context.inputs.insert(style);
    for (const std::string& line : split_lines(read_file(style))) {  // name = "lc rgb '#123456' lw 2 dt 1"
        const std::vector<std::string> words = split_words(line);
        if (words.size() < 9 || words[0] != name || words[1] != "=" || words[2] != "\"lc" || words[7] != "dt") continue;
        const char* dashes = words[8] == "1\"" ? "solid" : "dashed";
        return "<span class=\"line\" style=\"border-top: 3px " + std::string{dashes} + " " + words[4].substr(1, 7) +
               "\"></span>";
    }
    throw std::out_of_range{"tools/figures/style.gp draws no line \"" + name + "\""};
}

}  // namespace page
