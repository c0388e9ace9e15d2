#pragma once
// The commands of a picture as an SVG file: what stands on the page where nothing can move.

#include <algorithm>
#include <fstream>
#include <string>

#include "live.hpp"

namespace live {

class Still {
public:
    Still(const Picture& picture, const Panel& panel)
        : picture_(picture), panel_(panel), height_(width_ * panel.aspect) {}

    std::string svg() {
        for (const double *at = picture_.commands(), *end = at + picture_.size(); at < end;) at = carry_out(at);
        unclip();
        const double height = key();
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width_) + "\" height=\"" + number(height) +
               "\" viewBox=\"0 0 " + number(width_) + " " + number(height) +
               "\" font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" height=\"100%\" "
               "fill=\"#fff\"/>\n" +
               svg_ + "</svg>\n";
    }

private:
    static std::string number(double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.5g", std::clamp(value, -1e5, 1e5));
        return text;
    }
    // Below the picture its key, which in the page the readouts are; unless the picture itself has the names. Returns
    // where it ends.
    double key() {
        const auto keyed = [](const Readout* readout) { return readout && is_look(readout->look); };
        int named = 0;
        for (const Readout* readout : panel_.readouts)
            named += keyed(readout) && texts_.find("\n" + std::string(readout->label) + "\n") != std::string::npos;
        double left = 16, bottom = height_;
        for (const Readout* readout : panel_.readouts) {
            if (!keyed(readout) || named > 1) continue;
            const std::string label = readout->label;
            const double length = 60 + 8 * static_cast<double>(label.size());
            if (bottom == height_ || left + length > width_) bottom += 24, left = 16;
            colour_ = look_of(readout->look).colour, dashes_ = look_of(readout->look).dashes;
            path_ = "M" + number(left) + " " + number(bottom - 12) + "h30", stroke_ = "3", strength_ = "1";
            path("none", colour_);
            text(left + 38, bottom - 7, label, "start", "#333333");
            left += length;
        }
        return bottom;
    }
    std::string word(double i) const { return picture_.said(static_cast<int>(i)); }
    std::string written(double i) const {
        std::string text;
        for (const char c : word(i)) text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
        return text;
    }
    double x(double at) const { return left_ + (at - from_x_) * scale_x_; }
    double y(double at) const { return bottom_ - (at - from_y_) * scale_y_; }
    std::string place(const double* at) const { return number(x(at[0])) + " " + number(y(at[1])); }

    void fit() {
        const double w = right_ - left_, h = bottom_ - top_;
        from_x_ = shown_[0], from_y_ = shown_[2];
        scale_x_ = w / (shown_[1] - shown_[0]), scale_y_ = h / (shown_[3] - shown_[2]);
        if (shown_[4] == 0) return;
        scale_x_ = scale_y_ = std::min(scale_x_, scale_y_);
        from_x_ -= (w / scale_x_ - (shown_[1] - shown_[0])) / 2;
        from_y_ -= (h / scale_y_ - (shown_[3] - shown_[2])) / 2;
    }

    // Nothing leaves its part of the picture.
    void clip() {
        unclip();
        const std::string name = "part" + number(++parts_);
        svg_ += "<clipPath id=\"" + name + "\"><rect x=\"" + number(left_) + "\" y=\"" + number(top_) + "\" width=\"" +
                number(right_ - left_) + "\" height=\"" + number(bottom_ - top_) +
                "\"/></clipPath>\n<g clip-path=\"url(#" + name + ")\">\n";
        clipped_ = true;
    }
    void unclip() {
        if (clipped_) svg_ += "</g>\n";
        clipped_ = false;
    }

