// Pictures: their size on the page, and the first frame of an animation.
#include "course.hpp"
#include "error.hpp"
#include "image.hpp"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("an SVG tells its size; a GIF is drawn at twice its size on the page") {
    const Course course;
    const page::ImageSize svg = page::image_size(course / "runs/03_springs/run/spiral.svg");
    CHECK(svg.width == 640);
    CHECK(svg.height == 480);
    const page::ImageSize gif = page::image_size(course / "runs/03_springs/run/sweep.gif");
    CHECK(gif.width == 2);
    CHECK(gif.height == 1);
}

TEST_CASE("a picture without a size is an error") {
    const Course course;
    course.write("a.svg", "<svg stroke-width=\"3\" viewBox=\"0 0 1 1\"></svg>");
    CHECK_THROWS_AS(page::image_size(course / "a.svg"), page::Error);
    course.write("a.gif", "no GIF at all");
    CHECK_THROWS_AS(page::image_size(course / "a.gif"), page::Error);
    course.write("a.png", "\x89PNG");
    CHECK_THROWS_AS(page::image_size(course / "a.png"), page::Error);
}

TEST_CASE("the first frame is a whole GIF without the rest of the animation") {
    const Course course;
    const std::string gif = course.read("runs/03_springs/run/sweep.gif");
    const std::string still = page::first_frame(gif);
    // Header, screen and colours (19 bytes), one frame (23 bytes), the end.
    CHECK(still.size() == 19 + 23 + 1);
    CHECK(still.starts_with("GIF89a"));
    CHECK(still.back() == '\x3b');
    CHECK(still.find("NETSCAPE") == std::string::npos);
    CHECK(page::first_frame(still) == still);
}

TEST_CASE("a GIF that ends too early, or has no picture, is refused") {
    const Course course;
    const std::string gif = course.read("runs/03_springs/run/sweep.gif");
    for (const std::size_t length : {0u, 5u, 12u, 30u, 50u}) {
        CHECK_THROWS_AS(page::first_frame(gif.substr(0, length)), std::invalid_argument);
    }
    CHECK_THROWS_AS(page::first_frame(gif.substr(0, 38) + "\x3b"), std::invalid_argument);
}
