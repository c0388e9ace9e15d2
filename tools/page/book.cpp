// book_of_pages: the site's written pages, one after the other, as one page to print.
//
// What a link of one of them leads to on another stands in the same file then; what is not in the book, a source
// or a page of the library, is no link there, as a printed book is read without the site.

#include "text.hpp"

#include <iostream>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

/// An attribute of a tag on `page`, with the blank before it, as the book has it.
std::string moved(const std::string& name, const std::string& value, const std::string& page,
                  const std::set<std::string>& pages) {
    const bool leaves = value.find(':') != std::string::npos;
    if (name == "id" || name == "name") return " " + name + "=\"" + page + "." + value + "\"";
    if (name == "src" || name == "srcset") return " " + name + "=\"" + (leaves ? value : "html/" + value) + "\"";
    if (name == "href") {
        if (leaves) return " href=\"" + value + "\"";
        const std::string file = value.substr(0, value.find('#'));
        const std::string to = file.empty() ? page : fs::path{file}.stem().string();
        if (pages.count(to) == 0) return {};
        return " href=\"#" + to +
               (value.find('#') == std::string::npos ? "" : "." + value.substr(value.find('#') + 1)) + "\"";
    }
    return {};  // loading, data-module: in a book nothing moves, and every picture is printed
}

std::string chapter_of_book(const fs::path& site, const std::string& page, const std::set<std::string>& pages,
                            std::string& title) {
    static const std::regex attribute{" (id|name|src|srcset|href|loading|data-module)=\"([^\"]*)\""};
    const std::string file = page + ".html", html = page::read_file(site / file);
    title = page::trim(page::between(html, "<div class=\"title\">", "</div>"));
    std::string text = page::between(html, "<div class=\"contents\">", "</div><!-- PageDoc -->"), book;
    if (title.empty() || text.empty()) throw page::Error{file, 1, "has no title, or no contents"};
    if (const auto toc = text.find("<div class=\"toc\">"); toc != std::string::npos)
        text.erase(toc, text.find("</div>", toc) + 6 - toc);
    text = page::replace_all(text, "<details", "<details open=\"\"");
    auto rest = text.cbegin();
    for (std::sregex_iterator each{text.cbegin(), text.cend(), attribute}, end; each != end; ++each) {
        book += each->prefix().str() + moved((*each)[1], (*each)[2], page, pages);
        rest = (*each)[0].second;
    }
    book.append(rest, text.cend());
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
