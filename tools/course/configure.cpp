#include "configure.hpp"

#include <cstdio>

#include "files.hpp"
#include "places.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// CMake's first error. Its words are broken into lines, indented by two, and end with an empty one or with where
// it was.
class FirstError {
public:
    void hear(const std::string& line) {
        if (!begun_ && line.starts_with("CMake Error")) {
            begun_ = true;
            if (line.starts_with("CMake Error: ")) text_ = line.substr(13);
        } else if (begun_ && !ended_) {
            ended_ = (line.empty() && !text_.empty()) || line.starts_with("Call Stack");
            const auto words = line.find_first_not_of(' ');
            if (!ended_ && words != std::string::npos) text_ += (text_.empty() ? "" : " ") + line.substr(words);
        }
    }
    // Its first sentence: two blanks stand before the next.
    std::string text() const {
        return text_.empty() ? "CMake could not configure the build" : text_.substr(0, text_.find(".  "));
    }

private:
    bool begun_ = false, ended_ = false;
    std::string text_;
};

fs::path place_of_lock() {
    const auto lock = places().build / "course.lock";
    if (Lock::is_held(lock)) std::fprintf(stderr, "Another ./course is building here; this goes on when it has done\n");
    return lock;
}

}  // namespace

void configure() {
    const Lock one_at_a_time(place_of_lock());
    FirstError error;
    Lines lines([&](const std::string& line) { error.hear(line); });
    if (listen({places().cmake, "-S", places().source.string(), "-B", places().build.string()}, std::ref(lines)) != 0)
        throw Stop(Status::bad_use, error.text());
}

// To list what there is to build, Ninja or Make must have read all of it.
std::string why_unbuildable() {
    const Lock one_at_a_time(place_of_lock());
    std::string why;
    Lines lines([&](const std::string& line) {
        if (why.empty() && (line.starts_with("ninja: error: ") || line.find("***") != std::string::npos)) why = line;
    });
    if (listen({places().cmake, "--build", places().build.string(), "--target", "help"}, std::ref(lines)) == 0)
        return "";
    return why.empty() ? "what CMake has written of it cannot be built" : why;
}

}  // namespace course
