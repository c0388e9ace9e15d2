// Figures as the pages show them: their sizes, light and dark, and in no more points than are seen.

#include "svg_for_web.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace page {
namespace {

// ---- GIF --------------------------------------------------------------------------------------------

unsigned byte_at(const std::string& data, std::size_t at) {
    if (at >= data.size()) throw std::invalid_argument{"is cut short"};
    return static_cast<unsigned char>(data[at]);
}

/// A colour table's bytes, from the flags that announce it.
std::size_t colour_table(unsigned flags) { return (flags & 0x80u) != 0 ? 3u << ((flags & 7u) + 1) : 0; }

/// Past a chain of data blocks: each tells its length, the last one is empty.
std::size_t after_blocks(const std::string& gif, std::size_t at) {
    while (byte_at(gif, at) != 0) at += byte_at(gif, at) + 1;
    return at + 1;
}

// ---- Colours ----------------------------------------------------------------------------------------

/// `rgb( 51,  51,  51)`, `black` and `#FFF` as `#rrggbb`; nothing for what is no colour, `none` and `currentColor`.
std::string as_hex(std::string colour) {
    unsigned red = 0, green = 0, blue = 0;
    if (std::sscanf(colour.c_str(), "rgb(%u,%u,%u)", &red, &green, &blue) == 3) {
        char text[8];
        std::snprintf(text, sizeof text, "#%02x%02x%02x", red & 255u, green & 255u, blue & 255u);
        return text;
    }
    for (char& c : colour) c = c >= 'A' && c <= 'F' ? static_cast<char>(c + 32) : c;
    if (colour.size() == 4 && colour[0] == '#')
        return {'#', colour[1], colour[1], colour[2], colour[2], colour[3], colour[3]};
    return colour == "black" ? "#000000" : colour == "lightgrey" ? "#d3d3d3" : colour[0] == '#' ? colour : "";
}

// ---- Lines ------------------------------------------------------------------------------------------

struct Point {
    double x, y;
};

/// To a tenth of a pixel.
std::string tenths(double value) {
    const long n = std::lround(10 * value);
    const std::string text = (n < 0 ? "-" : "") + std::to_string(std::labs(n) / 10);
    return n % 10 == 0 ? text : text + "." + std::to_string(std::labs(n) % 10);
}

double distance(Point p, Point a, Point b) {
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double along = square > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - along * x, p.y - a.y - along * y);
}

/// The points that matter (Douglas and Peucker): what is left out lies within a tenth of a pixel of the line.
void keep(const std::vector<Point>& line, std::size_t first, std::size_t last, std::vector<Point>& kept) {
    std::size_t farthest = first;
    double far = 0.1;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double off = distance(line[i], line[first], line[last]);
        if (off > far) far = off, farthest = i;
    }
    if (farthest != first) {
        keep(line, first, farthest, kept);
        keep(line, farthest, last, kept);
    } else if (last > first) {
        kept.push_back(line[last]);
    }
}

/// A path of gnuplot's lines, `M1.00,2.00 L3.00,4.00 …`, in fewer points; another one stays as it is.
std::string fewer_points(const std::string& data) {
    if (data.find_first_not_of("ML0123456789.,- \n\t") != std::string::npos || data.find(',') == std::string::npos)
        return data;
    std::string text;
    std::vector<Point> line;
    const auto finish = [&] {
        std::vector<Point> kept;
        if (line.size() > 1) {  // else it was only moved
            kept.push_back(line.front());
            keep(line, 0, line.size() - 1, kept);
        }
        for (std::size_t i = 0; i < kept.size(); ++i)
            text += (i == 0 ? "M" : i == 1 ? "L" : " ") + tenths(kept[i].x) + "," + tenths(kept[i].y);
        line.clear();
    };
    for (std::size_t at = data.find_first_of("ML"); at != std::string::npos; at = data.find_first_of("ML", at + 1)) {
        if (data[at] == 'M') finish();
        char* end = nullptr;
        const double x = std::strtod(data.data() + at + 1, &end);
        line.push_back({x, std::strtod(end + 1, nullptr)});
    }
    finish();
    return text;
}

/// gnuplot's figure without what it says again for every line: a third of the file. Groups without anything in them go,
/// and what all lines and letters have in common stands at the top alone.
std::string without_repetition(std::string svg) {
    static const std::string family = " font-family=\"Helvetica Neue,Helvetica,Arial,sans-serif\"",
                             ends = " stroke-linecap=\"round\" stroke-linejoin=\"round\"", empty = ">\n</g>\n";
    if (svg.find(ends) == std::string::npos) return svg;  // a panel's
    for (const auto& [from, to] : {std::pair{family, ""},
                                   {ends, ""},
                                   {" color=\"black\" stroke=\"currentColor\"", " stroke=\"black\""},
                                   {" class=\"gridline\" ", ""},
                                   {"\t", ""},
                                   {"\n\n", "\n"}})
        svg = replace_all(svg, from, to);
    std::string shorter;
    std::size_t done = 0;
    for (std::size_t at; (at = svg.find(empty, done)) != std::string::npos; done = at + empty.size()) {
        const std::size_t open = svg.rfind('<', at);
        const bool is_group = open >= done && svg.compare(open, 3, "<g ") == 0;
        shorter += is_group ? svg.substr(done, open - done) : svg.substr(done, at + empty.size() - done);
    }
    shorter += svg.substr(done);
    return shorter.insert(shorter.find("<svg") + 4, family + ends);
}

}  // namespace

