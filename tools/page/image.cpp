#include "image.hpp"

#include "error.hpp"
#include "text.hpp"

#include <cstdlib>
#include <stdexcept>

namespace page {
namespace {

unsigned byte_at(std::string_view data, std::size_t at) {
    if (at >= data.size()) {
        throw std::invalid_argument{"is cut short"};
    }
    return static_cast<unsigned char>(data[at]);
}

/// A colour table's bytes, from the flags that announce it.
std::size_t colour_table(unsigned flags) { return (flags & 0x80u) != 0 ? 3u << ((flags & 7u) + 1) : 0; }

/// Past a chain of data blocks: each tells its length, the last one is empty.
std::size_t after_blocks(std::string_view gif, std::size_t at) {
    while (byte_at(gif, at) != 0) {
        at += byte_at(gif, at) + 1;
    }
    return at + 1;
}

/// `name="640"` in an SVG's first tag.
int svg_length(std::string_view tag, std::string_view name) {
    const std::size_t at = tag.find(name);
    return at == std::string_view::npos ? 0 : std::atoi(tag.data() + at + name.size());
}

}  // namespace

ImageSize image_size(const std::filesystem::path& path) {
    const std::string data = read_file(path);
    ImageSize size{0, 0};
    if (path.extension() == ".svg") {
        const std::size_t tag = data.find("<svg");
        if (tag != std::string::npos) {
            const std::string first = data.substr(tag, data.find('>', tag) - tag);
            size = {svg_length(first, " width=\""), svg_length(first, " height=\"")};
        }
    } else if (path.extension() == ".gif" && data.starts_with("GIF") && data.size() > 10) {
        const auto pixels = [&](std::size_t at) {
            return static_cast<int>(byte_at(data, at) + 256 * byte_at(data, at + 1));
        };
        size = {pixels(6) / 2, pixels(8) / 2};
    }
    if (size.width <= 0 || size.height <= 0) {
        throw Error{path.string(), 1, "is no SVG or GIF that tells its size"};
    }
    return size;
}

std::string first_frame(std::string_view gif) {
    // Header (6 bytes), screen (7 bytes, the fifth announces a colour table), colour table.
    std::size_t at = 13 + colour_table(byte_at(gif, 10));
    std::string still{gif.substr(0, at)};
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
                still += gif.substr(begin, at - begin);
                return still + '\x3b';
            default:
                throw std::invalid_argument{"has no picture in it"};
        }
    }
}

}  // namespace page
