#include "diagram.hpp"

#include <cstdio>
#include <map>
#include <sstream>

#include "files.hpp"
#include "lab.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace bench {

namespace fs = std::filesystem;

namespace {

// A text between single quotes, for gnuplot.
std::string quoted(const std::string& text) {
    std::string words = "'";
    for (const char c : text) words += c == '\'' ? std::string("''") : std::string(1, c);
    return words + "'";
}

bool same_entry(const contest::Point& a, const contest::Point& b) {
    return a.method == b.method && a.library == b.library;
}

// One line per entry: ours as in all figures, each other library in a colour of its own.
std::string script(const fs::path& csv, const fs::path& svg, const std::string& title,
                   const std::vector<contest::Point>& points) {
    const char* const colours[] = {"#666666", "#cc79a7", "#4c72b0", "#8172b3", "#937860", "#64b5cd"};
    std::ostringstream text;
    text << "style = " << quoted(BENCH_STYLE) << "\nload style\n"
         << "call figure " << quoted(svg.string()) << " 980 640\n"
         << "set datafile separator comma\n"
         << "set rmargin screen 0.66\nset key at screen 0.68,0.97 left top reverse Left noenhanced "
            "maxrows 40 font ',12' spacing 0.9 samplen 3\n"
         << "set title " << quoted(title) << " noenhanced\n"
         << "set logscale xy\nset format '10^{%L}'\nset yrange [1e-17:200]\n"
         << "set xlabel 'time of a run (s)'\nset ylabel 'largest error, as a share of the scene'\n";
    std::string plots;
    std::map<std::string, std::size_t> libraries;
    int entries = 0;
    for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
        const auto& p = points[first];
        while (end < points.size() && same_entry(p, points[end])) ++end;
        const bool ours = p.library == "Timestep";
        const std::string look = "look" + std::to_string(entries++);
        const std::string name = lab::id(p.method);
        const auto library = libraries.emplace(p.library, libraries.size()).first->second;
        text << look << " = " << (ours ? "exists(\"" + name + "\") ? value(\"" + name + "\") : " : "") << "\"lc rgb '"
             << colours[(ours ? std::size_t(entries) : library) % 6] << "' lw 1.2 dt " << (ours ? "1" : "(6,3)")
             << "\"\n";
        // Row 0 holds the names of the columns. Diverged runs lie at the upper edge; an error of zero has no logarithm.
        plots += (plots.empty() ? "plot " : ", \\\n  ") + quoted(csv.string()) +
                 " every ::" + std::to_string(first + 1) + "::" + std::to_string(end) +
                 " using 7:(strcol(10) eq 'true' ? 100 : $6 > 1e-16 ? $6 : 1e-16) with linespoints @" + look + " pt " +
                 std::to_string(ours ? 7 : 4 + entries % 10) + " ps 0.5 title " +
                 quoted(ours ? p.method : p.method + ", " + p.library);
    }
    text << plots << "\n";
    return text.str();
}

}  // namespace

// The figure is drawn beside its place and moved there once it is whole.
bool draw(const fs::path& csv, const std::string& title, const std::vector<contest::Point>& points) {
    const fs::path svg = fs::path(csv).replace_extension(".svg");
    const course::UnfinishedFolder folder(csv.parent_path());
    const fs::path commands = folder.path() / "commands.gp", fresh = folder.path() / "fresh.svg";
    course::write_whole(commands, script(csv, fresh, title, points));
    std::string said;
    const int status =
        course::listen({"gnuplot", "-d", commands.string()}, [&](std::string_view text) { said += text; });
    std::error_code error;
    if (status == 0) fs::rename(fresh, svg, error);
    if (status == 127) return false;
    if (status == 0 && !error) return true;
    std::fprintf(stderr, "%s", said.c_str());
    throw course::Stop(course::Status::bad_use, svg.string() + ": could not be drawn");
}

}  // namespace bench
