#pragma once

#include <filesystem>
#include <string>
#include <string_view>

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
std::string first_frame(std::string_view gif);

}  // namespace page
