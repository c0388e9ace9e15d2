// The claims of chapter 6 about extreme inputs: every cell of its table ends as theory says.
#include <catch2/catch_test_macros.hpp>

#include <timestep/methods/implicit_euler.hpp>
#include <timestep/models/spring.hpp>

#include "chapters/06_stability/study/extremes/extremes.hpp"

using namespace extremes;

namespace {

void check_all(const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) {
        INFO(cell.real << ", " << cell.scene << ", " << cell.method << ": " << cell.note);
        CHECK(std::string(words(cell.found)) == words(cell.expected));
        CHECK(cell.expected != Outcome::wrong);
        if (cell.found == Outcome::refused) CHECK(cell.note.find(": must be ") != std::string::npos);
        if (cell.found == Outcome::reported) CHECK(cell.note.rfind("at step ", 0) == 0);
    }
}

}  // namespace

TEST_CASE("every method and every gyroscopic solver ends every extreme scene as theory says", "[N62][ch6]") {
    const std::vector<Cell> methods = of_methods(), bodies = of_bodies();
    CHECK(methods.size() > 1000);
    check_all(methods);
    CHECK(bodies.size() > 700);
    check_all(bodies);
}

// The judge's words are not given away: each needs its own proof.
TEST_CASE("a cell that ends otherwise than theory says is wrong", "[ch6]") {
    CHECK(judge({Outcome::bounded, 2}, 1, 1.5, 1, 0) == Outcome::bounded);
    CHECK(judge({Outcome::bounded, 2}, 1, 2.5, 1, 0) == Outcome::wrong);
    CHECK(judge({Outcome::bounded, 2}, 1, 1.5, 1, 7) == Outcome::wrong);
    CHECK(judge({Outcome::exact, 0}, 1, 0, 0, 0) == Outcome::exact);
    CHECK(judge({Outcome::exact, 0}, 1, 0, 1e-300, 0) == Outcome::wrong);
    CHECK(judge({Outcome::exact, 0}, 1, 0, std::nan(""), 0) == Outcome::wrong);
    CHECK(judge({Outcome::grows, 0, 10}, 1, 0, std::exp(10.0), 0) == Outcome::grows);
    CHECK(judge({Outcome::grows, 0, 10}, 1, 0, std::exp(7.0), 0) == Outcome::wrong);
    CHECK(judge({Outcome::grows, 0, 10}, 1, 0, 1, 0) == Outcome::wrong);
    CHECK(judge({Outcome::reported, 0, 0, 5}, 1, 0, 0, 5) == Outcome::reported);
    CHECK(judge({Outcome::reported, 0, 0, 5}, 1, 0, 0, 6) == Outcome::wrong);
    CHECK(judge({Outcome::reported, 0, 0, 5}, 1, 0, 1, 0) == Outcome::wrong);
    Theory theory{Outcome::bounded, 2};
    theory.last_size = 0.5;
    CHECK(judge(theory, 1, 1.5, 0.4, 0) == Outcome::bounded);
    CHECK(judge(theory, 1, 1.5, 0.6, 0) == Outcome::wrong);
    theory = {Outcome::reported, 0, 0, 5};
    theory.earliest = 3;
    CHECK(judge(theory, 1, 0, 0, 3) == Outcome::reported);
    CHECK(judge(theory, 1, 0, 0, 2) == Outcome::wrong);
    CHECK(judge({Outcome::refused}, 1, 0, 0, 0) == Outcome::wrong);  // a run that was let in
}

TEST_CASE("a size that is no number is below no bound, though it be one at the end", "[ch6]") {
    const auto word = [](double from, double to) {
        return cell<Spring<double>>(
                   "", implicit_euler, [] { return Spring<double>(6); }, State<double>{0, 1, 0}, 1.0 / 64, 100,
                   {Outcome::bounded, 2},
                   [=](const State<double>& s) { return s.t < from || s.t > to ? 1 : std::nan(""); })
            .found;
    };
    CHECK(word(0, 2) == Outcome::wrong);
    CHECK(word(0.5, 0.6) == Outcome::wrong);
    CHECK(word(5, 6) == Outcome::bounded);
}
