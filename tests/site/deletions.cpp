// Nothing that a page uses can go missing unnoticed: for every chapter, each number, check, figure,
// table, heading of the run and snippet that its page (or its second one, more.md) uses is taken
// away in a copy, one at a time, and the page tool must refuse the page.
//
//     deletions PAGE_TOOL ROOT RUNS CHAPTER
//
// copies what the page of the chapter reads and prints what it took away. Exit status 0 when every
// deletion was refused, 1 when one passed.

#include "scanner.hpp"
#include "text.hpp"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>

namespace fs = std::filesystem;

namespace {

/// A copy of the chapters, their runs and the quoted sources, in which things can be broken.
class Copy {
public:
    Copy(std::string tool, const fs::path& root, const fs::path& runs, std::string chapter)
        : tool_{std::move(tool)}, chapter_{std::move(chapter)} {
        folder_ = fs::temp_directory_path() / ("deletions_" + std::to_string(std::random_device{}()));
        fs::create_directories(folder_);
        for (const char* part : {"chapters", "include", "solutions", "tests", "tools"}) {
            fs::copy(root / part, folder_ / part, fs::copy_options::recursive);
        }
        for (const auto& entry : fs::directory_iterator{runs}) {
            for (const char* part : {"run", "live"}) {
                const fs::path run = entry.path().filename() / part;
                if (fs::is_directory(runs / run)) {
                    fs::create_directories(folder_ / "runs" / run);
                    fs::copy(runs / run, folder_ / "runs" / run, fs::copy_options::recursive);
                }
            }
        }
    }
    ~Copy() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;

    fs::path source() const { return folder_ / "chapters" / chapter_ / page_; }
    /// The chapter's page that is to be filled: chapter.md or more.md. Is it there?
    bool turn_to(const std::string& page) {
        page_ = page;
        return fs::exists(source());
    }
    fs::path root() const { return folder_; }
    /// A file of the run that `reference` names (`file`, or `NN_name/file`).
    fs::path run(const std::string& chapter, const std::string& file) const {
        return folder_ / "runs" / chapter / "run" / file;
    }
    const std::string& chapter() const { return chapter_; }

    /// The page tool's exit status on the copy as it is now.
    int fill() const {
        const fs::path output = folder_ / "page.md";
        const std::string command = "'" + tool_ + "' --source '" + folder_.string() + "' --runs '" +
                                    (folder_ / "runs").string() + "' --chapter " + chapter_ + " --input '" +
                                    source().string() + "' --output '" + output.string() + "' 2>'" +
                                    (folder_ / "words").string() + "'";
        const int status = std::system(command.c_str());
        const bool left_over = status != 0 && fs::exists(output);
        return left_over ? -1 : (status >= 256 ? status / 256 : status);
    }
    std::string words() const { return page::read_file(folder_ / "words"); }

private:
    std::string tool_, chapter_, page_ = "chapter.md";
    fs::path folder_;
};

/// Changes one file of the copy, or takes it away when nothing is left of it, fills the page, and
/// puts the file back.
class Deletions {
public:
    explicit Deletions(const Copy& copy) : copy_{copy} {}

    void try_without(const std::string& what, const fs::path& file,
                     const std::function<std::string(const std::string&)>& change) {
        if (!tried_.insert(what).second) {
            return;
        }
        const std::string content = page::read_file(file);
        const std::string changed = change(content);
        if (changed == content) {
            report(what, "was not there to be taken away");
        } else {
            if (changed.empty()) {
                fs::remove(file);
            } else {
                page::write_file(file, changed);
            }
            const int status = copy_.fill();
            if (status != 2) {
                report(what, "can go: the page tool's exit status is " + std::to_string(status));
            }
        }
        page::write_file(file, content);
    }

    int count() const { return static_cast<int>(tried_.size()); }
    int passed() const { return passed_; }

private:
    void report(const std::string& what, const std::string& message) {
        std::cout << copy_.chapter() << ": " << what << " " << message << "\n";
        ++passed_;
    }

