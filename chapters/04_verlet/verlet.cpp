// Chapter 4: a rope whose points keep two positions and no velocity.
//
//   c++ -std=c++20 -O2 chapters/04_verlet/verlet.cpp -o rope && ./rope

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>

// Play with these.
const int links = 20;       // two metres of them
const double link = 0.1;    // m
const int sweeps = 20;      // iterations over all links in a step
const double h = 1.0 / 60;  // s
const int frames = 90;      // a second and a half
const int every = 15;       // frames from one picture to the next: a quarter of a second

struct Point {
    double x, y;            // where it is, m
    double x_then, y_then;  // where it was a step ago: that is its velocity
};

// Verlet: go on as far as in the last step, and h² a farther.
void fall(Point& p) {
    const double x = 2 * p.x - p.x_then;
    const double y = 2 * p.y - p.y_then - h * h * 9.81;
    p = {x, y, p.x, p.y};
}

// Both ends of a link share what is too long: its constraint, projected.
// A point that is moved has its velocity changed with it. Two points in one place have no direction and stay.
void put_right(Point& a, Point& b, bool a_is_held) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    if (length == 0) return;
    const double excess = (length - link) / length, share = a_is_held ? 0 : 0.5;
    a.x += share * excess * dx, a.y += share * excess * dy;
    b.x -= (1 - share) * excess * dx, b.y -= (1 - share) * excess * dy;
}

int main() {
    std::array<Point, links + 1> rope;
    for (int i = 0; i <= links; ++i) rope[i] = {i * link, 0, i * link, 0};  // held out level, at rest

    std::ofstream data("rope.dat");
    data << "# x y time\n";
    for (int frame = 0;; ++frame) {
        if (frame % every == 0 || frame == frames) {
            if (frame > 0) data << "\n\n";
            for (const Point& p : rope) data << p.x << ' ' << p.y << ' ' << frame * h << '\n';
        }
        if (frame == frames) break;
        for (int i = 1; i <= links; ++i) fall(rope[i]);  // the first one is held
        for (int n = 0; n < sweeps; ++n)
            for (int i = 1; i <= links; ++i) put_right(rope[i - 1], rope[i], i == 1);
    }

    double length = 0;
    for (int i = 1; i <= links; ++i) length += std::hypot(rope[i].x - rope[i - 1].x, rope[i].y - rope[i - 1].y);
    std::cout << "after " << frames * h << " s the rope is " << length << " m long, and should be " << links * link
              << "\n";
    if (!data.flush()) return std::cerr << "rope.dat: cannot be written\n", 2;
}