ImageSize image_size(const std::filesystem::path& path) {
    const std::string data = read_file(path);
    ImageSize size{0, 0};
    if (path.extension() == ".svg") {
        const std::string tag = between(data, "<svg", ">");
        size = {std::atoi(between(tag, " width=\"", "\"").c_str()),
                std::atoi(between(tag, " height=\"", "\"").c_str())};
    } else if (path.extension() == ".gif" && data.starts_with("GIF") && data.size() > 10) {
        const auto pixels = [&](std::size_t at) {
            return static_cast<int>(byte_at(data, at) + 256 * byte_at(data, at + 1));
        };
        size = {pixels(6) / 2, pixels(8) / 2};
    }
    if (size.width <= 0 || size.height <= 0) throw Error{path.string(), 1, "is no SVG or GIF that tells its size"};
    return size;
}

std::string first_frame(const std::string& gif) {
    // Header (6 bytes), screen (7 bytes, the fifth announces a colour table), colour table.
    std::size_t at = 13 + colour_table(byte_at(gif, 10));
    std::string still = gif.substr(0, at);
    while (true) {
        const std::size_t begin = at;
        switch (byte_at(gif, at)) {
            case 0x21: {  // an extension: kept when it belongs to the picture (its transparency)
                const bool graphic = byte_at(gif, at + 1) == 0xf9;
                at = after_blocks(gif, at + 2);
                still += graphic ? gif.substr(begin, at - begin) : "";
                break;
            }
            case 0x2c:  // the picture: 10 bytes, its own colour table, the code size, the data
                at = after_blocks(gif, at + 11 + colour_table(byte_at(gif, at + 9)));
                return still + gif.substr(begin, at - begin) + '\x3b';
            default:
                throw std::invalid_argument{"has no picture in it"};
        }
    }
}

std::map<std::string, std::string> load_dark_colours(const std::filesystem::path& file) {
    std::map<std::string, std::string> dark;
    for (const std::string& line : split_lines(read_file(file))) {
        const std::vector<std::string> cells = split(line, '\t');
        if (cells.size() == 2 && !line.starts_with("# ")) dark[cells[0]] = cells[1];
    }
    return dark;
}

std::string svg_for_web(const std::string& figure, const std::map<std::string, std::string>& dark) {
    const std::string svg = without_repetition(figure);
    const std::size_t begin = svg.find("<svg"), head = svg.find('>', begin);
    if (begin == std::string::npos || svg.find("</svg>") == std::string::npos)
        throw std::invalid_argument{"is no whole SVG"};
    const bool map = svg.find("<image") != std::string::npos;
    static const std::string veil = "class=\"veil\"";  // light or shadow on a body of a panel: the same in the dark
    const std::string unless =
        std::string{map ? ":not(polygon)" : ""} + (svg.find(veil) != std::string::npos ? ":not(.veil)" : "");
    std::set<std::string> rules;
    std::string body;
    std::size_t done = head + 1, close = head;
    for (std::size_t open; (open = svg.find('<', close)) != std::string::npos;) {
        close = std::min(svg.find('>', open), svg.size());
        const std::string tag = svg.substr(open, close - open);
        const bool keeps_colours = (map && tag.starts_with("<polygon")) || tag.find(veil) != tag.npos;
        for (std::size_t equals = open; (equals = svg.find('=', equals + 1)) < close;) {
            const std::size_t quote = svg.find_first_of("'\"", equals), end = svg.find(svg[quote], quote + 1);
            const std::size_t before = svg.find_last_not_of(' ', equals - 1), blank = svg.find_last_of(" \n\t", before);
            const std::string attribute = svg.substr(blank + 1, before - blank);
            const std::string value = svg.substr(quote + 1, end - quote - 1);
            if (attribute == "d") {
                body += svg.substr(done, quote + 1 - done) + fewer_points(value);
                done = end;
            } else if (attribute == "stroke" || attribute == "fill" || attribute.ends_with("color")) {
                const std::string colour = keeps_colours ? "" : as_hex(value);
                if (const auto other = dark.find(colour); other != dark.end()) {
                    body += svg.substr(done, quote + 1 - done) + colour;
                    done = end;
                    if (other->second != colour)
                        rules.insert("[" + attribute + "=\"" + colour + "\"]" + unless + "{" + attribute + ":" +
                                     other->second + "}");
                } else if (!colour.empty()) {
                    throw std::invalid_argument{"has the colour " + colour +
                                                ", which tools/figures/dark.tsv does not name"};
                }
            }
            equals = end;
        }
    }
    std::string style;
    for (const std::string& rule : rules) style += rule;
    return svg.substr(begin, head + 1 - begin) + "<style>@media(prefers-color-scheme:dark){" + style + "}</style>" +
           body + svg.substr(done);
}

}  // namespace page
