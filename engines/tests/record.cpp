// What ./course bench engines leaves for a page.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include <catch2/catch_test_macros.hpp>

#include "scenes.hpp"

namespace {

namespace fs = std::filesystem;

struct Folder {
    fs::path path = fs::temp_directory_path() / ("timestep_record_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    std::string text(const char* name) const {
        std::ostringstream words;
        words << std::ifstream(path / name).rdbuf();
        return words.str();
    }
};

}  // namespace

TEST_CASE("The table of stacks has only engines in which stacks stand as the engine is", "[engines]") {
    engines::Numbers numbers;
    const auto stands = [&](const char* engine, const char* rule, double of_a_hundred) {
        numbers.add("stack", "twenty boxes", {engine, rule, {}}, "standing, of a hundred", of_a_hundred);
    };
    stands("Bullet", "as it is", 40), stands("Bullet", "calm half-step, halves", 0);
    stands("Jolt", "without its rule", 0), stands("Jolt", "as it is", 0), stands("Jolt", "calm half-step, after", 10);
    stands("ODE", "as it is", 0), stands("ODE", "calm half-step, halves", 0);
    stands("Box3D, 1 substep", "as it is", 0);
    const Folder folder;
    engines::record(folder.path, numbers);
    const std::string expected =
        "engine: rule\tstacks that stand, %\tasleep after, s\tsunk, m\n"
        "Bullet: as it is\t40\t–\t–\n"
        "Bullet: calm half-step, halves\t0\t–\t–\n";
    CHECK(folder.text("stacks.tsv") == expected);
    CHECK(folder.text("checks.tsv").find("\nstacks_fall\t") != std::string::npos);
}

TEST_CASE("Where one engine's stacks stand as it is, no check says that they fall", "[engines]") {
    engines::Numbers numbers;
    for (const char* engine : {"Box3D, 1 substep", "Jolt", "ODE"})
        numbers.add("stack", "twenty boxes", {engine, "as it is", {}}, "standing, of a hundred",
                    engine[0] == 'O' ? 10 : 0);
    const Folder folder;
    engines::record(folder.path, numbers);
    CHECK(folder.text("checks.tsv").find("stacks_fall") == std::string::npos);
}

TEST_CASE("A new run keeps the rows of engines' own tests, and no other old row", "[engines]") {
    const Folder folder;
    for (const char* name : {"numbers.tsv", "checks.tsv"})
        std::ofstream(folder.path / name) << "name\tand so on\nold\t1\nown_box3d_cases\t223\t\tcases\n";
    engines::record(folder.path, {});
    CHECK(folder.text("numbers.tsv") == "name\tvalue\tunit\tmeaning\nown_box3d_cases\t223\t\tcases\n");
    CHECK(folder.text("checks.tsv") == "name\tstatement\nown_box3d_cases\t223\t\tcases\n");
}
