// course bench front-door: how long a reader waits, from a clone to the site, from a change to the
// verdict. All of it happens in a copy of the course, with the commands that a reader types.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>

#include <sys/resource.h>

#include "commands.hpp"
#include "exercises.hpp"
#include "files.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// What a command took, with all that it started in turn.
struct Cost {
    double seconds = 0;    // by the clock
    double processor = 0;  // of all cores
    double megabytes = 0;  // of the largest of its processes
};

// Processor time and largest size of all that this process has started and that has ended.
Cost spent() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {0, seconds(used.ru_utime) + seconds(used.ru_stime), static_cast<double>(used.ru_maxrss) / 1024};
}

// Types `command` in `folder`. `heard` gets its lines, and the seconds from the beginning to each.
Cost cost_of(const fs::path& folder, std::vector<std::string> command,
             const std::function<void(const std::string&, double)>& heard = {}) {
    const std::string shown = command[0] + " " + command[1];
    command.insert(command.begin(),
                   {"sh", "-c", "cd \"$1\" && shift && exec \"$@\" </dev/null", "sh", folder.string()});
    std::string said;
    const Cost before = spent();
    const auto begin = Clock::now();
    Lines lines([&](const std::string& line) {
        said += line + "\n";
        if (heard) heard(line, since(begin));
    });
    const int status = listen(command, std::ref(lines));
    Cost cost = spent();  // of sizes it knows the largest of all so far: ask after the first
    cost.seconds = since(begin);
    cost.processor -= before.processor;
    if (status == 0) return cost;
    std::fprintf(stderr, "%s", said.c_str());
    throw Stop(Status::wrong,
               "bench front-door: '" + shown + "' failed in " + folder.string() + "; its words stand above");
}

void say(const std::string& what, const Cost& cost, const std::string& wanted) {
    char processor[32] = "";  // nobody counted it where a command only got somewhere
    if (cost.processor > 0) std::snprintf(processor, sizeof processor, "%.1f", cost.processor);
    std::printf("%-52s %9.2f %9s   %s\n", what.c_str(), cost.seconds, processor, wanted.c_str());
    std::fflush(stdout);
}

// A new line at the end of the file.
void append(const fs::path& file, const std::string& line) { std::ofstream(file, std::ios::app) << line << "\n"; }

// The checkout as it stands, without what was built.
void copy_course(const fs::path& to) {
    fs::remove_all(to);
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(paths().source)) {
        const std::string name = entry.path().filename().string();
        if (name != "build" && name != ".git" && name != ".progress")
            fs::copy(entry.path(), to / name, fs::copy_options::recursive);
    }
}

// From the saved file to the verdict: the median of some checks of the course's own answer.
Cost check_of(const fs::path& folder, const std::string& room) {
    const fs::path answer = folder / "exercises" / (room + ".cpp");
    fs::copy_file(paths().source / "solutions" / (room + ".cpp"), answer, fs::copy_options::overwrite_existing);
    const std::string name = fs::path(room).filename().string();
    cost_of(folder, {"./course", "check", name});  // the first makes its hidden tests
    std::vector<Cost> costs;
    for (int i = 0; i < 11; ++i) {
        append(answer, "// saved");
        costs.push_back(cost_of(folder, {"./course", "check", name}));
    }
    std::sort(costs.begin(), costs.end(), [](const Cost& a, const Cost& b) { return a.seconds < b.seconds; });
    return costs[costs.size() / 2];
}

}  // namespace

void bench_front_door(bool with_tests) {
    if (is_kit()) throw Stop(Status::bad_use, "this is the learner's edition: bench front-door is for the course");
    const fs::path place = paths().build / "front_door", copy = place / "course", edition = place / "kit";
    copy_course(copy);
    fs::remove_all(edition);
    const std::string plain = "01_derivatives/velocity_now", eigen = "05_gyroscopic/world_acceleration";

    std::printf("%-52s %9s %9s   %s\n", "what", "seconds", "processor", "to reach");
    Cost first;
    const Cost tour = cost_of(copy, {"./course", "tour", "--yes"}, [&](const std::string& line, double at) {
        if (first.seconds == 0 && line.find("can be read") != std::string::npos) first.seconds = at;
    });
    say("the first chapter can be read", first, "60");
    say("cold tour", tour, "300 (600)");
    std::printf("%-52s %9.0f MB            600\n", "the largest compiler's memory", tour.megabytes);
    say("tour with nothing to do", cost_of(copy, {"./course", "tour"}), "0.2");

    const fs::path chapter = copy / "chapters/03_euler_variants";
    append(chapter / "chapter.md", "One word more.");
    say("a word changed in a chapter", cost_of(copy, {"./course", "site"}), "2");
    const std::string program = contents(chapter / "euler_variants.cpp"), number = "const int frames = 120;";
    const auto place_of_number = program.find(number);
    if (place_of_number == std::string::npos)
        throw Stop(Status::wrong, "bench front-door: chapter 3 has no number to change");
    write_whole(chapter / "euler_variants.cpp",
                std::string(program).replace(place_of_number, number.size(), "const int frames = 121;"));
    say("a number changed in a chapter's program", cost_of(copy, {"./course", "site"}), "10");
    write_whole(chapter / "euler_variants.cpp", program);  // the README shows what it draws
    cost_of(copy, {"./course", "site"});
    append(copy / "include/timestep/methods/semi_implicit_euler.hpp", "// one comment more");
    say("a comment changed in a method's header", cost_of(copy, {"./course", "site"}), "60");

    say("first check of an exercise",
        cost_of(copy, {"./course", "check", "steps_of_frames", "--file",
                       (copy / "solutions/02_first_order_form/steps_of_frames.cpp").string()}),
        "3");
    say("check, save to verdict", check_of(copy, plain), "0.3");
    say("check, save to verdict, with Eigen", check_of(copy, eigen), "");

    say("kit after a tour", cost_of(copy, {"./course", "kit", edition.string()}), "45");
    say("first command in a fresh kit", cost_of(edition, {"./course", "list"}), "1");
    const fs::path answer = copy / "solutions" / (plain + ".cpp");
    say("first check in a fresh kit",
        cost_of(edition, {"./course", "check", "velocity_now", "--file", answer.string()}), "");
    say("check in the kit, save to verdict", check_of(edition, plain), "0.3");
    say("check in the kit, save to verdict, with Eigen", check_of(edition, eigen), "");

    say("bench --quick, building included", cost_of(copy, {"./course", "bench", "--quick"}), "90");
    if (with_tests) {
        say("test after a tour", cost_of(copy, {"./course", "test"}), "300");
        copy_course(copy);
        say("cold test", cost_of(copy, {"./course", "test"}), "540");
    }
    fs::remove_all(place);
}

}  // namespace course
