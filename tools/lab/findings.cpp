// What a run found, and how it reaches the disk: every file whole.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "lab.hpp"

namespace lab {

namespace fs = std::filesystem;

namespace {

std::string join(const std::vector<std::string>& cells) {
    std::string line = cells.front();
    for (std::size_t i = 1; i < cells.size(); ++i) line += "\t" + cells[i];
    return line + "\n";
}

std::string formatted(double value, int digits) {
    char text[64];
    const bool whole = value == std::trunc(value) && std::fabs(value) < 1e7;
    if (whole)
        std::snprintf(text, sizeof text, "%.0f", value);
    else
        std::snprintf(text, sizeof text, "%.*g", digits, value);
    // 360, and not 3.6e+02.
    if (std::fabs(value) < 1e5 && std::string(text).find("e+") != std::string::npos)
        std::snprintf(text, sizeof text, "%.0f", std::strtod(text, nullptr));
    return text;
}

}  // namespace

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
    return "an unknown processor";
}

std::string compiler() {
#if defined(__clang__)
    return "clang " + std::to_string(__clang_major__);
#elif defined(__GNUC__)
    return "g++ " + std::to_string(__GNUC__);
#else
    return "an unknown compiler";
#endif
}

std::string id(const std::string& name) {
    std::string word;
    for (const char c : name) word += std::isalnum(static_cast<unsigned char>(c)) ? char(std::tolower(c)) : '_';
    return word;
}

Table::Table(std::string file, std::vector<std::string> columns)
    : file_(std::move(file)), columns_(columns.size()), text_(join(columns)) {}

void Table::row(std::vector<Cell> cells) {
    if (cells.size() != columns_) throw std::logic_error(file_ + ": a row with a missing cell");
    std::vector<std::string> words;
    for (const auto& cell : cells) {
        if (const auto* word = std::get_if<std::string>(&cell)) {
            words.push_back(*word);
        } else {
            char text[40];
            const double value = std::get<double>(cell);
            finite_ = finite_ && std::isfinite(value);
            std::snprintf(text, sizeof text, "%.12g", value);
            words.push_back(text);
        }
    }
    text_ += join(words);
}

void Findings::section(const std::string& title) {
    std::printf("\n%s\n%s\n", title.c_str(), std::string(title.size(), '-').c_str());
}

void Findings::add_number(const std::string& name, const std::string& value, const std::string& unit,
                          const std::string& meaning, Place from) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end())
        throw std::logic_error(name + ": a number of that name exists already");
    names_.push_back(name);
    numbers_ += join({name, value, unit, meaning});
    add_place("number", name, from);
}

// The place is seen from the course's folder: where that is on this machine is nobody's business.
void Findings::add_place(const char* kind, const std::string& name, Place from) {
    const std::string file = fs::path(from.file).generic_string();
    for (const char* room : {"chapters/", "tools/"})
        if (const auto at = file.rfind(room); at != std::string::npos) {
            places_ += join({name, kind, file.substr(at) + ":" + std::to_string(from.line)});
            return;
        }
    places_ += join({name, kind, fs::path(file).filename().string() + ":" + std::to_string(from.line)});
}

void Findings::number(const std::string& name, double value, const std::string& unit, const std::string& meaning,
                      int digits, Place from) {
    finite_ = finite_ && std::isfinite(value);
    add_number(name, formatted(value, digits), unit, meaning, from);
}

void Findings::text(const std::string& name, const std::string& words, const std::string& meaning, Place from) {
    add_number(name, words, "", meaning, from);
}

void Findings::check(const std::string& name, bool holds, const std::string& statement, Place from) {
    add_place("check", name, from);
    checks_ += join({name, statement});
    if (!holds) failed_.push_back(statement);
}

Table& Findings::table(const std::string& file, std::vector<std::string> columns, Place from) {
    add_place("data", file, from);
    return tables_.emplace_back(file, std::move(columns));
}

// The files are written into a folder of their own inside the target, whose name no other run has. When all of them are
// whole they are moved in, one by one. Moving takes no space, so a full disk changes nothing; a kill between two moves
// can leave old files beside new ones, each of them whole.
void Findings::save(const std::string& folder) const {
    const fs::path target(folder), staging = target / (".unfinished_" + std::to_string(std::random_device()()));
    std::error_code error;
    if (!fs::create_directories(staging, error)) throw std::runtime_error(folder + ": the folder cannot be written to");
    std::vector<std::pair<std::string, const std::string*>> files{
        {"numbers.tsv", &numbers_}, {"checks.tsv", &checks_}, {"places.tsv", &places_}};
    for (const auto& table : tables_) files.emplace_back(table.file(), &table.text());
    try {
        for (const auto& [name, text] : files) {
            std::ofstream file(staging / name, std::ios::binary);
            file << *text;
            file.close();
            if (!file) throw std::runtime_error((target / name).string() + ": cannot be written (is the disk full?)");
        }
        for (const auto& [name, text] : files) fs::rename(staging / name, target / name);
    } catch (...) {
        fs::remove_all(staging, error);
        throw;
    }
    fs::remove(staging, error);
}

}  // namespace lab
