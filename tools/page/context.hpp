#pragma once

#include "chapter.hpp"
#include "run_data.hpp"
#include "scanner.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace page {

/// Where a claim is taught or drawn: one line of a page's index file.
struct IndexEntry {
    std::string row, kind, page, anchor, title;  ///< kind: "section" or "figure"
};

/// A part of a chapter's program.
struct Part {
    std::string code;
    int first_line;
};

/// A figure in the order in which a page's or a chapter's are numbered.
struct Numbered {
    std::string figure;  ///< `chapter/file`
    std::string page;    ///< the id of the chapter's page that shows it; empty on any other page
};

/// What the talks show in one claim, in our words.
struct TalkRow {
    std::string talk, text, erratum;  ///< the erratum is empty when there is none
    std::vector<std::string> checks;  ///< of the study that confirm the row
    int line;                         ///< in docs/talks.tsv
};

/// What the page that is being filled knows of the course, and what it gathers on its way.
class Context {
public:
    Context(std::filesystem::path root, std::filesystem::path runs);

    const std::filesystem::path& root() const { return root_; }
    const std::filesystem::path& runs() const { return runs_; }
    const std::vector<Chapter>& chapters() const { return chapters_; }

    /// Makes this page the chapter's, its second one where it is made from a file more.md. Throws
    /// std::out_of_range when there is no such folder.
    void set_chapter(const std::string& folder, const std::filesystem::path& input = "chapter.md");
    const Chapter* chapter() const { return chapter_; }
    bool is_more() const { return more_; }
    /// The id of the chapter's page that this is: `chapter_03`, `more_03`; nothing where it is
    /// none.
    std::string page() const { return chapter_ == nullptr ? "" : chapter_->id(more_); }

    /// The run that `reference` names: that before the slash, or this chapter's without one.
    /// `name` becomes what follows the slash. Throws std::out_of_range when there is no such run.
    RunData& run_of(const std::string& reference, std::string& name);
    /// The chapter (or the folder below the runs) whose run that is.
    const std::string& folder_of(const std::string& reference);

    std::vector<IndexEntry> index;                         ///< rows taught and drawn here
    std::map<std::string, std::filesystem::path> figures;  ///< shown here: `chapter/file`, drawn at
    std::vector<Numbered> order;                           ///< the figures of the page, of both of a chapter's
    std::set<std::string> left_out;                        ///< figures that this run leaves out: `chapter/file`
    std::set<std::string> anchors;                         ///< ids of those figures
    std::set<std::filesystem::path> inputs;                ///< files read besides the runs'
    std::map<std::string, std::string> pages;              ///< what goes on pages beside this one: file, Markdown
    Heading heading{};                                     ///< directly above; without an id where text stands between
    std::string program;                                   ///< the chapter's
    std::vector<Part> parts;                               ///< of it, as the page shows them
    std::size_t parts_shown = 0;
    bool asked = false;             ///< between {{ask: …}} and {{answered}}
    bool draft = false;             ///< what no run has left yet becomes a gap
    int gaps = 0;                   ///< so many, in a draft
    std::filesystem::path indexes;  ///< for the page of the talks

private:
    std::filesystem::path root_, runs_;
    std::vector<Chapter> chapters_;
    const Chapter* chapter_ = nullptr;
    bool more_ = false;
    std::map<std::string, RunData> data_;
};

}  // namespace page
