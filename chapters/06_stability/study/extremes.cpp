// What every method makes of inputs that no game should have: a table of cells, counted.

#include <cstdio>
#include <map>
#include <string_view>

#include "extremes/extremes.hpp"
#include "sections.hpp"

using namespace extremes;

namespace {

const Outcome all_words[] = {Outcome::refused, Outcome::exact,    Outcome::bounded,
                             Outcome::grows,   Outcome::reported, Outcome::does_not_compile};

long count(const std::vector<Cell>& cells, Outcome word) {
    return std::count_if(cells.begin(), cells.end(), [=](const Cell& cell) { return cell.found == word; });
}

const Cell& find(const std::vector<Cell>& cells, std::string_view real, std::string_view scene,
                 std::string_view method) {
    for (const Cell& cell : cells)
        if (cell.real == real && cell.scene == scene && cell.method == method) return cell;
    throw std::logic_error("extremes: no cell " + std::string(scene) + ", " + std::string(method));
}

// How often each word fell.
void outcomes(const std::vector<Cell>& methods, const std::vector<Cell>& bodies, lab::Findings& out) {
    auto& table = out.table("outcomes.tsv", {"what happens", "methods and forces", "solvers and bodies"});
    for (const Outcome word : all_words) {
        const long m = count(methods, word), b = count(bodies, word);
        table.row({words(word), double(m), double(b)});
        std::printf("  %-22s %5ld %5ld\n", words(word), m, b);
    }
    const long cells = long(methods.size() + bodies.size());
    const long wrong = count(methods, Outcome::wrong) + count(bodies, Outcome::wrong);
    out.number("extreme_cells", double(cells), "", "extreme inputs that were tried");
    std::printf("  of %ld cells, %ld are not what theory expects\n", cells, wrong);
    long unlike = 0;
    for (const auto* all : {&methods, &bodies})
        for (const Cell& cell : *all) {
            if (cell.found == cell.expected) continue;
            ++unlike;
            std::printf("  %s, %s, %s: %s instead of %s\n", cell.real.c_str(), cell.scene.c_str(), cell.method.c_str(),
                        words(cell.found), words(cell.expected));
        }
    out.check("extremes_as_expected", unlike == 0 && cells >= 400,
              "every one of the extreme inputs ends as theory says: none crashes, hangs, or fails "
              "in silence");
}

// The cells that say most.
void telling(const std::vector<Cell>& cells, lab::Findings& out) {
    const char* names[] = {"explicit Euler", "semi-implicit Euler", "implicit Euler", "Runge-Kutta 4"};
    auto& table = out.table("telling_cells.tsv", {"input", names[0], names[1], names[2], names[3]});
    for (const char* scene : {"step 0", "step tiny", "step huge", "start NaN", "ω stiff", "ω² h² huge", "damper 1e30",
                              "masses 1 : 1e−30", "drag 1e30", "start subnormal", "t + h = t", "a million steps"}) {
        std::vector<lab::Cell> row{scene};
        for (const char* name : names) row.push_back(words(find(cells, "double", scene, name).found));
        table.row(row);
    }
    for (const char* real : {"float", "double"}) {
        const Cell& cell = find(cells, real, "a million steps", "explicit Euler");
        const std::string step = cell.note.substr(cell.note.rfind(' ') + 1);
        out.number(std::string("last_number_") + real, std::atof(step.c_str()), "",
                   std::string("the step at which explicit Euler leaves the numbers of a ") + real);
    }
    out.number("million_wh", 6.0 / 60, "", "omega h of a million steps");
    out.text("refusal", find(cells, "double", "step huge", "explicit Euler").note,
             "what a run says of a step of 1e300 s");
}

// What the page says of whole rows.
void rows(const std::vector<Cell>& cells, lab::Findings& out) {
    // Does it hold of every cell of these scenes? Of a scene that is not there it does not.
    const auto all_of = [&](std::initializer_list<const char*> scenes, const auto& holds) {
        return std::all_of(scenes.begin(), scenes.end(), [&](const std::string& scene) {
            long there = 0, good = 0;
            for (const Cell& cell : cells)
                if (cell.scene == scene) ++there, good += holds(cell);
            return there > 0 && good == there;
        });
    };
    const bool implicit_alone = all_of({"ω stiff", "masses 1 : 1e−30", "drag 1e30"}, [](const Cell& cell) {
        const std::string& m = cell.method;
        return (cell.found == Outcome::bounded) == (m == "implicit Euler" || m == "implicit midpoint" || m == "BDF2");
    });
    const bool harmless = all_of({"step tiny", "ω tiny", "ω = 0", "t + h = t", "lengths × 2ⁿ", "lengths ÷ 2ⁿ"},
                                 [](const Cell& cell) { return cell.found == Outcome::exact; });
    out.check("stiff_implicit_alone", implicit_alone,
              "on stiff springs and drag the implicit methods alone stay bounded");
    out.check("scales_harmless", harmless,
              "every method is exact in tiny steps, late in time, and in any unit of length");
}

// For the figure: a row a scene that not every method refuses, a column a method. Of the scenes
// that start too far off one row says enough, that of the spring.
void grid(const std::vector<Cell>& cells, lab::Findings& out) {
    auto& table = out.table("extremes.tsv", {"column", "row", "word", "method", "scene"});
    std::map<std::string, int> columns;
    std::vector<std::string> scenes;
    for (const Cell& cell : cells) {
        if (cell.real != "double") continue;
        columns.try_emplace(cell.method, int(columns.size()));
        const bool shown = cell.found != Outcome::refused && cell.found != Outcome::does_not_compile &&
                           cell.scene.find("decay") == std::string::npos &&
                           cell.scene.find(" start huge") == std::string::npos;
        if (shown && std::find(scenes.begin(), scenes.end(), cell.scene) == scenes.end()) scenes.push_back(cell.scene);
    }
    for (const Cell& cell : cells) {
        const auto row = std::find(scenes.begin(), scenes.end(), cell.scene);
        if (cell.real == "double" && row != scenes.end())
            table.row({double(columns[cell.method]), double(row - scenes.begin()), double(int(cell.found)), cell.method,
                       cell.scene});
    }
}

}  // namespace

void extreme_inputs(const Settings&, lab::Findings& out) {
    out.section("Extreme inputs");
    const std::vector<Cell> methods = of_methods(), bodies = of_bodies();
    outcomes(methods, bodies, out);
    telling(methods, out);
    rows(methods, out);
    grid(methods, out);
}
