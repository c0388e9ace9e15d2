// Figures for light and dark pages, in as few bytes as they need.

#include "svg_for_web.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <vector>

namespace page {
namespace {

constexpr std::string_view white = "#ffffff", ground = "#1c1d1f";  // as timestep.css has them
constexpr std::string_view on_paint = "#000001";
constexpr double least = 4.5, most = 6.5;  // contrast of colours on the dark ground; small words need 4.5

// ---- Colours (contrast as WCAG 2 has it) ------------------------------------------------------------

using Light = std::array<double, 3>;  // red, green and blue, as light adds up

Light light_of(std::string_view colour) {
    Light light{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double part = static_cast<double>(std::stoi(std::string{colour.substr(1 + 2 * i, 2)}, nullptr, 16)) / 255;
        light[i] = part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    }
    return light;
}

std::string hex(unsigned red, unsigned green, unsigned blue) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", red & 255u, green & 255u, blue & 255u);
    return text;
}

std::string colour_of(const Light& light) {
    std::array<unsigned, 3> parts{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double part = light[i] <= 0.0031308 ? 12.92 * light[i] : 1.055 * std::pow(light[i], 1 / 2.4) - 0.055;
        parts[i] = static_cast<unsigned>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    }
    return hex(parts[0], parts[1], parts[2]);
}

double luminance(const Light& light) { return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]; }

/// `rgb( 51,  51,  51)`, `black` and `#FFFFFF` as `#rrggbb`; what is no colour stays.
std::string as_hex(std::string_view colour) {
    std::array<unsigned, 3> parts{};
    if (std::sscanf(std::string{colour}.c_str(), "rgb(%u,%u,%u)", &parts[0], &parts[1], &parts[2]) == 3) {
        return hex(parts[0], parts[1], parts[2]);
    }
    std::string text{colour == "black"       ? "#000000"
                     : colour == "white"     ? "#ffffff"
                     : colour == "lightgrey" ? "#d3d3d3"
                                             : colour};
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c + 32) : c; });
    if (text.size() == 4 && text[0] == '#') {
        text = {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
    }
    return colour == "currentColor" ? std::string{colour} : text;
}

bool is_hex(std::string_view colour) {
    return colour.size() == 7 && colour[0] == '#' && std::all_of(colour.begin() + 1, colour.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
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
        if (off > far) {
            far = off;
            farthest = i;
        }
    }
    if (farthest != first) {
        keep(line, first, farthest, kept);
        keep(line, farthest, last, kept);
    } else if (last > first) {
        kept.push_back(line[last]);
    }
}

/// A path of whole lines, `M1.00,2.00 L3.00,4.00 …`; another one stays as it is.
std::string path(const std::string& data) {
    if (data.find_first_not_of("ML0123456789.,- \n\t") != std::string::npos || data.find(',') == std::string::npos) {
        return data;
    }
    std::string text;
    std::vector<Point> line;
    const auto finish = [&] {
        std::vector<Point> kept;
        if (line.size() > 1) {  // else it was only moved
            kept.push_back(line.front());
            keep(line, 0, line.size() - 1, kept);
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            text += (i == 0 ? "M" : i == 1 ? "L" : " ") + tenths(kept[i].x) + "," + tenths(kept[i].y);
        }
        line.clear();
    };
    for (std::size_t at = data.find_first_of("ML"); at != std::string::npos; at = data.find_first_of("ML", at + 1)) {
        if (data[at] == 'M') {
            finish();
        }
        char* end = nullptr;
        const double x = std::strtod(data.data() + at + 1, &end);
        if (*end != ',') {
            throw std::invalid_argument{"has a path with a point of one number"};
        }
        line.push_back({x, std::strtod(end + 1, nullptr)});
    }
    finish();
    return text;
}

/// Numbers with a point in them, to a tenth.
std::string rounded(const std::string& text) {
    std::string round;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_not_of("-0123456789.", at), text.size());
        const std::string number = text.substr(at, end - at);
        round += number.find('.') == std::string::npos ? number : tenths(std::strtod(number.c_str(), nullptr));
        round += end < text.size() ? text.substr(end, 1) : "";
        at = end + 1;
    }
    return std::string{trim(round)};
}

// ---- Tags -------------------------------------------------------------------------------------------

constexpr std::string_view font = "Helvetica Neue,Helvetica,Arial,sans-serif";             // as figure.gp has it
constexpr std::string_view round = " stroke-linecap=\"round\" stroke-linejoin=\"round\"";  // and its lines end so

/// Light or shadow on a body, in the still picture of a panel: a grey area that shines through.
bool is_veil(std::string_view inside) {
    const auto has = [&](std::string_view words) { return inside.find(words) != std::string_view::npos; };
    return (has(" fill=\"#333333\"") || has(" fill=\"#ffffff\"")) && has(" stroke=\"none\"") && has(" opacity=\"") &&
           !has(" opacity=\"1\"");
}

