// Instructions per step, counted by callgrind: what the library takes beside loops written by hand. The pages quote the
// tables and numbers like those of any other study. Each case is counted with few steps and with twice as many: what
// start and end of the work cost drops out of the difference.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/wait.h>

#include "cases.hpp"
#include "lab.hpp"

namespace fs = std::filesystem;

// callgrind finds it by its name: not inlined, not copied.
extern "C" [[gnu::noinline]] void counted_work(const std::function<void()>* work) {
    (*work)();
    asm volatile("" ::: "memory");  // a call, and no jump at the end
}

namespace {

std::vector<Case> all_cases() {
    std::vector<Case> all;
    for (const auto& cases : {methods_and_scenes, gyroscopic_solvers, bodies_and_rope, crowds, functions_for_c})
        for (const Case& one : cases()) all.push_back(one);
    return all;
}

void take_all_below_callgrind() {
    for (const Case& one : all_cases())
        for (const long steps : {one.few, one.few, 2 * one.few})  // the first of the three warms up
        {
            const std::function<void()> work = [&] { one.steps(steps); };
            counted_work(&work);
        }
}

struct Counts {
    std::vector<double> instructions;  // of each piece of work, in their order
    std::string failure;               // why there are none
};

// Starts this program again below callgrind.
Counts count_instructions() {
    std::string folder = (fs::temp_directory_path() / "timestep_count_XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) return {{}, "there is no folder for temporary files"};
    std::string command =
        "valgrind --tool=callgrind --toggle-collect=counted_work --dump-after=counted_work"
        " --combine-dumps=yes '--callgrind-out-file=" +
        folder + "/counts' '" + fs::read_symlink("/proc/self/exe").string() + "' --counted 2>&1";
    FILE* const said = popen(command.c_str(), "r");
    std::string last;
    for (char line[1000]; said != nullptr && std::fgets(line, sizeof line, said) != nullptr;) last = line;
    const int status = said == nullptr ? -1 : pclose(said);
    Counts counts;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        counts.failure = "valgrind is not installed (package valgrind)";
    else if (status != 0)  // an older valgrind does not know every instruction of a new processor
        counts.failure = "valgrind failed: " + last.substr(0, last.find('\n'));
    std::ifstream file(folder + "/counts");
    // One dump a call; the last one is of the rest.
    for (std::string line; counts.failure.empty() && std::getline(file, line);)
        if (line.starts_with("totals: ")) counts.instructions.push_back(std::strtod(line.c_str() + 8, nullptr));
    if (!counts.instructions.empty()) counts.instructions.pop_back();
    fs::remove_all(folder);
    return counts;
}

// The bars are those of g++ 12 on x86-64. A later compiler may write either loop better: it counts, and holds none.
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 13 && defined(__x86_64__)
constexpr bool bars_hold_here = true;
#else
constexpr bool bars_hold_here = false;
#endif

class Study {
public:
    Study(lab::Findings& out, const std::vector<double>& counts) : out_(out) {
        std::size_t next = 0;
        for (const Case& one : all_cases()) {
            if (next + 3 > counts.size()) throw std::runtime_error("callgrind left too few counts");
            per_step_[one.name] = (counts[next + 2] - counts[next + 1]) / double(one.few);
            next += 3;
        }
    }

    void run() {
        methods("instructions.tsv", "method",
                {{"explicit_euler", "explicit Euler"},
                 {"semi_implicit_euler", "semi-implicit Euler"},
                 {"implicit_euler", "implicit Euler"},
                 {"runge_kutta_4", "Runge-Kutta 4"}});
        methods("scenes.tsv", "scene",
                {{"gravity", "gravity"},
                 {"spring_gravity", "spring + gravity"},
                 {"spring_damper_gravity", "spring + damper + gravity"},
                 {"spring_damper_gravity_drag", "spring + damper + gravity + drag"}});
        const double explicit_euler = of("explicit_euler"), semi_implicit = of("semi_implicit_euler");
        out_.number("explicit_euler", explicit_euler, "", per_step);
        out_.number("semi_implicit_euler", semi_implicit, "", per_step);
        out_.number("gravity", of("gravity"), "", per_step);
        if (semi_implicit <= 1.05 * explicit_euler)
            out_.check("eulers_cost_the_same", true,
                       "semi-implicit Euler takes at most a twentieth more instructions a step than explicit Euler");
        bar(semi_implicit <= 1.05 * explicit_euler, "semi-implicit Euler costs more than explicit Euler");
        gyroscopic();
        terms();
        crowds();
        functions();
        for (const auto& miss : missed_) std::fprintf(stderr, "instruction_counts: %s\n", miss.c_str());
        if (bars_hold_here)
            out_.check("bars", missed_.empty(), "no step takes more than what is compared with it allows");
    }

    static constexpr const char* numbers[] = {
        "explicit_euler",          "semi_implicit_euler", "gravity",    "passive_box",    "gyroscopic_ball_costs",
        "gyroscopic_box_costs",    "sorted_ball",         "bullet_own", "functions_calm", "functions_more_in_world",
        "functions_more_in_float", "functions_most_more"};

private:
    static constexpr const char* per_step = "instructions a step";
    using Names = std::vector<std::pair<std::string, std::string>>;

    double of(const std::string& name, double per = 1) const { return std::round(per * per_step_.at(name)); }
    static std::string words(double count) { return std::to_string(std::lround(count)); }
    void bar(bool holds, const std::string& otherwise) {
        if (!holds) missed_.push_back(otherwise);
    }

    void methods(const std::string& file, const std::string& what, const Names& names) {
        auto& table = out_.table(file, {what, "library", "written by hand"});
        for (const auto& [name, title] : names) {
            const double library = of(name), hand = of("hand_" + name);
            table.row({title, library, hand});
            bar(library <= 1.05 * hand, name + ": " + words(library) + ", by hand " + words(hand));
        }
    }

    // A body pays for the kind of inertia it has, and a ball for nothing.
    void gyroscopic() {
        auto& table = out_.table("gyroscopic.tsv", {"a gyroscopic step of", "explicit", "one Newton step", "passive"});
        for (const auto& [body, title] : Names{{"ball", "a ball (uniform)"},
                                               {"capsule", "a capsule (two equal moments)"},
                                               {"box", "a box (three moments)"},
                                               {"any", "any body (a full matrix)"}}) {
            const double by_explicit = of("explicit_" + body), iteration = of("iteration_" + body);
            const double passive = of("passive_" + body);
            table.row({title, by_explicit, iteration, passive});
            bar(body != "ball" || (by_explicit <= 3 && iteration <= 3 && passive <= 3), "a ball costs something");
        }
        out_.number("passive_box", of("passive_box"), "", per_step);
    }

    // What is left out must cost nothing.
    void terms() {
        auto& table = out_.table(
            "terms.tsv", {"term", "in a scene of", "with it", "without it", "by hand without it", "the term costs"});
        const std::string all = "spring_damper_gravity_drag", legs = "spring_damper_gravity";
        const struct {
            std::string term, scene, with, without;
        } rows[] = {{"gravity", "spring, damper, drag", all, "spring_damper_drag"},
                    {"spring", "gravity, drag", "spring_gravity_drag", "gravity_drag"},
                    {"damper", "spring, gravity", legs, "spring_gravity"},
                    {"drag", "spring, damper, gravity", all, legs},
                    {"gyroscopic torque", "a box: gravity", "gyroscopic_box_with", "gyroscopic_box"},
                    {"gyroscopic torque", "a ball: gravity", "gyroscopic_ball_with", "gyroscopic_ball"},
                    {"contact, friction", "a ball: gravity", "contact_with", "contact"},
                    {"rolling resistance", "a ball: gravity, contact, friction", "rolling_with", "rolling"},
                    {"eight iterations", "a rope of 60 links: gravity", "iterations_with", "iterations"}};
        for (const auto& row : rows) {
            const double with = of(row.with), without = of(row.without), hand = of("hand_" + row.without);
            table.row({row.term, row.scene, with, without, hand, with - without});
            bar(without <= 1.02 * hand, row.term + " left out: " + words(without) + ", by hand " + words(hand));
        }
        for (const std::string body : {"gyroscopic_ball", "gyroscopic_box"})
            out_.number(body + "_costs", of(body + "_with") - of(body), "", per_step);
        bar(of("gyroscopic_ball_with") == of("gyroscopic_ball"), "a ball has no torque, and pays for it");
    }

    void crowds() {
        auto& table = out_.table("kinds.tsv", {"the bodies are", "a ball", "a capsule", "a box"});
        for (const auto& [way, title] : Names{{"sorted", "sorted by kind"},
                                              {"variant", "mixed, std::variant"},
                                              {"virtual", "mixed, virtual"},
                                              {"alike", "every body a box"}})
            table.row({title, of(way + "_ball"), of(way + "_capsule"), of(way + "_box")});
        out_.number("sorted_ball", of("sorted_ball"), "", "instructions a body and step");
        // A ball among sorted bodies costs what it costs in a scene that has never heard of the torque.
        const double sorted = of("sorted_ball", 100), no_torque = of("no_torque_ball", 100);
        bar(sorted <= 1.02 * no_torque,
            "a hundred balls among sorted bodies: " + words(sorted) + ", without the torque " + words(no_torque));
    }

    // The plain functions of gyroscopic.h beside the library's templates, and Bullet's own rule.
    void functions() {
        auto& table =
            out_.table("plain.tsv", {"plain function / template for any body / for this kind", "float, in the world",
                                     "in the body", "double, in the world", "in the body"});
        const bool has_bullet = per_step_.contains("bullet_own");
        const double bullet = has_bullet ? of("bullet_own") : 0;
        bool half_of_bullet = has_bullet;
        double more_in_world = 0, more_in_float = 0, most_more = 0;
        for (const auto& [rule, title] : Names{{"passive", "passive"},
                                               {"half_step", "half-step Jacobian"},
                                               {"calm", "calm half-step"},
                                               {"calm_capsule", "the same, two equal moments"},
                                               {"calm_ball", "the same, a ball"}}) {
            std::vector<lab::Cell> row{title};
            for (const std::string way : {"", "_in_body", "_in_double", "_in_double_in_body"}) {
                const std::string name = rule + way;
                const double function = of("functions_" + name), any = of("any_" + name), kind = of("library_" + name);
                const bool in_body = way.ends_with("in_body"), in_float = !way.starts_with("_in_double");
                const bool three_moments = title.find("the same") == std::string::npos;
                // No template steps a ball in the body's axes.
                row.emplace_back(words(function) + " / " + words(any) + " / " +
                                 (in_body && rule == "calm_ball" ? "–" : words(kind)));
                // The function asks what the template for this kind knows from its type: which moments are equal. In
                // double, three numbers are no vector of the processor's.
                bar(function - kind <= (three_moments && in_float ? 0 : 35),
                    name + ": " + words(function) + ", the template " + words(kind));
                bar(in_body || function - any <= (three_moments && in_float ? 0 : 15),
                    name + ": " + words(function) + ", for any body " + words(any));
                // A function that is left as a call costs more than to ask for the kind.
                bar(any - kind <= 30, name + " for any body: " + words(any) + ", for this kind " + words(kind));
                most_more = std::max(most_more, function - kind);
                if (!in_body) more_in_world = std::max(more_in_world, function - any);
                if (three_moments && in_float) more_in_float = std::max(more_in_float, function - kind);
                half_of_bullet = half_of_bullet && (!in_float || 2 * function <= bullet);
            }
            table.row(row);
        }
        bar(!has_bullet || half_of_bullet, "a plain function takes more than half of what Bullet's own takes");
        const std::string more = "instructions more than the template for ";
        out_.number("functions_calm", of("functions_calm"), "", per_step);
        out_.number("functions_more_in_world", more_in_world, "", more + "any body, at most, the spin in the world");
        out_.number("functions_more_in_float", more_in_float, "", more + "this kind, at most, three moments, in float");
        out_.number("functions_most_more", most_more, "", more + "this kind, at most");
        out_.text("bullet_own", has_bullet ? words(bullet) : "", per_step);
        if (half_of_bullet)
            out_.check("functions_bullet", true,
                       "in float, each plain function takes at most half as many instructions as Bullet's own rule");
    }

    lab::Findings& out_;
    std::map<std::string, double> per_step_;
    std::vector<std::string> missed_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "--counted") return take_all_below_callgrind(), 0;
    lab::Program program("instruction_counts", "instructions per step, counted by callgrind");
    return program.run(argc, argv, [](lab::Findings& out) {
        const Counts counts = count_instructions();
        if (counts.failure.empty()) return Study(out, counts.instructions).run();
        std::printf("instructions are not counted: %s\n", counts.failure.c_str());
        for (const char* name : Study::numbers) out.text(name, "", "instructions a step");  // pages show no value
    });
}
