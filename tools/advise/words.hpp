#pragma once
/// \file
/// The words of the adviser, from words.txt, which the build makes into code. Judgement is elsewhere.

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace timestep {

/// What stands in the place of each {name} of a text.
using Values = std::initializer_list<std::pair<std::string_view, std::string>>;

/// A section of words.txt: its name, what follows the name in its line, and its texts by their keys.
struct Section {
    std::string name, head;
    std::vector<std::pair<std::string, std::string>> texts;

    /// One of the texts, filled with `values`. Throws `std::logic_error` if there is no such text, or if it names a
    /// value that is not given.
    std::string text(std::string_view key, Values values) const;
};

/// All sections, in their order.
const std::vector<Section>& sections();

/// The text "section.key", filled with `values`. Throws `std::logic_error` as Section::text() does.
std::string phrase(std::string_view name, Values values = {});

}  // namespace timestep
