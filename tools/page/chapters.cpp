// What stands around a chapter, and the list of them all.

#include "directives.hpp"
#include "text.hpp"

#include <algorithm>
#include <cstdio>

namespace page {
namespace {

std::string reference(const Chapter& chapter) {
    return "\\ref " + chapter.id() + " \"" + replace_all(chapter.heading(), "\"", "'") + "\"";
}

std::string seconds(long milliseconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", static_cast<double>(milliseconds) / 1000);
    return text;
}

/// How long it takes to read a page, without what it folds away: so many words a minute, with formulas and figures
/// between them.
std::string minutes_to_read(std::string source) {
    constexpr std::size_t words_a_minute = 150, grain = 5;
    for (std::size_t open; (open = source.find("{{ask:")) != std::string::npos;) {
        const std::size_t end = source.find("{{answered}}", open);
        source.erase(open, end == std::string::npos ? end : end - open + 12);
    }
    const std::size_t minutes = split_words(source).size() / words_a_minute;
    return std::to_string(std::max(grain, (minutes + grain / 2) / grain * grain));
}

/// The chapter's picture, as a link to its page: small, so it is the one for phones, whose letters are larger.
std::string card(Context& context, const Chapter& chapter) {
    std::string name;
    const std::string& file = chapter.picture;
    const std::filesystem::path drawn = context.run_of(chapter.folder + "/", name).existing(file);
    return "<a class=\"card\" aria-hidden=\"true\" tabindex=\"-1\" href=\"" + chapter.id() + ".html\">" +
           replace_all(picture_html(context, chapter.folder, drawn, ""), "screen and (max-width: 560px)", "screen") +
           "</a>";
}

}  // namespace

std::string chapter_header(Context& context, const std::string& source) {
    const Chapter& chapter = *context.chapter();
    std::string name;
    const std::string program = chapter.program();
    const std::string number = std::to_string(chapter.number);
    const int exercises = number_of_exercises(context, chapter);
    std::string facts =
        "Chapter " + number + " of " + std::to_string(context.chapters().size()) + " · " + minutes_to_read(source) +
        " minutes to read" +
        (exercises == 0 ? ""
                        : " · [" + std::to_string(exercises) + (exercises == 1 ? " exercise" : " exercises") +
                              "](@ref " + chapter.section_prefix() + "exercises)") +
        " · <code>./course run " + number +
        "</code>: " + source_link(program, 0, escape_markdown(program.substr(program.rfind('/') + 1)));
    try {
        const RunData& run = context.run_of(chapter.folder + "/", name);
        facts += ", runs in " + seconds(run.milliseconds()) + "\u202fs";
    } catch (const NotYet&) {
        if (!context.draft) throw;
    }
    std::string before;
    for (const Chapter& other : context.chapters()) {
        for (const std::string& needed : chapter.builds_on)
            before += needed == other.folder ? (before.empty() ? "" : ", ") + reference(other) : "";
    }
    if (!before.empty()) facts += " · Builds on: " + before;
    return "# " + chapter.heading() + " {#" + chapter.id() + "}\n\n[TOC]\n\n<div class=\"facts\">" + facts +
           "</div>\n\n";
}

std::string chapter_footer(const Context& context) {
    const Chapter* before = context.is_more() ? context.chapter() : nullptr;
    const Chapter* after = nullptr;
    for (const Chapter& chapter : context.chapters()) {
        if (chapter.number < context.chapter()->number && !context.is_more()) {
            before = &chapter;
        } else if (chapter.number > context.chapter()->number && after == nullptr) {
            after = &chapter;
        }
    }
    const auto link = [](const std::string& to, const char* side) {
        return "<span class=\"" + std::string{side} + "\">" + to + "</span>";
    };
    return "\n\n<div class=\"neighbours\">" + (before == nullptr ? "" : link(reference(*before), "previous")) +
           link(after == nullptr ? "\\ref in_your_engine \"In your engine\"" : reference(*after), "next") + "</div>\n";
}

std::string chapters_markdown(Context& context, const Directive&) {
    std::string list = "\n\\htmlonly[block]<div class=\"chapters\">\\endhtmlonly\n";
    for (const Chapter& chapter : context.chapters()) {
        std::string picture;
        std::string state;
        try {
            picture = card(context, chapter);
        } catch (const NotYet&) {
            if (!context.draft) throw;
            ++context.gaps;
            state = " <span class=\"gap\">being made</span>";
        }
        list += "\n\\htmlonly[block]<div class=\"chapter\">" + picture +
                "<div class=\"about\">\\endhtmlonly\n<b>\\subpage " + chapter.id() + " \"" +
                replace_all(chapter.heading(), "\"", "'") + "\"</b>" + state + "\n\n" + chapter.question +
                "\n\n\\htmlonly[block]</div></div>\\endhtmlonly\n";
    }
    return list + "\n\\htmlonly[block]</div>\\endhtmlonly\n";
}

}  // namespace page
