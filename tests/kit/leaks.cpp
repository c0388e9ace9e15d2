// Does a learner's edition hold anything of the tests or the solutions?
//
//     leaks SOURCE KIT
//
// Takes every line of the tests and of the solutions' answers that has 20 characters or more and is not also in a file
// that is handed out on purpose, and looks for it in every file of KIT: sources, programs, pages without their tags.
// Blanks do not count. Prints what it finds; exit status 0 for nothing, 1 for leaks, 2 for wrong use.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t shortest = 20;

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string without_blanks(const std::string& text) {
    std::string rest;
    std::copy_if(text.begin(), text.end(), std::back_inserter(rest),
                 [](char c) { return std::strchr(" \t\r\n\v\f", c) == nullptr || c == '\0'; });
    return rest;
}

// A page as it is read: no tags, and signs in place of their names.
std::string without_tags(const std::string& page) {
    static const std::vector<std::pair<std::string_view, char>> names{{"&lt;", '<'},   {"&gt;", '>'},  {"&quot;", '"'},
                                                                      {"&#39;", '\''}, {"&amp;", '&'}, {"&#160;", ' '},
                                                                      {"&nbsp;", ' '}};
    std::string text;
    for (std::size_t i = 0; i < page.size(); ++i) {
        const std::string_view rest = std::string_view(page).substr(i);
        const auto name =
            std::find_if(names.begin(), names.end(), [&](const auto& known) { return rest.starts_with(known.first); });
        const auto end = page[i] == '<' ? page.find('>', i) : std::string::npos;
        if (end != std::string::npos) {
            i = end;
        } else if (name != names.end()) {
            text += name->second;
            i += name->first.size() - 1;
        } else {
            text += page[i];
        }
    }
    return text;
}

// Lines of code and comments, each without blanks; of a check with what stands between its brackets
// once more, which is what Catch2 would leave in a program.
void add_lines(const std::string& text, std::set<std::string>& lines) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        line = without_blanks(line);
        lines.insert(line);
        const bool check = line.starts_with("REQUIRE") || line.starts_with("CHECK");
        if (const auto open = line.find('('); check && open != std::string::npos)
            lines.insert(line.substr(open + 1, line.rfind(')') - open - 1));
    }
}

// The lines of code in a list of edits. What is said of a mistake is told to learners.
std::string code_of_edits(const std::string& edits) {
    std::istringstream stream(edits);
    std::string code;
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with('+') || line.starts_with('-') || line.starts_with('=')) code += line.substr(1) + "\n";
    return code;
}

// What the learner is to find: from one line  // [answer]  to the next; the rest is the stub. The
// answer in one piece, too, since its lines may be short.
void take_apart(const std::string& solution, std::set<std::string>& answers, std::string& stub) {
    std::istringstream stream(solution);
    std::string answer;
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.find("// [answer]") != std::string::npos)
            inside = !inside;
        else
            (inside ? answer : stub) += line + "\n";
    }
    add_lines(answer, answers);
    answers.insert(without_blanks(answer));
}

template <class Do>
void for_each_file(const fs::path& folder, const Do& act) {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && !entry.is_symlink()) act(entry.path());
}

// The lines that nobody may find, by their first eight bytes.
class Secrets {
public:
    explicit Secrets(const fs::path& source) {
        std::set<std::string> lines;
        std::string open;
        for_each_file(source / "tests", [&](const fs::path& file) {
            if (file.filename() == "about.json")
                open += read(file);
            else if (file.extension() == ".diff")
                add_lines(code_of_edits(read(file)), lines);
            else
                add_lines(read(file), lines);
        });
        for_each_file(source / "solutions", [&](const fs::path& file) { take_apart(read(file), lines, open); });
        for (const auto& line : lines)
            if (line.size() >= shortest && !line.starts_with("#include<timestep/"))
                lines_[beginning(line.data())].insert(line);
        for (const char* folder : {"chapters", "docs", "engines", "include", "tools"})
            for_each_file(source / folder, [&](const fs::path& file) { open += read(file); });
        for (const char* file : {"CMakeLists.txt", "CMakePresets.json", "README.md", "course", "LICENSE"})
            open += read(source / file);
        for (const auto& line : found_in(without_blanks(open))) lines_[beginning(line.data())].erase(line);
    }
    std::size_t count() const {
        std::size_t sum = 0;
        for (const auto& [bytes, lines] : lines_) sum += lines.size();
        return sum;
    }

    /// Those in `text`, which has no blanks.
    std::set<std::string> found_in(std::string_view text) const {
        std::set<std::string> found;
        for (std::size_t i = 0; i + shortest <= text.size(); ++i) {
            const auto candidates = lines_.find(beginning(text.data() + i));
            if (candidates == lines_.end()) continue;
            for (const auto& line : candidates->second)
                if (text.substr(i).starts_with(line)) found.insert(line);
        }
        return found;
    }

private:
    static std::uint64_t beginning(const char* text) {
        std::uint64_t bytes;
        std::memcpy(&bytes, text, sizeof bytes);
        return bytes;
    }
    std::unordered_map<std::uint64_t, std::set<std::string>> lines_;
};

int look_for_leaks(const fs::path& source, const fs::path& kit) {
    const Secrets secrets(source);
    std::size_t files = 0, leaks = 0, bytes = 0;
    const auto complain = [&](const fs::path& file, const std::string& what) {
        std::cout << file.string() << ": " << what << '\n';
        ++leaks;
    };
    for_each_file(kit, [&](const fs::path& file) {
        const std::string text = read(file), ending = file.extension().string();
        ++files;
        bytes += text.size();
        if (ending == ".gz" || ending == ".tar" || ending == ".zip" || ending == ".xz")
            complain(file, "is packed, so that nobody can look into it");
        auto found = secrets.found_in(without_blanks(text));
        if (ending == ".html" || ending == ".js") found.merge(secrets.found_in(without_blanks(without_tags(text))));
        if (!found.empty()) complain(file, std::to_string(found.size()) + " lines: " + *found.begin());
    });
    std::cout << secrets.count() << " lines looked for in " << files << " files of " << (bytes + 500'000) / 1'000'000
              << " MB: " << leaks << " files leak\n";
    if (secrets.count() == 0 || files == 0) complain(kit, "nothing to look for, or nowhere to look");
    return leaks > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: leaks SOURCE KIT\n";
        return 2;
    }
    try {
        return look_for_leaks(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::cerr << "leaks: " << error.what() << '\n';
        return 2;
    }
}
