#include "claims.hpp"

#include "error.hpp"
#include "text.hpp"

#include <algorithm>

namespace page {
namespace {

/// Calls `take(fields, line)` for every line of a file of tab-separated fields.
template <class Take>
void for_each_record(const std::filesystem::path& file, std::size_t fields, Take take) {
    int number = 0;
    for (const std::string& line : split_lines(read_file(file))) {
        ++number;
        const std::vector<std::string> record = split(line, '\t');
        if (record.size() != fields || !is_row(record.front())) {
            throw Error{file.string(), number,
                        "must be a claim and " + std::to_string(fields - 1) + " more fields with tabs between"};
        }
        take(record, number);
    }
}

}  // namespace

std::map<std::string, TalkRow> load_talks(const std::filesystem::path& file) {
    std::map<std::string, TalkRow> talks;
    for_each_record(file, 5, [&](const std::vector<std::string>& record, int line) {
        if (record[2].empty()) {
            throw Error{file.string(), line, record[0] + " has no text"};
        }
        if (!talks.emplace(record[0], TalkRow{record[1], record[2], record[3], split_words(record[4]), line}).second) {
            throw Error{file.string(), line, record[0] + " stands here twice"};
        }
    });
    return talks;
}

std::vector<IndexEntry> load_indexes(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& entry : std::filesystem::directory_iterator{folder}) {
            if (entry.path().extension() == ".tsv") {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<IndexEntry> index;
    for (const std::filesystem::path& file : files) {
        for_each_record(file, 5, [&](const std::vector<std::string>& record, int) {
            index.push_back({record[0], record[1], record[2], record[3], record[4]});
        });
    }
    return index;
}

std::string index_lines(const std::vector<IndexEntry>& index) {
    std::string lines;
    for (const IndexEntry& entry : index) {
        lines += entry.row + "\t" + entry.kind + "\t" + entry.page + "\t" + entry.anchor + "\t" + entry.title + "\n";
    }
    return lines;
}

}  // namespace page
