// Chapter 5: a box spun about its intermediate axis, with the gyroscopic torque and without.
//
//   c++ -std=c++20 -O2 -Iinclude -I/usr/include/eigen3 chapters/05_gyroscopic/gyroscopic.cpp -o box && ./box

#include <cmath>
#include <fstream>
#include <iostream>

#include <Eigen/Dense>

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

// Play with these.
const Vector moments(13, 10, 5);  // kg m²: a box of 1 by 2 by 3 metres, 12 kg
const Vector spin(0.1, 7, 0.1);   // rad/s, in the axes of the box: the middle one, and a touch of the others
const double h = 1.0 / 60;        // s
const int seconds = 10;

const Matrix I = moments.asDiagonal();

// The matrix of a cross product: skew(a) b = a × b.
Matrix skew(const Vector& a) { return Matrix{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}}; }

// Implicit Euler asks for the ω₂ with I (ω₂ − ω₁) + h ω₂ × I ω₂ = 0. One iteration of Newton–Raphson from ω₁:
Vector gyroscopic_step(const Vector& w1) {
    const Vector f = h * w1.cross(I * w1);                   // how far ω₁ is from a root
    const Matrix J = I + h * (skew(w1) * I - skew(I * w1));  // how fast that changes with ω
    return w1 - J.inverse() * f;
}

double energy(const Vector& w) { return 0.5 * w.dot(I * w); }

int main() {
    std::ofstream data("tumble.dat");
    data << "# time x y z dropped\n";
    std::cout << "Without the torque: " << spin.y() << " rad/s about the intermediate axis, " << energy(spin)
              << " J, for ever.\nWith it:\ntime, s   spin about the intermediate axis, rad/s   energy, J\n";

    Vector w = spin;
    double told = 0;  // the next whole second, of which we are told
    for (int n = 0; n * h < seconds + h / 2; ++n) {
        const double t = n * h;
        data << t << ' ' << w.x() << ' ' << w.y() << ' ' << w.z() << ' ' << spin.y() << '\n';
        if (t > told - h / 2) {  // this step is the nearest to it
            std::cout << t << "   " << w.y() << "   " << energy(w) << '\n';
            told = std::floor(t + h / 2) + 1;
        }
        w = gyroscopic_step(w);
    }
    if (!data.flush()) return std::cerr << "tumble.dat: cannot be written\n", 2;
}
