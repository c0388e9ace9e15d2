#include "grades.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

std::string text_of(const ordered_json& value) {
    return value.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

double thousandths(double seconds) { return std::round(seconds * 1000) / 1000; }

std::string xml(const std::string& text) {
    std::string out = sanitized(text);
    for (const auto& [sign, name] : {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
        replace_all(out, sign, name);
    return out;
}

// A spreadsheet would run text that begins so as a formula: a quote goes before it, and before text that itself begins
// with that quote.
std::string csv(std::string text) {
    replace_all(text, "\"", "\"\"");
    return (text.find_first_of("=+-@'") == 0 ? "\"'" : "\"") + text + "\"";
}

std::string as_json(const std::vector<Grade>& grades) {
    ordered_json list = ordered_json::array();
    for (const Grade& grade : grades)
        list.push_back({{"submission", grade.submission},
                        {"exercise", grade.exercise},
                        {"verdict", grade.verdict},
                        {"says", grade.says},
                        {"seed", grade.seed},
                        {"seconds", thousandths(grade.seconds)}});
    return text_of(list);
}

// One row per submission, one column per exercise, for a spreadsheet.
std::string as_csv(const std::vector<Exercise>& exercises, const std::vector<Grade>& grades) {
    std::string text = "submission,passed,of";
    for (const Exercise& exercise : exercises) text += "," + exercise.name;
    for (std::size_t i = 0; i < grades.size(); i += exercises.size()) {
        std::size_t passed = 0;
        std::string row;
        for (std::size_t j = i; j < i + exercises.size(); ++j) {
            passed += grades[j].passed() ? 1 : 0;
            row += "," + grades[j].verdict;
        }
        text += "\n" + csv(grades[i].submission) + "," + std::to_string(passed) + "," +
                std::to_string(exercises.size()) + row;
    }
    return text + "\n";
}

std::string as_junit(const std::vector<Grade>& grades) {
    std::size_t failures = 0, errors = 0;
    std::ostringstream cases;
    for (const Grade& grade : grades) {
        const bool error = grade.verdict == "course_error";
        errors += error;
        failures += !error && !grade.passed();
        cases << "    <testcase classname=\"" << xml(grade.submission) << "\" name=\"" << grade.exercise << "\" time=\""
              << thousandths(grade.seconds) << "\"";
        if (grade.passed()) {
            cases << "/>\n";
            continue;
        }
        const char* const kind = error ? "error" : "failure";
        cases << ">\n      <" << kind << " type=\"" << grade.verdict << "\" message=\""
              << xml(grade.says.substr(0, grade.says.find('\n'))) << "\">" << xml(grade.says) << "</" << kind
              << ">\n    </testcase>\n";
    }
    std::ostringstream whole;
    whole << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
          << "  <testsuite name=\"timestep\" tests=\"" << grades.size() << "\" failures=\"" << failures
          << "\" errors=\"" << errors << "\">\n"
          << cases.str() << "  </testsuite>\n</testsuites>\n";
    return whole.str();
}

// One point per exercise.
std::string as_gradescope(const std::vector<Exercise>& exercises, const std::vector<Grade>& grades) {
    ordered_json tests = ordered_json::array();
    double seconds = 0;
    for (std::size_t i = 0; i < grades.size(); ++i) {
        seconds += grades[i].seconds;
        tests.push_back({{"number", exercises[i].place()},
                         {"name", exercises[i].name + ", " + exercises[i].title},
                         {"score", grades[i].passed() ? 1 : 0},
                         {"max_score", 1},
                         {"status", grades[i].passed() ? "passed" : "failed"},
                         {"output", grades[i].says},
                         {"output_format", "text"}});
    }
    ordered_json results{{"execution_time", std::ceil(seconds)}, {"tests", tests}};
    if (grades.empty()) {
        results["score"] = 0;
        results["output"] = "No file has the name of an exercise, like velocity_now.cpp.";
    }
    return text_of(results);
}

std::string line_of(const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json heading(const std::string& edition) { return {{"edition", edition}}; }

// The whole lines of the file; a line that was cut off does not count.
std::vector<ordered_json> read_lines(const fs::path& file) {
    std::vector<ordered_json> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line) && !stream.eof();) {
        auto value = ordered_json::parse(line, nullptr, false);
        if (value.is_discarded() || !value.is_object()) break;
        lines.push_back(std::move(value));
    }
    return lines;
}

std::string key_of(const std::string& submission, const std::string& exercise, const std::string& mark) {
    return line_of({submission, exercise, mark});
}

}  // namespace

void write_grades(const fs::path& folder, const std::vector<Exercise>& exercises, const std::vector<Grade>& grades,
                  bool single) {
    write_whole(folder / "grades.json", as_json(grades));
    write_whole(folder / "grades.csv", as_csv(exercises, grades));
    write_whole(folder / "junit.xml", as_junit(grades));
    const bool graded =
        std::none_of(grades.begin(), grades.end(), [](const Grade& grade) { return grade.verdict == "course_error"; });
    // No mark is given if the checker itself failed.
    if (single && graded) write_whole(folder / "results.json", as_gradescope(exercises, grades));
}

// FNV-1a.
std::string mark_of(const std::string& text) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return std::to_string(text.size()) + "_" + std::to_string(hash);
}

Journal::Journal(const fs::path& file, const std::string& edition) : file_(file) {
    auto lines = read_lines(file);
    const bool ours = !lines.empty() && lines[0] == heading(edition);
    std::string text = line_of(heading(edition));
    for (std::size_t i = 1; ours && i < lines.size(); ++i) try {
            const ordered_json& line = lines[i];
            const Grade grade{line.at("submission"),
                              line.at("exercise"),
                              line.at("verdict"),
                              line.at("says"),
                              line.at("seed"),
                              line.at("seconds"),
                              true};
            const std::string key = key_of(grade.submission, grade.exercise, line.at("text"));
            known_[key] = grade;
            if (grade.could_not_be_checked()) ++failures_[key];
            text += line_of(line);
        } catch (const ordered_json::exception&) {  // not a line of ours
        }
    write_whole(file, text);
    out_.open(file, std::ios::app);
}

const Grade* Journal::find(const std::string& submission, const std::string& exercise,
                           const std::string& answer) const {
    const std::string key = key_of(submission, exercise, mark_of(answer));
    const auto at = known_.find(key);
    if (at == known_.end()) return nullptr;
    if (at->second.could_not_be_checked() && failures_.at(key) < most_failures) return nullptr;
    return &at->second;
}

void Journal::keep(const Grade& grade, const std::string& answer) {
    out_ << line_of({{"submission", grade.submission},
                     {"exercise", grade.exercise},
                     {"text", mark_of(answer)},
                     {"verdict", grade.verdict},
                     {"says", grade.says},
                     {"seed", grade.seed},
                     {"seconds", grade.seconds}})
         << std::flush;
    if (!out_) throw Stop(Status::bad_use, file_.string() + ": cannot be written");
}

}  // namespace course
