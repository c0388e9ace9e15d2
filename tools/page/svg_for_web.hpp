#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace page {

/// An image's size on the page, in CSS pixels.
struct ImageSize {
    int width, height;
};
/// Reads an SVG's width and height, or a GIF's, which is drawn at twice its size on the page.
/// Throws Error when the file tells none.
ImageSize image_size(const std::filesystem::path& path);

/// An animated GIF's first frame as a GIF of its own, for readers who asked for less motion.
/// Throws std::invalid_argument when the data are no whole GIF.
std::string first_frame(const std::string& gif);

/// The dark colour of each colour `#rrggbb`: tools/figures/dark.tsv. Throws Error.
std::map<std::string, std::string> load_dark_colours(const std::filesystem::path& file);

/// A figure as the pages show it: gnuplot's SVG, or a panel's, with a style that makes it dark where the page is dark,
/// and without points that lie on the line between their neighbours or words that gnuplot repeats. A map and the scale
/// beside it (an image and polygons) keep their colours. Throws std::invalid_argument for a colour without a dark one.
std::string svg_for_web(const std::string& figure, const std::map<std::string, std::string>& dark);

}  // namespace page
