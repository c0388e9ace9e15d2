// course tour, course site

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include <unistd.h>

#include "build.hpp"
#include "chapters.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// The time of the chapter's run, which the run has measured.
double seconds_of(const Chapter& chapter) {
    const auto path = chapter.run() / "seconds.txt";
    std::ifstream file(path);
    double amount = 0;
    std::string unit;
    if (!(file >> amount >> unit) || unit != "ms")
        throw Stop(Status::wrong, path.string() + ": does not hold a time in ms");
    return amount / 1000;
}

void print_table(const std::vector<Chapter>& chapters) {
    std::size_t name_width = 7, title_width = 5;
    for (const auto& chapter : chapters) {
        name_width = std::max(name_width, chapter.folder.size());
        title_width = std::max(title_width, width_of(chapter.title));
    }
    const auto print_row = [&](const std::string& name, const std::string& title, double seconds, std::size_t figures,
                               std::size_t rows) {
        std::printf("%s  %s  %7.2f  %7zu  %17zu\n", padded(name, name_width).c_str(),
                    padded(title, title_width).c_str(), seconds, figures, rows);
    };
    std::printf("%s\n", bold(padded("chapter", name_width) + "  " + padded("title", title_width) +
                             "  seconds  figures  claims of the talks")
                            .c_str());
    double seconds = 0;
    std::size_t figures = 0, rows = 0;
    for (const auto& chapter : chapters) {
        print_row(chapter.folder, chapter.title, seconds_of(chapter), chapter.figures.size(), chapter.claims.size());
        seconds += seconds_of(chapter);
        figures += chapter.figures.size();
        rows += chapter.claims.size();
    }
    print_row("all", "", seconds, figures, rows);
}

// The first page first; then the site grows with every chapter.
void grow(const std::vector<Chapter>& chapters, ProgressLine& progress) {
    build({"first_chapter"}, progress);
    progress.say("  The site is there, and grows: " + site_address());
    const auto exercises = read_exercises();  // the reader may want to check the first one now
    if (!exercises.empty()) make_ready({exercises.front()}, progress);
    // One after the other, while the next one is compiled. Otherwise all would appear at the end.
    for (std::size_t i = 1; i < chapters.size(); ++i) {
        std::vector<std::string> targets{"grow_" + chapters[i].folder};
        if (i + 1 < chapters.size()) targets.push_back(chapters[i + 1].program);
        build(targets, progress);
        usleep(100'000);  // lets another ./course build that waits
    }
    build({"docs"}, progress);
}

// The whole course as a book to print; a browser prints it.
void print_book() {
    if (is_kit())
        throw Stop(Status::bad_use, "--pdf: the learner's edition has no book; a checkout of the course makes it");
    {
        ProgressLine progress;
        build({"book"}, progress);
    }
    const fs::path folder = paths().build / "site";
    if (!fs::exists(folder / "timestep.pdf"))
        throw Stop(Status::missing, "--pdf: no browser that prints was found (package chromium); to print by hand: " +
                                        address_of(folder / "book.html"));
    std::printf("%s\n", address_of(folder / "timestep.pdf").c_str());
}

}  // namespace

void tour() {
    const auto begin = std::chrono::steady_clock::now();
    const auto chapters = read_chapters();
    ProgressLine progress;
    progress.say(std::string("Building the programs, running the chapters, drawing the figures") +
                 (is_kit() ? ":" : ", making the site:"));
    if (!is_kit() && !fs::exists(paths().build / "site/html/made")) {
        try {
            grow(chapters, progress);
        } catch (const Stop& stop) {
            if (stop.status() != Status::interrupted || !fs::exists(paths().build / "site/html/index.html")) throw;
            throw Stop(Status::interrupted, "interrupted. What is there can be read: " + site_address() +
                                                "; ./course tour goes on from there");
        }
    } else {
        build({"docs"}, progress);
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    progress.say("  done in " + std::to_string(std::lround(taken.count())) + " s\n");
    print_table(chapters);
    std::printf("\nThe site: %s\nNext: open it in a browser; ./course list shows the exercises\n",
                site_address().c_str());
}

void site(bool open, bool pdf) {
    if (pdf) return print_book();
    if (!is_kit()) {  // which comes with a site
        ProgressLine progress;
        build({"docs"}, progress);
    }
    std::printf("%s\n", site_address().c_str());
    if (!open) return;
    std::fflush(stdout);
#ifdef __APPLE__
    const char* opener = "open";
#else
    const char* opener = "xdg-open";
#endif
    if (listen({opener, site_address()}, [](std::string_view) {}) != 0)
        throw Stop(Status::missing, std::string(opener) + " found no browser; open the address above in one");
}

}  // namespace course
