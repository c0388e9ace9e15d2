#pragma once
// The scenes: each prints its table and adds its rows to the file of numbers.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "engine.hpp"

namespace engines {

inline constexpr double step = 1.0 / 60;  // s
inline constexpr double g = 9.81;         // m/s²

// One number a row: scene, case, engine, rule, what, value.
class Numbers {
public:
    void add(const std::string& scene, const std::string& which, const Engine& engine, const std::string& what,
             double value) {
        rows_.push_back({scene, which, engine.name, engine.rule, what, value});
    }
    struct Row {
        std::string scene, which, engine, rule, what;
        double value;
    };
    const std::vector<Row>& rows() const { return rows_; }

private:
    std::vector<Row> rows_;
};

// Numbers by chance, the same with every compiler (SplitMix64).
class Chance {
public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    double even() {  // from 0 to 1
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return double((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
    }
    template <class V>
    V direction(V v) {
        do
            for (auto& x : v) x = 2 * even() - 1;
        while (!(v.squaredNorm() <= 1 && v.squaredNorm() > 0.01));
        return v.normalized();
    }
    Vector direction() { return direction(Vector()); }
    Quaternion orientation() { return Quaternion(direction(Eigen::Vector4d())); }

private:
    std::uint64_t state_;
};

struct Effort {
    bool quick = false;
};

inline Vector in_body(const State& s) { return s.q.conjugate() * s.omega; }
inline double spin_energy(const Shape& shape, const State& s) {
    const Vector w = in_body(s);
    return w.dot(shape.moments.cwiseProduct(w)) / 2;
}
inline Vector momentum(const Shape& shape, const State& s) {
    return s.q * Vector(shape.moments.cwiseProduct(in_body(s)));
}

void fly(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers);
void spin_tops(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers);
void throw_bodies(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers);
void pile_up(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers);
void time_steps(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers);

// Leaves in `folder` what engines/in_your_engine.md shows: numbers.tsv and its tables.
void record(const std::filesystem::path& folder, const Numbers& numbers);

// "Box3D, 4 substeps  calm half-step, after   ": the first two columns of a table.
inline std::string row_name(const Engine& engine) {
    char text[64];
    std::snprintf(text, sizeof text, "%-18s%-30s", engine.name.c_str(), engine.rule.c_str());
    return text;
}

}  // namespace engines
