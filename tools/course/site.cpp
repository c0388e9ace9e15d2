// course site

#include <cstdio>

#include "build.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

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
