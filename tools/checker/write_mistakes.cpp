// Makes C++ of an exercise's mistakes, which stand as edits of a right answer:
//
//     write_mistakes NAME OUT SOLUTION CORRECT EDITS
//
// EDITS is mistakes.diff. Each mistake in it begins with a line
//
//     @@ its_name (from another)
//
// and has a line "Says: …", a line "Hint: …" (both may go on, indented), and the edits. Without "(from another)" they
// are edits of the course's SOLUTION; "another" is a right answer in CORRECT, or a mistake above. An edit is a run of
// whole lines: "-" is taken out, "+" is put in, "=" stays and only shows where. The old lines must stand once in the
// answer that is edited. "(anew)": no edit, the whole function stands there. Lines with "+" before the first mistake
// are for all of them.
//
// Writes into the folder OUT NAME_mistakes.hpp, one namespace for each, and a list of them; NAME_mistakes.json, what is
// said of each; and NAME_correct.hpp, a list of the right answers in CORRECT. Exit status 2, one line and no new file
// where something is wrong.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t least_mistakes = 4, least_correct = 2;

[[noreturn]] void refuse(const std::string& line) { throw std::invalid_argument(line); }

Lines lines_of(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) refuse(file + ": cannot be read");
    Lines lines;
    for (std::string line; std::getline(stream, line);) {
        line.erase(line.find_last_not_of(" \t\r") + 1);
        lines.push_back(line);
    }
    return lines;
}

Lines trimmed(Lines lines) {
    const auto empty = [](const std::string& line) { return line.empty(); };
    lines.erase(lines.begin(), std::find_if_not(lines.begin(), lines.end(), empty));
    lines.erase(std::find_if_not(lines.rbegin(), lines.rend(), empty).base(), lines.end());
    return lines;
}

struct Answer {
    std::string name;
    Lines code;
};

// What the learner hands in when everything is right: all below the task's comment and the includes.
Answer solution_in(const std::string& file) {
    Lines code;
    bool begun = false;
    for (const std::string& line : lines_of(file)) {
        const bool include = line.starts_with("#include");
        begun = begun || include;
        if (begun && !include && line.find("// [answer]") == std::string::npos) code.push_back(line);
    }
    return {"", trimmed(code)};
}

// Each right answer stands in a namespace of its own.
std::vector<Answer> correct_in(const std::string& file) {
    std::vector<Answer> all;
    std::string name;
    for (const std::string& line : lines_of(file)) {
        const std::string begins = "namespace ", ends = "}  // namespace " + name;
        if (name.empty() && line.starts_with(begins) && line.ends_with(" {")) {
            name = line.substr(begins.size(), line.size() - begins.size() - 2);
            all.push_back({name, {}});
        } else if (!name.empty() && line == ends) {
            all.back().code = trimmed(all.back().code);
            name.clear();
        } else if (!name.empty()) {
            all.back().code.push_back(line);
        }
    }
    if (all.size() < least_correct)
        refuse(file + ": must hold two right answers or more, written differently, each in a namespace of its own");
    return all;
}

struct Edit {
    int line;        // where it begins in the file of edits
    Lines old, now;  // with the lines that only show where
};

struct Mistake {
    std::string name, from, says, hint;
    bool anew = false;
    int line = 0;
    std::vector<Edit> edits;
};

struct Mistakes {
    Lines for_all;
    std::vector<Mistake> each;
};

bool is_name(const std::string& word) {
    return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) &&
           std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

Mistake begun(const std::string& line, const std::string& where) {
    Mistake mistake;
    std::string rest = line.substr(3);
    const auto bracket = rest.find(" (");
    mistake.name = rest.substr(0, bracket);
    if (bracket != std::string::npos) {
        const std::string base = rest.substr(bracket);
        mistake.anew = base == " (anew)";
        if (base.starts_with(" (from ") && base.ends_with(")")) mistake.from = base.substr(7, base.size() - 8);
        if (!mistake.anew && !is_name(mistake.from))
            refuse(where + ": behind the name may stand (from ANOTHER) or (anew), not" + base);
    }
    if (!is_name(mistake.name)) refuse(where + ": '" + mistake.name + "' is no name for a mistake");
    return mistake;
}

Mistakes mistakes_in(const std::string& file) {
    Mistakes all;
    std::string* words = nullptr;  // which may go on
    bool edit_ended = true, puts_in = false;
    int number = 0;
    for (const std::string& line : lines_of(file)) {
        const std::string where = file + ":" + std::to_string(++number);
        const char first = line.empty() ? '\0' : line[0];
        if (line.starts_with("@@ ")) {
            all.each.push_back(begun(line, where));
            all.each.back().line = number;
            words = nullptr, edit_ended = true;
        } else if (all.each.empty()) {
            if (first == '+') all.for_all.push_back(line.substr(1));
        } else if (Mistake& now = all.each.back(); line.starts_with("Says: ") || line.starts_with("Hint: ")) {
            words = line[0] == 'S' ? &now.says : &now.hint;
            *words = line.substr(6);
        } else if (words && line.starts_with("      ")) {
            *words += " " + line.substr(6);
        } else if (first == '-' || first == '+' || first == '=') {
            words = nullptr;
            // After lines that are put in, one that is there already belongs to the next edit.
            if (edit_ended || (puts_in && first != '+')) now.edits.push_back({number, {}, {}});
            edit_ended = false, puts_in = first == '+';
            if (first != '+') now.edits.back().old.push_back(line.substr(1));
            if (first != '-') now.edits.back().now.push_back(line.substr(1));
        } else if (line.empty()) {
            words = nullptr, edit_ended = true;
        } else {
            refuse(where + ": must begin with @@, Says:, Hint:, -, + or =");
        }
    }
    return all;
}