/// One tag with its attributes in short; `colours` gets each attribute that is a colour, as `stroke="#333333"`. A map
/// and the scale beside it (an image and polygons) keep their colours, on both grounds; so do veils.
std::string tag(std::string_view inside, std::set<std::string>& colours, bool map) {
    const std::string_view name = inside.substr(0, inside.find_first_of(" \n\t/"));
    const bool keeps_colours = map && name == "polygon", veil = is_veil(inside);
    std::string text{name};
    std::size_t at = name.size();
    for (std::size_t equals; (equals = inside.find('=', at)) != std::string_view::npos;) {
        const std::string_view attribute = trim(inside.substr(at, equals - at));
        const std::size_t open = inside.find_first_of("'\"", equals);
        const std::size_t close = open == std::string_view::npos ? open : inside.find(inside[open], open + 1);
        if (close == std::string_view::npos) {
            throw std::invalid_argument{"has an attribute without its end"};
        }
        std::string value{inside.substr(open + 1, close - open - 1)};
        at = close + 1;
        const bool of_all =
            name == "g" && attribute.starts_with("stroke-line") && value == "round";  // the first tag says so
        if (attribute == "class" || of_all || (attribute == "font-family" && value == font)) {
            continue;
        }
        if (attribute == "stroke" || attribute == "fill" || attribute == "color" || attribute == "flood-color") {
            value = keeps_colours                 ? value
                    : veil && attribute == "fill" ? (value == "#ffffff" ? "rgb(255,255,255)" : "rgb(51,51,51)")
                                                  : as_hex(value);
            if (is_hex(value)) {
                colours.insert(std::string{attribute} + "=\"" + value + "\"");
            }
        } else if (attribute == "d") {
            value = path(value);
        } else if (attribute == "points" || (name == "use" && attribute == "transform") ||
                   (name == "g" && attribute == "transform")) {
            value = rounded(value);
        }
        text += " " + std::string{attribute} + "=\"" + value + "\"";
    }
    return text + (inside.ends_with('/') ? "/" : "");
}

/// `[stroke="#333333"]{stroke:#cccccc}` for each colour that another one stands for in the dark.
std::string dark_style(const std::set<std::string>& colours) {
    std::string rules;
    for (const std::string& used : colours) {
        const std::string attribute = used.substr(0, used.find('=')), colour = used.substr(used.size() - 8, 7);
        const std::string dark = on_dark_ground(colour);
        if (dark != colour) {
            rules += "[" + used + "]{" + attribute + ":" + dark + "}";
        }
    }
    return "<style>@media(prefers-color-scheme:dark){" + rules + "}</style>";
}

/// Without the shapes of points that the figure does not use; some are made from those before them.
std::string without_unused_points(std::string text) {
    for (int n = 14; n >= 0; --n) {
        const std::string name = "gpPt" + std::to_string(n) + "\"";
        const std::size_t id = text.find(" id=\"" + name);
        if (id != std::string::npos && text.find("href=\"#" + name) == std::string::npos) {
            const std::size_t open = text.rfind('<', id), close = text.find("/>", id);
            text.erase(open, close + 2 - open);
        }
    }
    return text;
}

/// Without the groups that gnuplot leaves empty.
std::string without_empty_groups(std::string text) {
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t empty = text.find("></g>", at);
        kept += text.substr(at, empty - at);
        if (empty == std::string::npos) {
            break;
        }
        const std::size_t open = kept.rfind('<');
        if (kept.compare(open, 2, "<g") == 0) {
            kept.erase(open);
            at = empty + 5;
        } else {
            kept += '>';
            at = empty + 1;
        }
    }
    return kept;
}

}  // namespace

std::string on_dark_ground(std::string_view colour) {
    if (colour == on_paint) {
        return std::string{colour};
    }
    const Light light = light_of(colour);
    const double here = luminance(light), on_white = 1.05 / (here + 0.05), below = luminance(light_of(ground)) + 0.05;
    const bool grey = light[0] == light[1] && light[1] == light[2];
    if (grey) {
        if (colour == white) {
            return std::string{ground};
        }
        const double aim = std::min(on_white * below - 0.05, 0.85);
        return colour_of({aim, aim, aim});
    }
    // As much contrast as it has on white. Half of the light that this asks for is more of its own, half is white.
    const double aim = std::clamp(on_white, least, most) * below - 0.05;
    if (here >= aim) {
        return std::string{colour};
    }
    const double more = std::min((here + aim) / 2 / here, 1 / *std::max_element(light.begin(), light.end()));
    const double share = (aim - more * here) / (1 - more * here);
    Light mixed{};
    std::transform(light.begin(), light.end(), mixed.begin(),
                   [&](double part) { return more * part + share * (1 - more * part); });
    return colour_of(mixed);
}

std::string for_pages(std::string_view svg) {
    const std::size_t begin = svg.find("<svg");
    if (begin == std::string_view::npos || svg.find("</svg>") == std::string_view::npos) {
        throw std::invalid_argument{"is no whole SVG"};
    }
    const bool map = svg.find("<image") != std::string_view::npos;
    std::set<std::string> colours;
    std::string body, head;
    for (std::size_t at = begin; at < svg.size();) {
        const std::size_t open = svg.find('<', at), close = svg.find('>', std::min(open, svg.size()));
        const std::string_view between = svg.substr(at, open - at);
        body += trim(between).empty() ? std::string_view{} : between;
        if (close == std::string_view::npos) {
            break;
        }
        const std::string_view inside = svg.substr(open + 1, close - open - 1);
        if (head.empty()) {
            const bool gnuplot =
                svg.find("gnuplot_canvas") != std::string_view::npos;  // else a panel's, which says so itself
            head = "<" + tag(inside, colours, map) +
                   (gnuplot ? " font-family=\"" + std::string{font} + "\"" + std::string{round} : "") + ">";
        } else if (inside.starts_with("g>") || inside.starts_with('/') || inside.starts_with('!') ||
                   inside.starts_with('?')) {
            body += "<" + std::string{inside} + ">";
        } else {
            body += "<" + tag(inside, colours, map) + ">";
        }
        at = close + 1;
    }
    const std::size_t filters = body.find("<filter"), after = body.find("</defs>");
    if (filters < after && after != std::string::npos && body.find("filter=") == std::string::npos) {
        body.erase(filters, after - filters);
    }
    body = without_empty_groups(replace_all(without_unused_points(body), "<title>Gnuplot</title>", ""));
    return head + dark_style(colours) + body + "\n";
}

}  // namespace page
