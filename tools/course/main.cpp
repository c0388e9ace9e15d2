// The course program. ./course builds it and hands over to it.

#include <cstdio>
#include <exception>

#include "commands.hpp"
#include "terminal.hpp"

int main(int argc, char** argv) {
    const auto exit_with = [](course::Status status) { return static_cast<int>(status); };
    try {
        return exit_with(course::obey(argc, argv));
    } catch (const course::Stop& stop) {
        const std::string line = course::sanitized(stop.what());
        if (!line.empty()) std::fprintf(stderr, "course: %s\n", line.c_str());
        return exit_with(stop.status());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "course: %s\n", course::sanitized(error.what()).c_str());
        return exit_with(course::Status::wrong);
    }
}