    const Copy& copy_;
    std::set<std::string> tried_;
    int passed_ = 0;
};

/// Without the lines for which `goes` holds.
std::string without_lines(const std::string& content, const std::function<bool(const std::string&)>& goes) {
    std::string kept;
    for (const std::string& line : page::split_lines(content)) {
        kept += goes(line) ? "" : line + "\n";
    }
    return kept;
}

/// Takes away what one directive of the page uses.
void try_directive(const Copy& copy, Deletions& deletions, const std::string& directive) {
    const std::size_t colon = directive.find(':');
    const std::vector<std::string> words = page::split_words(directive.substr(0, colon));
    const std::string& kind = words.front();
    // The last word but the first names what is used; a slash parts it from its chapter.
    const auto in_run = [&](std::string name, const std::string& file, bool is_file) {
        std::string chapter = copy.chapter();
        if (const std::size_t slash = name.find('/'); slash != std::string::npos) {
            chapter = name.substr(0, slash);
            name = name.substr(slash + 1);
        }
        const auto delete_record = [&](const std::string& content) {
            return without_lines(content, [&](const std::string& line) { return line.starts_with(name + "\t"); });
        };
        if (is_file) {
            deletions.try_without(name, copy.run(chapter, name), [](const std::string&) { return std::string{}; });
        } else {
            deletions.try_without(name + " in " + file, copy.run(chapter, file), delete_record);
        }
    };
    if (kind == "where") {
        in_run(words.at(1), "numbers.tsv", false);
    } else if (kind == "check") {
        in_run(words.at(1), "checks.tsv", false);
    } else if (kind == "figure" || kind == "table" || kind == "said") {
        in_run(words.at(1), "", true);
        if (words.at(1).ends_with(".svg")) {  // drawn for phones, too
            const std::size_t slash = words[1].find('/');
            in_run(slash == std::string::npos
                       ? copy.chapter() + "/narrow/" + words[1]
                       : fs::path{words[1]}.replace_filename("narrow").string() + words[1].substr(slash),
                   "", true);
        }
    } else if (kind == "live") {
        const auto nothing = [](const std::string&) { return std::string{}; };
        const std::string name = words.at(1), source = "chapters/" + copy.chapter() + "/live/" + name + ".cpp";
        deletions.try_without(source, copy.root() / source, nothing);
        deletions.try_without(name + ", still", copy.run(copy.chapter(), "../live/" + name + ".svg"), nothing);
    } else if (kind == "run") {
        const std::string heading{
            colon == std::string::npos ? "" : page::trim(std::string_view{directive}.substr(colon + 1))};
        deletions.try_without(
            "output under \"" + heading + "\"", copy.run(copy.chapter(), heading.empty() ? "program.txt" : "run.txt"),
            [&](const std::string& content) { return heading.empty() ? "" : page::replace_all(content, heading, ""); });
    } else if (kind == "program") {
        const std::string first_words{
            colon == std::string::npos ? "" : page::trim(std::string_view{directive}.substr(colon + 1))};
        if (!first_words.empty()) {
            const std::string program = "chapters/" + copy.chapter() + "/" + copy.chapter().substr(3) + ".cpp";
            deletions.try_without(
                "\"" + first_words + "\" in " + program, copy.root() / program,
                [&](const std::string& content) { return page::replace_all(content, first_words, "/* gone */"); });
        }
    } else if (kind == "code") {
        const std::string file = words.at(1);
        std::string tag = words.at(2);
        for (std::size_t i = 3; i < words.size(); ++i) {
            tag += " " + words[i];
        }
        deletions.try_without("[" + tag + "] in " + file, copy.root() / file, [&](const std::string& content) {
            return page::replace_all(content, "[" + tag + "]", "");
        });
    } else if (kind == "line") {
        const std::string style = "tools/figures/style.gp", name = words.at(1);
        deletions.try_without(name + " in " + style, copy.root() / style, [&](const std::string& content) {
            return without_lines(content, [&](const std::string& line) {
                return line.starts_with(name) && line.find_first_not_of(' ', name.size()) == line.find('=');
            });
        });
    } else if (kind != "end" && kind != "claims" && kind != "chapters" && kind != "talks" && kind != "exercises" &&
               kind != "which" && kind != "ask" && kind != "answered" && kind != "see" && kind != "compile") {
        std::string name = kind;
        if (name.ends_with(".value")) {
            name.erase(name.size() - 6);
        }
        in_run(name, "numbers.tsv", false);
    }
}

/// Does the directive begin what this run has not measured (a library was not there), so that the page leaves it out?
bool leaves_out(const Copy& copy, const std::string& directive) {
    const std::vector<std::string> words = page::split_words(directive);
    if (words.size() != 2 || words[0] != "where") {
        return false;
    }
    const std::string numbers = "\n" + page::read_file(copy.run(copy.chapter(), "numbers.tsv"));
    return numbers.find("\n" + words[1] + "\t\t") != std::string::npos;
}

/// Captions and formulas hold directives of their own.
void try_pieces(const Copy& copy, Deletions& deletions, const std::string& source) {
    using Kind = page::Piece::Kind;
    bool left_out = false;
    for (const page::Piece& piece : page::scan(source, "chapter.md")) {
        left_out = left_out && !(piece.kind == Kind::directive && page::trim(piece.text) == "end");
        if (left_out) {
            continue;
        }
        if (piece.kind == Kind::directive) {
            left_out = leaves_out(copy, piece.text);
            try_directive(copy, deletions, piece.text);
            try_pieces(copy, deletions, piece.text);
        } else if (piece.kind == Kind::formula || piece.kind == Kind::display) {
            for (std::size_t at = 0; (at = piece.text.find("{{", at)) != std::string::npos; at += 2) {
                const std::size_t end = piece.text.find("}}", at);
                try_directive(copy, deletions, piece.text.substr(at + 2, end - at - 2));
            }
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: deletions PAGE_TOOL ROOT RUNS CHAPTER\n";
        return 2;
    }
    try {
        Copy copy{argv[1], argv[2], argv[3], argv[4]};
        bool all = true;
        for (const char* page : {"chapter.md", "more.md"}) {
            if (!copy.turn_to(page)) {
                continue;
            }
            if (copy.fill() != 0) {
                std::cerr << page << " is wrong as it is: " << copy.words();
                return 1;
            }
            Deletions deletions{copy};
            try_pieces(copy, deletions, page::read_file(copy.source()));
            std::cout << copy.chapter() << "/" << page << ": " << deletions.count() << " deletions, "
                      << deletions.passed() << " unnoticed\n";
            all = all && deletions.passed() == 0 && deletions.count() > 0;
        }
        return all ? 0 : 1;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 1;
    }
}