Lines edited(const Answer& base, const Mistake& mistake, const std::string& file) {
    Lines code;
    auto rest = base.code.begin();
    for (const Edit& edit : mistake.edits) {
        const std::string where = file + ":" + std::to_string(edit.line) + ": ";
        if (edit.old.empty())
            refuse(where + "no line says where these are put in: begin with a line that is there, after - or =");
        int found = 0;
        auto place = base.code.end();
        for (auto at = base.code.begin();
             (at = std::search(at, base.code.end(), edit.old.begin(), edit.old.end())) != base.code.end(); ++at)
            ++found, place = at;
        const std::string answer = base.name.empty() ? "the solution" : base.name;
        if (found != 1)
            refuse(where + "'" + edit.old.front() + "' must stand once in " + answer + ", and stands there " +
                   (found ? "more than once" : "not at all"));
        if (place < rest) refuse(where + "'" + edit.old.front() + "' stands above the edit before");
        code.insert(code.end(), rest, place);
        code.insert(code.end(), edit.now.begin(), edit.now.end());
        rest = place + static_cast<std::ptrdiff_t>(edit.old.size());
    }
    code.insert(code.end(), rest, base.code.end());
    return code;
}

// All of the mistakes' code, made before the first file is written.
std::vector<Answer> made(const Mistakes& all, std::vector<Answer> bases, const std::string& file) {
    if (all.each.size() < least_mistakes) refuse(file + ": must hold four mistakes or more");
    std::vector<Answer> code;
    std::set<std::string> said, names;
    for (const Mistake& mistake : all.each) {
        const std::string where = file + ":" + std::to_string(mistake.line) + ": " + mistake.name;
        const auto named = [&](const std::string& name) {
            return std::find_if(bases.rbegin(), bases.rend(), [&](const Answer& base) { return base.name == name; });
        };
        if (!names.insert(mistake.name).second) refuse(where + " is the name of another mistake, too");
        for (const auto& [key, words] : {std::pair{"Says", mistake.says}, std::pair{"Hint", mistake.hint}}) {
            if (words.empty()) refuse(where + " has no line '" + key + ": …'");
            if (!said.insert(words).second) refuse(where + ": its " + key + " is that of another mistake, too");
        }
        if (mistake.edits.empty()) refuse(where + " changes nothing");
        Answer answer{mistake.name, {}};
        if (mistake.anew) {
            for (const Edit& edit : mistake.edits) {
                if (!edit.old.empty()) refuse(where + " is written anew: all its lines begin with +");
                if (!answer.code.empty()) answer.code.push_back("");
                answer.code.insert(answer.code.end(), edit.now.begin(), edit.now.end());
            }
        } else {
            const auto base = named(mistake.from);
            if (base == bases.rend()) refuse(where + ": there is no answer '" + mistake.from + "' above it");
            answer.code = edited(*base, mistake, file);
        }
        bases.push_back(answer);
        code.push_back(answer);
    }
    return code;
}

void write(const std::string& file, const std::string& text) {
    std::ofstream stream(file);
    stream << text;
    stream.close();
    if (!stream) refuse(file + ": cannot be written");
}

void write_mistakes(const std::string& name, const std::string& out, const std::string& solution,
                    const std::string& correct, const std::string& edits) {
    std::vector<Answer> bases = correct_in(correct);
    std::string right =
        "// The right answers of correct.cpp.\nstatic const std::vector<std::pair<std::string, checker::Answer>> "
        "all{\n";
    for (const Answer& base : bases)
        right += "    {\"correct_" + base.name + "\", checker::answer_of(&" + base.name + "::" + name + ")},\n";
    bases.insert(bases.begin(), solution_in(solution));
    const Mistakes all = mistakes_in(edits);
    const std::vector<Answer> code = made(all, bases, edits);

    std::string header = "// From mistakes.diff.\n", list;
    std::ostringstream told;
    for (const std::string& line : all.for_all) header += line + "\n";
    for (const Answer& mistake : code) {
        header += "\nnamespace " + mistake.name + " {\n";
        for (const std::string& line : mistake.code) header += line + "\n";
        header += "}  // namespace " + mistake.name + "\n";
        list += "    {\"" + mistake.name + "\", checker::function_of(&" + mistake.name + "::" + name + ")},\n";
    }
    for (const Mistake& mistake : all.each)
        told << (&mistake == &all.each[0] ? "" : ",") << "\n  " << std::quoted(mistake.name)
             << ": {\"says\": " << std::quoted(mistake.says) << ", \"hint\": " << std::quoted(mistake.hint) << "}";
    header += "\nstatic const std::vector<checker::Mistake> all{\n" + list + "};\n";
    const std::string place = out + "/" + name;
    write(place + "_mistakes.hpp", header);
    write(place + "_mistakes.json", "{" + told.str() + "\n}\n");
    write(place + "_correct.hpp", right + "};\n");
}

}  // namespace

int main(int count, char** words) try {
    if (count != 6) refuse("takes NAME OUT SOLUTION CORRECT EDITS");
    write_mistakes(words[1], words[2], words[3], words[4], words[5]);
    return 0;
} catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "write_mistakes: %s\n", error.what());
    return 2;
}
