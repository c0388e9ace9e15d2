// book_of_pages: the site's written pages, one after the other, as one page to print.
//
// What a link of one of them leads to on another stands in the same file then; what is not in the book, a source
// or a page of the library, is no link there, as a printed book is read without the site.

#include "text.hpp"

#include <iostream>
#include <set>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;

/// What stands between the first `begin` and the next `end`.
std::string between(const std::string& text, std::string_view begin, std::string_view end, const std::string& file) {
    const auto found = text.find(begin);
    const auto start = found + begin.size();
    const auto stop = found == std::string::npos ? found : text.find(end, start);
    if (stop == std::string::npos) throw page::Error{file, 1, "has no " + std::string{begin}};
    return text.substr(start, stop - start);
}

/// An attribute of a tag on `page`, with the blank before it, as it is in the book.
std::string moved(const std::string& name, const std::string& value, const std::string& page,
                  const std::set<std::string>& pages) {
    const bool leaves = value.find(':') != std::string::npos;
    if (name == "id" || name == "name") return " " + name + "=\"" + page + "." + value + "\"";
    if (name == "src" || name == "srcset") return " " + name + "=\"" + (leaves ? value : "html/" + value) + "\"";
    if (name == "href" && !leaves) {
        const std::string file = value.substr(0, value.find('#'));
        const std::string to = file.empty() ? page : fs::path{file}.stem().string();
        if (pages.count(to) == 0) return {};
        return " href=\"#" + to +
               (value.find('#') == std::string::npos ? "" : "." + value.substr(value.find('#') + 1)) + "\"";
    }
    // In a book nothing moves, and every picture is printed.
    return name == "loading" || name == "data-module" ? "" : " " + name + "=\"" + value + "\"";
}

std::string chapter_of_book(const fs::path& site, const std::string& page, const std::set<std::string>& pages,
                            std::string& title) {
    const std::string file = page + ".html", html = page::read_file(site / file);
    title = page::trim(between(html, "<div class=\"title\">", "</div>", file));
    std::string text = between(html, "<div class=\"contents\">", "</div><!-- PageDoc -->", file);
    if (const auto toc = text.find("<div class=\"toc\">"); toc != std::string::npos)
        text.erase(toc, text.find("</div>", toc) + 6 - toc);
    std::string book;
    for (std::size_t at = 0; at < text.size();) {
        const auto tag = text.find('<', at);
        const auto end = tag == std::string::npos ? tag : text.find('>', tag);
        if (end == std::string::npos) {
            book += text.substr(at);
            break;
        }
        book += text.substr(at, tag - at);
        std::string inside = text.substr(tag, end - tag);
        if (inside == "<details" || inside.starts_with("<details ")) inside.insert(8, " open=\"\"");
        for (std::size_t next = 0; next < inside.size();) {
            const auto equals = inside.find("=\"", next);
            const auto quote = equals == std::string::npos ? equals : inside.find('"', equals + 2);
            if (quote == std::string::npos) {
                book += inside.substr(next);
                break;
            }
            const auto blank = inside.rfind(' ', equals);
            book +=
                inside.substr(next, blank - next) + moved(inside.substr(blank + 1, equals - blank - 1),
                                                          inside.substr(equals + 2, quote - equals - 2), page, pages);
            next = quote + 1;
        }
        book += '>';
        at = end + 1;
    }
    return "<section class=\"page\" id=\"" + page + "\">\n<h1 class=\"title\">" + title + "</h1>\n" + book +
           "</section>\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: book_of_pages SITE/html BOOK.html PAGE...\n";
        return 2;
    }
    try {
        const fs::path site = argv[1];
        const std::vector<std::string> order(argv + 3, argv + argc);
        std::string chapters, contents, head;
        for (const std::string& page : order) {
            std::string title;
            chapters += chapter_of_book(site, page, {order.begin(), order.end()}, title);
            contents += "<li><a href=\"#" + page + "\">" + title + "</a></li>\n";
        }
        for (const char* style : {"doxygen.css", "doxygen-awesome.css", "timestep.css"}) {
            if (fs::exists(site / style))
                head += "<link rel=\"stylesheet\" href=\"html/" + std::string{style} + "\">\n";
        }
        page::write_file(
            argv[2],
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Timestep</title>\n" + head +
                "<script>const katexFolder = \"html/katex/\";</script>\n" +
                "<script defer src=\"html/timestep.js\"></script>\n</head>\n<body class=\"book\">\n" +
                "<div class=\"contents\">\n<h1 class=\"title\">Timestep</h1>\n<p>Numerical methods for game "
                "physics, by building them</p>\n<ul>\n" +
                contents + "</ul>\n" + chapters + "</div>\n</body>\n</html>\n");
        return 0;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
