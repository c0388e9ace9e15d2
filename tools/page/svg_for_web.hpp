#pragma once

#include <string>
#include <string_view>

namespace page {

/// A colour `#rrggbb` as it is drawn on the dark ground: greys keep the contrast that they have on white, colours keep
/// their hue and get as much light as they need to be read. `#000001` is a word on a painted cell, and stays black.
std::string on_dark_ground(std::string_view colour);

/// A figure as the pages show it: gnuplot's SVG with a style that makes it dark where the page is dark, and without
/// what no eye sees: empty groups, the hundredths of a pixel, points that lie on the line between their neighbours.
std::string for_pages(std::string_view svg);

}  // namespace page
