#include "run_data.hpp"

#include "text.hpp"

#include <cstdlib>
#include <stdexcept>

namespace page {

RunData::RunData(std::string chapter, std::filesystem::path folder)
    : chapter_{std::move(chapter)}, folder_{std::move(folder)} {}

std::filesystem::path RunData::existing(const std::string& file) const {
    const std::filesystem::path path = folder_ / file;
    if (!std::filesystem::is_regular_file(path)) {
        const std::string words = "the run of " + chapter_ + " left no " + file;
        if (std::filesystem::exists(folder_ / "done")) throw std::out_of_range{words};
        throw NotYet{words};
    }
    return path;
}

const std::vector<std::string>* RunData::find_record(const std::string& file, std::size_t cells,
                                                     const std::string& name) {
    auto& records = records_[file];
    if (records.empty()) {
        for (const auto& [row, line] : rows_of(existing(file), cells))
            if (row[0] != "name") records[row[0]] = row;
    }
    const auto found = records.find(name);
    return found == records.end() ? nullptr : &found->second;
}

Number RunData::number(const std::string& name) {
    if (const auto* cells = find_record("numbers.tsv", 4, name)) return {(*cells)[1], (*cells)[2], (*cells)[3]};
    const std::string check = written_at(name, "check");
    throw std::out_of_range{"the run of " + chapter_ + " has no number \"" + name + "\"" +
                            (check.empty() ? "" : ", but a check of that name" + check)};
}

std::string RunData::check(const std::string& name) {
    if (const auto* cells = find_record("checks.tsv", 2, name)) return (*cells)[1];
    const std::string number = written_at(name, "number");
    throw std::out_of_range{"the run of " + chapter_ + " made no check \"" + name + "\"" +
                            (number.empty() ? "" : ", but has a number of that name" + number)};
}

std::string RunData::place_of(const std::string& name, const std::string& kind) const {
    if (!std::filesystem::exists(folder_ / "places.tsv")) return {};
    for (const auto& [cells, line] : rows_of(folder_ / "places.tsv", 3))
        if (cells[0] == name && cells[1] == kind) return cells[2];
    return {};
}

std::string RunData::written_at(const std::string& name, const std::string& kind) const {
    const std::string place = place_of(name, kind);
    return place.empty() ? "" : " (written at " + place + ")";
}

Table RunData::table(const std::string& file) const {
    const std::filesystem::path path = existing(file);
    Table table;
    for (const auto& [cells, line] : rows_of(path)) table.push_back(cells);
    if (table.size() < 2) throw Error{path.string(), 1, "is a table without rows" + written_at(file, "data")};
    return table;
}

std::string RunData::printed(const std::string& heading) const {
    if (heading.empty()) return read_file(existing("program.txt"));
    const std::string whole = read_file(existing("run.txt"));
    // A heading is a line with dashes below it.
    const std::vector<std::string> lines = split_lines(whole);
    const auto is_heading = [&](std::size_t i) {
        return i + 1 < lines.size() && lines[i + 1].size() >= 3 &&
               lines[i + 1].find_first_not_of('-') == std::string::npos;
    };
    std::string part;
    bool inside = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_heading(i)) inside = lines[i] == heading;
        if (inside) part += lines[i] + "\n";
    }
    if (part.empty()) throw std::out_of_range{"the run of " + chapter_ + " prints no heading \"" + heading + "\""};
    return part;
}

long RunData::milliseconds() const { return std::strtol(read_file(existing("seconds.txt")).c_str(), nullptr, 10); }

}  // namespace page