    // One command, and where the next one begins. The numbers are those of Picture's functions.
    const double* carry_out(const double* at) {
        const double* a = at + 1;
        switch (static_cast<int>(*at)) {
            case 0:
                left_ = a[5] * width_ + 8, right_ = a[6] * width_ - 8;
                bottom_ = (1 - a[7]) * height_ - 8, top_ = (1 - a[8]) * height_ + 8;
                std::copy_n(a, 5, shown_);
                return fit(), clip(), at + 10;
            case 1:
                return unclip(), axes(a), clip(), at + 5;
            case 2:
                colour_ = look_of(word(a[0])).colour, dashes_ = look_of(word(a[0])).dashes;
                stroke_ = number(a[1]), strength_ = number(a[2]);
                return at + 4;
            case 3:
                if (!begun_) path_.clear();
                begun_ = true, path_ += "M" + place(a);
                return at + 3;
            case 4:
                path_ += "L" + place(a);
                return at + 3;
            case 5:
                path("none", colour_);
                return at + 1;
            case 6:
                path(colour_, "none");
                return at + 1;
            case 7:
                svg_ += "<circle cx=\"" + number(x(a[0])) + "\" cy=\"" + number(y(a[1])) + "\" r=\"" + number(a[2]) +
                        "\" fill=\"" + colour_ + "\" opacity=\"" + strength_ + "\"/>\n";
                return at + 4;
            default:
                text(x(a[0]), y(a[1]), written(a[2]), "start", colour_);
                texts_ += word(a[2]) + "\n";
                return at + 4;
        }
    }
    void path(const std::string& fill, const std::string& line) {
        const bool veil = strength_ != "1" && (fill == "#333333" || fill == "#ffffff");  // light or shadow on a body
        svg_ += std::string(veil ? "<path class=\"veil\"" : "<path") + " d=\"" + path_ + (fill == "none" ? "" : "Z") +
                "\" fill=\"" + fill + "\" stroke=\"" + line + "\" stroke-width=\"" + stroke_ + "\" opacity=\"" +
                strength_ + "\" stroke-linejoin=\"round\"" +
                (dashes_.empty() ? "" : " stroke-dasharray=\"" + dashes_ + "\"") + "/>\n";
        begun_ = false;  // it may be drawn once more, but the next move begins another
    }
    void text(double px, double py, const std::string& words, const std::string& anchor, const std::string& colour) {
        svg_ += "<text x=\"" + number(px) + "\" y=\"" + number(py) + "\" text-anchor=\"" + anchor + "\" fill=\"" +
                colour + "\">" + words + "</text>\n";
    }
    void tick_line(double x1, double y1, double x2, double y2, const char* colour) {
        svg_ += "<path d=\"M" + number(x1) + " " + number(y1) + "L" + number(x2) + " " + number(y2) + "\" stroke=\"" +
                colour + "\"/>\n";
    }
    // Ticks at 1, 2 or 5 times a power of ten; on a log axis at whole powers.
    static double gap(double range, bool log, double most) {
        double step = std::pow(10, std::floor(std::log10(range / 5)));
        const double many = range / step / most;
        step *= many > 5 ? 10 : many > 2.5 ? 5 : many > 1 ? 2 : 1;
        return log ? std::max(1.0, std::ceil(step)) : step;
    }
    // With a true minus sign; on a log axis the power of ten.
    static std::string tick(double at, double step, bool log) {
        static const char* const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
        std::string words = log ? "10" : "";
        for (const char c : number(std::fabs(at) < step / 1000 ? 0 : at))
            words += c == '-' ? (log ? "⁻" : "−") : log ? raised[c - '0'] : std::string(1, c);
        return words;
    }
    void axes(const double* a) {
        left_ += 48, right_ -= 8, bottom_ -= 38, top_ += 22;  // the words stand outside
        fit();
        const double right = from_x_ + (right_ - left_) / scale_x_, top = from_y_ + (bottom_ - top_) / scale_y_;
        const double dx = gap(right - from_x_, a[2] != 0, (right_ - left_) / 50);
        const double dy = gap(top - from_y_, a[3] != 0, (bottom_ - top_) / 30);
        for (double at = std::ceil(from_x_ / dx) * dx; at <= right + dx / 1000; at += dx) {
            tick_line(x(at), top_, x(at), bottom_, "#dddddd");
            text(x(at), bottom_ + 16, tick(at, dx, a[2] != 0), "middle", "#333333");
        }
        for (double at = std::ceil(from_y_ / dy) * dy; at <= top + dy / 1000; at += dy) {
            tick_line(left_, y(at), right_, y(at), "#dddddd");
            text(left_ - 5, y(at) + 5, tick(at, dy, a[3] != 0), "end", "#333333");
        }
        tick_line(left_, bottom_, right_, bottom_, "#333333");
        tick_line(left_, top_, left_, bottom_, "#333333");
        text((left_ + right_) / 2, bottom_ + 33, written(a[0]), "middle", "#333333");
        text(left_ - 40, top_ - 11, written(a[1]), "start", "#333333");
    }

    const Picture& picture_;
    const Panel& panel_;
    const double width_ = 640, height_;
    bool begun_ = false;        // is a path?
    std::string texts_ = "\n";  // all words in the picture
    std::string svg_, path_, colour_ = "#333333", dashes_, stroke_ = "2", strength_ = "1";
    double left_ = 0, right_ = 0, bottom_ = 0, top_ = 0;
    double from_x_ = 0, from_y_ = 0, scale_x_ = 1, scale_y_ = 1;
    double shown_[5] = {};
    int parts_ = 0;
    bool clipped_ = false;
};

inline bool write_still(const Picture& picture, const Panel& panel, const char* file) {
    std::ofstream out(file);
    out << Still(picture, panel).svg();
    return static_cast<bool>(out.flush());
}

}  // namespace live
