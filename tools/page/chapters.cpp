// What stands around a chapter, and the list of them all.

#include "directives.hpp"
#include "image.hpp"
#include "text.hpp"

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

/// The chapter's picture, as a link to its page.
std::string card(Context& context, const Chapter& chapter) {
    std::string name;
    const std::string& file = chapter.picture;
    const std::filesystem::path drawn = context.run_of(chapter.folder + "/", name).figure(file);
    context.figures.emplace(chapter.folder + "/" + file, drawn);
    const ImageSize size = image_size(drawn);
    return "<a class=\"card\" href=\"" + chapter.id() + ".html\"><img src=\"figures/" +
           chapter.folder + "/" + file + "\" alt=\"\" width=\"" + std::to_string(size.width) +
           "\" height=\"" + std::to_string(size.height) + "\" loading=\"lazy\"></a>";
}

}  // namespace

std::string chapter_header(Context& context) {
    const Chapter& chapter = *context.chapter();
    std::string name;
    const std::string program = chapter.program();
    std::string facts =
        "Program: " +
        source_link(program, 0, escape_markdown(program.substr(program.rfind('/') + 1)));
    try {
        const RunData& run = context.run_of(chapter.folder + "/", name);
        facts += ", runs in " + seconds(run.milliseconds()) + "\u202fs";
    } catch (const NotYet&) {
        if (!context.draft) {
            throw;
        }
    }
    std::string before;
    for (const Chapter& other : context.chapters()) {
        for (const std::string& needed : chapter.builds_on) {
            before += needed == other.folder ? (before.empty() ? "" : ", ") + reference(other) : "";
        }
    }
    if (!before.empty()) {
        facts += " · Builds on: " + before;
    }
    return "# " + chapter.heading() + " {#" + chapter.id() + "}\n\n[TOC]\n\n<div class=\"facts\">" +
           facts + "</div>\n\n";
}

std::string chapter_footer(const Context& context) {
    const Chapter* before = nullptr;
    const Chapter* after = nullptr;
    for (const Chapter& chapter : context.chapters()) {
        if (chapter.number < context.chapter()->number) {
            before = &chapter;
        } else if (chapter.number > context.chapter()->number && after == nullptr) {
            after = &chapter;
        }
    }
    const auto link = [](const Chapter* chapter, const char* side) {
        return chapter == nullptr
                   ? std::string{}
                   : "<span class=\"" + std::string{side} + "\">" + reference(*chapter) + "</span>";
    };
    if (before == nullptr && after == nullptr) {
        return "\n";
    }
    return "\n\n<div class=\"neighbours\">" + link(before, "previous") + link(after, "next") +
           "</div>\n";
}

std::string chapters_markdown(Context& context) {
    std::string list = "\n\\htmlonly[block]<div class=\"chapters\">\\endhtmlonly\n";
    for (const Chapter& chapter : context.chapters()) {
        std::string picture;
        std::string state;
        try {
            picture = card(context, chapter);
        } catch (const NotYet&) {
            if (!context.draft) {
                throw;
            }
            ++context.gaps;
            state = " <span class=\"gap\">being made</span>";
        }
        list += "\n\\htmlonly[block]<div class=\"chapter\">" + picture +
                "<div class=\"about\">\\endhtmlonly\n<b>\\subpage " + chapter.id() + " \"" +
                replace_all(chapter.heading(), "\"", "'") + "\"</b>" + state + "\n\n" +
                chapter.question + "\n\n\\htmlonly[block]</div></div>\\endhtmlonly\n";
    }
    return list + "\n\\htmlonly[block]</div>\\endhtmlonly\n";
}

}  // namespace page
