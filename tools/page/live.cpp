// Live panels: a picture that the chapter's own C++ moves, where the page can.

#include "directives.hpp"
#include "error.hpp"
#include "image.hpp"
#include "text.hpp"

#include <filesystem>
#include <stdexcept>

namespace page {

std::string live_markdown(Context& context, const Directive& directive, const std::string& caption) {
    if (directive.arguments.size() != 1 || trim(caption).empty()) {
        throw std::invalid_argument{"a live panel is {{live panel: caption}} or {{live 03_chapter/panel: caption}}"};
    }
    const std::string& reference = directive.arguments.front();
    const std::size_t slash = reference.find('/');
    if (slash == std::string::npos && context.chapter() == nullptr) {
        throw std::invalid_argument{"{{live " + reference +
                                    "}}: outside of a chapter a panel is named 03_chapter/panel"};
    }
    const std::string folder = slash == std::string::npos ? context.chapter()->folder : reference.substr(0, slash);
    const std::string name = reference.substr(slash + 1);  // npos + 1 is 0
    const std::string source = "chapters/" + folder + "/live/" + name + ".cpp";
    if (!std::filesystem::exists(context.root() / source)) {
        throw std::out_of_range{source + ": there is no such panel"};
    }
    const std::string anchor = "live-" + name;
    if (!context.anchors.insert(anchor).second) {
        throw std::out_of_range{name + " is shown twice on this page"};
    }
    const std::filesystem::path made = context.runs() / folder / "live";
    const std::filesystem::path still = made / (name + ".svg"), module = made / (name + ".wasm");
    if (!std::filesystem::exists(still) && context.draft) {
        ++context.gaps;
        return "\n<div class=\"gap\">(a live panel is to come here)</div>\n";
    }
    const std::string shown = folder + "/live_" + name;
    context.figures.emplace(shown + ".svg", still);
    context.inputs.insert(still);
    std::string attributes;
    if (std::filesystem::exists(module)) {  // else there is no compiler for it here, and the picture stands still
        context.figures.emplace(shown + ".wasm", module);
        context.inputs.insert(module);
        attributes = " data-live=\"" + folder + "/" + name + "\" data-module=\"figures/" + shown + ".wasm\"";
    }
    const ImageSize size = image_size(still);
    return "\n\\htmlonly[block]<figure id=\"" + anchor + "\" class=\"picture live\"" + attributes +
           " style=\"--width:" + std::to_string(size.width) + "px\"><a class=\"card\" href=\"figures/" + shown +
           ".svg\"><img src=\"figures/" + shown + ".svg\" alt=\"" + escape_html(first_sentence(caption)) +
           "\" width=\"" + std::to_string(size.width) + "\" height=\"" + std::to_string(size.height) +
           "\" loading=\"lazy\"></a><figcaption>\\endhtmlonly\n" + std::string{trim(caption)} + " (" +
           source_link(source, 1, "Its C++") + ".)" + "\n\\htmlonly[block]</figcaption></figure>\\endhtmlonly\n";
}

}  // namespace page
