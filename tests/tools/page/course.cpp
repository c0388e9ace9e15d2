#include "course.hpp"

#include "context.hpp"
#include "directives.hpp"
#include "text.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cstdio>
#include <random>
#include <stdexcept>

namespace fs = std::filesystem;

namespace {

const char* const page_source = R"(# Springs

## The question {#ch3_question}

It grows to {{amplitude}}.

## The mathematics {#ch3_mathematics}

### Steps {#ch3_steps}
{{claims N22}}

## The code {#ch3_code}

{{program: // Springs}}

{{program: int main}}

{{code include/step.hpp step}}

## The run {#ch3_run}

{{run}}

{{program}}

## The pictures {#ch3_pictures}

{{figure spiral.svg N22: **Out.** It reaches {{amplitude}}, $x^2$.}}

{{figure sweep.gif: A sweep.}}

## Break it {#ch3_break_it}
## What it costs {#ch3_cost}
## Exercises {#ch3_exercises}
## In the talk {#ch3_in_the_talk}
)";

/// Two frames of one pixel each, 4 by 2 pixels of screen, a colour table of two colours.
std::string small_gif() {
    const std::string frame{
        "\x21\xf9\x04\x00\x05\x00\x00\x00"
        "\x2c\x00\x00\x00\x00\x01\x00\x01\x00\x00\x02\x02\x44\x01\x00",
        23};
    return std::string{"GIF89a\x04\x00\x02\x00\x80\x00\x00\x00\x00\x00\xff\xff\xff", 19} +
           std::string{"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00", 19} + frame + frame + "\x3b";
}

}  // namespace

Course::Course() {
    std::random_device random;
    folder_ = fs::temp_directory_path() / ("page_test_" + std::to_string(random()));
    write("chapters/03_springs/about.json",
          R"({"title": "Springs", "question": "Why?", "needs": [], "builds_on": [],
              "claims": ["N22"], "picture": "spiral.svg", "figures": ["spiral.svg", "sweep.gif"]})");
    write("chapters/03_springs/chapter.md", page_source);
    write("chapters/03_springs/springs.cpp", "// Springs\nint x;\n\nint main() {}\n");
    write("include/step.hpp",
          "struct S {\n    /// [step]\n    void step() {\n        x += h * v;\n    }\n    /// "
          "[step]\n};\n");
    const std::string run = "runs/03_springs/run/";
    write(run + "numbers.tsv",
          "name\tvalue\tunit\tmeaning\n"
          "amplitude\t5.18\tm\tafter two seconds\n"
          "tiny\t-3.2e-16\tm/s^2\tleft over, < 1 | \"small\"\n"
          "winner\tRK4_x\t\tthe best\n"
          "lost\tnan\t\tnot found\n");
    write(run + "checks.tsv", "name\tstatement\ngrows\tthe amplitude grows\n");
    write(run + "places.tsv",
          "name\tkind\tplace\n"
          "amplitude\tnumber\tchapters/03_springs/study/growth.cpp:12\n"
          "lost\tnumber\tchapters/03_springs/study/growth.cpp:31\n"
          "grows\tcheck\tchapters/03_springs/study/growth.cpp:40\n"
          "costs.tsv\tdata\tchapters/03_springs/study/costs.cpp:7\n");
    write(run + "costs.tsv", "method\ttime_step\nEuler $x|y$\t1e-06\n\nRK4\t20000\n");
    write(run + "program.txt", "It has x < 3\n");
    write(run + "run.txt", "\nGrowth\n------\n  x < 3\n\nOrder\n-----\n  1.00\n");
    write(run + "seconds.txt", "420 ms\n");
    write(run + "spiral.svg", "<svg\n width=\"640\" height=\"480\"\n></svg>\n");
    write(run + "sweep.gif", small_gif());
    write("tools/figures/dark.tsv", "#ffffff\t#1c1d1f\n");
    write("docs/talks.tsv", "N22\tN\tIt spirals, $a<b$.\tNot always.\t\n");
}

Course::~Course() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void Course::write(const std::string& file, const std::string& content) const {
    page::write_file(folder_ / file, content);
}

std::string Course::read(const std::string& file) const { return page::read_file(folder_ / file); }

void Course::replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string content = read(file);
    const std::size_t at = content.find(from);
    if (at == std::string::npos) throw std::logic_error{file + " has no " + from};
    write(file, content.replace(at, from.size(), to));
}

std::string Course::fill() const {
    page::Context context{folder_, folder_ / "runs"};
    context.set_chapter("03_springs");
    return page::fill(context, read("chapters/03_springs/chapter.md"), "chapter.md");
}

std::string Course::fill_error() const {
    return message_of([&] { fill(); });
}

std::string Course::fill_paragraph(const std::string& paragraph) const {
    write("chapters/03_springs/chapter.md", page::replace_all(page_source, "It grows to {{amplitude}}.", paragraph));
    return fill();
}

std::string Course::paragraph_error(const std::string& paragraph) const {
    return message_of([&] { fill_paragraph(paragraph); });
}

void Course::shows(std::initializer_list<Case> cases) const {
    for (const Case& each : cases) {
        CAPTURE(each.paragraph);
        CHECK_THAT(fill_paragraph(each.paragraph), Catch::Matchers::ContainsSubstring(each.expected));
    }
}

void Course::refuses(std::initializer_list<Case> cases) const {
    for (const Case& each : cases) {
        CAPTURE(each.paragraph);
        CHECK_THAT(paragraph_error(each.paragraph), Catch::Matchers::ContainsSubstring(each.expected));
    }
}

Outcome run_command(const std::string& command) {
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error{command + ": cannot be run"};
    Outcome outcome{};
    std::array<char, 512> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) outcome.words += buffer.data();
    const int status = pclose(pipe);
    outcome.status = status >= 256 ? status / 256 : status;
    return outcome;
}
