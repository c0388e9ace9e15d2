#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include "read_json.hpp"
#include <unistd.h>

#include "grades.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string line_of(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace) + "\n"; }

json heading(const std::string& edition) { return {{"edition", edition}}; }

// The whole lines of the file; one that was cut off does not count.
std::vector<json> read_lines(const fs::path& file) {
    std::vector<json> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line) && !stream.eof();) {
        json value = try_read_json(line);
        if (value.is_discarded() || !value.is_object()) break;
        lines.push_back(std::move(value));
    }
    return lines;
}

std::string key_of(const std::string& submission, const std::string& exercise, const std::string& mark) {
    return line_of({submission, exercise, mark});
}

}  // namespace

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
            const json& line = lines[i];
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
        } catch (const json::exception&) {  // written by nobody we know
        }
    write_whole(file, text);
    out_ = open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (out_ < 0) throw Stop(Status::bad_use, file.string() + ": cannot be written");
}

Journal::~Journal() { close(out_); }

const Grade* Journal::find(const std::string& submission, const std::string& exercise,
                           const std::string& answer) const {
    const std::string key = key_of(submission, exercise, mark_of(answer));
    const auto at = known_.find(key);
    if (at == known_.end()) return nullptr;
    if (at->second.could_not_be_checked() && failures_.at(key) < most_failures) return nullptr;
    return &at->second;
}

void Journal::keep(const Grade& grade, const std::string& answer) {
    const std::string line = line_of({{"submission", grade.submission},
                                      {"exercise", grade.exercise},
                                      {"text", mark_of(answer)},
                                      {"verdict", grade.verdict},
                                      {"says", grade.says},
                                      {"seed", grade.seed},
                                      {"seconds", grade.seconds}});
    if (write(out_, line.data(), line.size()) != static_cast<ssize_t>(line.size()) || fdatasync(out_) != 0)
        throw Stop(Status::bad_use, file_.string() + ": cannot be written (" + std::strerror(errno) + ")");
}

}  // namespace course
