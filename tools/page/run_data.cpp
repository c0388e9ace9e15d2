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

/// A file of named records: the name, then the other fields.
std::map<std::string, std::vector<std::string>> RunData::records(const std::string& file, std::size_t fields) const {
    const std::filesystem::path path = existing(file);
    std::map<std::string, std::vector<std::string>> found;
    int line = 0;
    for (const std::string& text : split_lines(read_file(path))) {
        std::vector<std::string> record = split(text, '\t');
        if (++line == 1 && record.front() == "name") continue;
        if (record.size() != fields)
            throw Error{path.string(), line, "must have " + std::to_string(fields) + " fields with tabs between"};
        const std::string name = record.front();
        record.erase(record.begin());
        found[name] = record;
    }
    return found;
}

const Number& RunData::number(const std::string& name) {
    if (numbers_.empty()) {
        for (const auto& [key, fields] : records("numbers.tsv", 4)) numbers_[key] = {fields[0], fields[1], fields[2]};
    }
    const auto found = numbers_.find(name);
    if (found == numbers_.end()) {
        const std::string check = written_at(name, "check");
        throw std::out_of_range{"the run of " + chapter_ + " has no number \"" + name + "\"" +
                                (check.empty() ? "" : ", but a check of that name" + check)};
    }
    return found->second;
}

const std::string& RunData::check(const std::string& name) {
    if (checks_.empty()) {
        for (const auto& [key, fields] : records("checks.tsv", 2)) checks_[key] = fields[0];
    }
    const auto found = checks_.find(name);
    if (found == checks_.end()) {
        const std::string number = written_at(name, "number");
        throw std::out_of_range{"the run of " + chapter_ + " made no check \"" + name + "\"" +
                                (number.empty() ? "" : ", but has a number of that name" + number)};
    }
    return found->second;
}

std::string RunData::place_of(const std::string& name, const std::string& kind) const {
    if (!std::filesystem::exists(folder_ / "places.tsv")) return {};
    for (const std::string& line : split_lines(read_file(folder_ / "places.tsv"))) {
        const std::vector<std::string> cells = split(line, '\t');
        if (cells.size() == 3 && cells[0] == name && cells[1] == kind) return cells[2];
    }
    return {};
}

std::string RunData::written_at(const std::string& name, const std::string& kind) const {
    const std::string place = place_of(name, kind);
    return place.empty() ? "" : " (written at " + place + ")";
}

Table RunData::table(const std::string& file) const {
    const std::filesystem::path path = existing(file);
    Table table;
    int line = 0;
    for (const std::string& text : split_lines(read_file(path))) {
        const std::vector<std::string> cells = split(text, '\t');
        if (++line == 1) {
            table.columns = cells;
        } else if (!text.empty()) {  // a blank line only tells gnuplot to lift its pen
            if (cells.size() != table.columns.size())
                throw Error{path.string(), line, "has not as many cells as the first line" + written_at(file, "data")};
            table.rows.push_back(cells);
        }
    }
    if (table.rows.empty()) throw Error{path.string(), 1, "is a table without rows" + written_at(file, "data")};
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

std::string RunData::text(const std::string& file) const { return read_file(existing(file)); }

std::filesystem::path RunData::figure(const std::string& file) const { return existing(file); }

long RunData::milliseconds() const { return std::strtol(read_file(existing("seconds.txt")).c_str(), nullptr, 10); }

}  // namespace page
