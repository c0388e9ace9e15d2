// course site

#include <cstdio>

#include "build.hpp"
#include "commands.hpp"
#include "exercises.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

void site(bool open) {
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
        throw Stop(Status::missing,
                   std::string(opener) + " found no browser; open the address above in one");
}

}  // namespace course
