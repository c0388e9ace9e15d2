#pragma once
// A square of cloth: masses on a grid, stiff springs between them, hung by two corners.

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

class Cloth {
public:
    using Vector3 = Eigen::Vector3d;
    using Matrix3 = Eigen::Matrix3d;
    using Vector = Eigen::VectorXd;
    using Sparse = Eigen::SparseMatrix<double>;

    struct Link {
        int a, b;       // the masses at its ends
        double length;  // at rest, m
    };

    // A square of 1 m² and 0.2 kg in n × n masses, `stiffness` in N/m, flat and at rest.
    Cloth(int n, double stiffness) : n_(n), stiffness_(stiffness), mass_(0.2 / (n * n)) {
        const double gap = 1.0 / (n - 1);
        x_.resize(3 * n * n), v_ = Vector::Zero(3 * n * n);
        for (int i = 0; i < n * n; ++i) x_.segment<3>(3 * i) << (i % n) * gap, (i / n) * gap, 0;
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                const int i = row * n + column;
                if (column + 1 < n) links_.push_back({i, i + 1, gap});
                if (row + 1 < n) links_.push_back({i, i + n, gap});
                if (column + 1 == n || row + 1 == n) continue;
                links_.push_back({i, i + n + 1, gap * std::sqrt(2.0)});
                links_.push_back({i + 1, i + n, gap * std::sqrt(2.0)});
            }
    }

    int size() const { return n_; }
    double mass() const { return mass_; }
    const std::vector<Link>& links() const { return links_; }
    const Vector& x() const { return x_; }
    const Vector& v() const { return v_; }
    Vector& x() { return x_; }
    Vector& v() { return v_; }
    bool held(int i) const { return i == 0 || i == n_ - 1; }

    // A flat grid whose columns move against their neighbours, one to the left, one to the right,
    // pulls each mass back with 8k: 2 links along the row are stretched by 2 each, 4 diagonal ones
    // pull with half of that, as they are slanted at both ends. No other pattern pulls harder.
    double fastest() const { return std::sqrt(8 * stiffness_ / mass_); }  // rad/s

    // Weight, and every link pulls its ends together: stiffness times what it is
    // too long.
    Vector force() const {
        Vector f = Vector::Zero(x_.size());
        for (int i = 0; i < n_ * n_; ++i) f(3 * i + 2) = -9.81 * mass_;
        for (const auto& [a, b, length] : links_) {
            const Vector3 apart = x_.segment<3>(3 * b) - x_.segment<3>(3 * a);
            const Vector3 pull = stiffness_ * (1 - length / apart.norm()) * apart;
            f.segment<3>(3 * a) += pull;
            f.segment<3>(3 * b) -= pull;
        }
        hold(f);
        return f;
    }

    // By how much a link pulls harder when its far end moves: with the whole stiffness
    // along it, across it as a taut string does. A slack link would push aside; that
    // is left out, so that the matrix has positive eigenvalues only (Baraff and
    // Witkin 1998).
    Matrix3 slope(const Link& link) const {
        const Vector3 apart = x_.segment<3>(3 * link.b) - x_.segment<3>(3 * link.a);
        const Vector3 along = apart.normalized();
        const double taut = std::max(0.0, 1 - link.length / apart.norm());
        const Matrix3 onto = along * along.transpose();
        return stiffness_ * (onto + taut * (Matrix3::Identity() - onto));
    }

    // What holds the two corners: whatever pulls them, they do not move.
    void hold(Vector& y) const {
        for (const int i : {0, n_ - 1}) y.segment<3>(3 * i).setZero();
    }

private:
    int n_;
    double stiffness_, mass_;
    std::vector<Link> links_;
    Vector x_, v_;
};

// Semi-implicit Euler: cheap, and stable while h ω < 2 for the fastest swing.
inline void step_explicit(Cloth& cloth, double h) {
    cloth.v() += h / cloth.mass() * cloth.force();
    cloth.x() += h * cloth.v();
}

// One step of implicit Euler, the force followed along its tangent: with K = −∂f/∂x
//     v₂ = v₁ + Δv,   (m + h² K) Δv = h (f − h K v₁),   x₂ = x₁ + h v₂.
// K times a vector needs the links only.
class Tangent {
public:
    using Vector = Cloth::Vector;

    Tangent(const Cloth& cloth, double h) : cloth_(cloth), h_(h) {
        slopes_.reserve(cloth.links().size());
        for (const auto& link : cloth.links()) slopes_.push_back(cloth.slope(link));
    }
    Vector k_times(const Vector& y) const {
        Vector result = Vector::Zero(y.size());
        for (std::size_t i = 0; i < slopes_.size(); ++i) {
            const auto& [a, b, length] = cloth_.links()[i];
            const Cloth::Vector3 apart = y.segment<3>(3 * b) - y.segment<3>(3 * a);
            const Cloth::Vector3 pull = slopes_[i] * apart;
            result.segment<3>(3 * a) -= pull;
            result.segment<3>(3 * b) += pull;
        }
        cloth_.hold(result);
        return result;
    }
    Vector times(const Vector& y) const { return cloth_.mass() * y + h_ * h_ * k_times(y); }
    Vector right_side() const { return h_ * (cloth_.force() - h_ * k_times(cloth_.v())); }
    const std::vector<Cloth::Matrix3>& slopes() const { return slopes_; }

private:
    const Cloth& cloth_;
    double h_;
    std::vector<Cloth::Matrix3> slopes_;
};

inline void move(Cloth& cloth, const Cloth::Vector& change, double h) {
    cloth.v() += change;
    cloth.x() += h * cloth.v();
}

/// [cg]
// Conjugate gradients (Hestenes and Stiefel 1952): no matrix, only its product
// with a vector. They end when what is left of the right side is `tolerance` of
// it. Returns the products taken.
inline int step_gradients(Cloth& cloth, double h, double tolerance) {
    const Tangent tangent(cloth, h);
    Cloth::Vector change = Cloth::Vector::Zero(cloth.v().size());
    Cloth::Vector left = tangent.right_side(), direction = left;
    double size = left.squaredNorm();
    const double enough = tolerance * tolerance * size;
    int products = 0;
    for (; size > enough && products < 10000; ++products) {
        const Cloth::Vector product = tangent.times(direction);
        const double along = size / direction.dot(product);
        change += along * direction;
        left -= along * product;
        const double smaller = left.squaredNorm();
        direction = left + smaller / size * direction;
        size = smaller;
    }
    move(cloth, change, h);
    return products;
}
/// [cg]

// The same step by Eigen's sparse Cholesky factors, L Lᵀ = m + h² K. Which numbers of the matrix
// are not zero never changes, so where they stand and the order of elimination is found once.
class Factorised {
public:
    explicit Factorised(const Cloth& cloth) : matrix_(cloth.x().size(), cloth.x().size()) {
        std::vector<Eigen::Triplet<double>> places;
        entries(cloth, Tangent(cloth, 1), 1,
                [&](int row, int column, double value) { places.emplace_back(row, column, value); });
        matrix_.setFromTriplets(places.begin(), places.end());
        for (const auto& place : places)
            where_.push_back(&matrix_.coeffRef(place.row(), place.col()) - matrix_.valuePtr());
        solver_.analyzePattern(matrix_);
    }
    /// [factorised]
    void step(Cloth& cloth, double h) {
        const Tangent tangent(cloth, h);
        fill(cloth, tangent, h);
        solver_.factorize(matrix_);
        move(cloth, solver_.solve(tangent.right_side()), h);
    }
    /// [factorised]
    const Cloth::Sparse& matrix() const { return matrix_; }
    // The numbers in L: what is computed, whatever their values.
    Eigen::Index size() const { return solver_.matrixL().nestedExpression().nonZeros(); }

private:
    void fill(const Cloth& cloth, const Tangent& tangent, double h) {
        matrix_.coeffs().setZero();
        auto place = where_.begin();
        entries(cloth, tangent, h, [&](int, int, double value) { matrix_.valuePtr()[*place++] += value; });
    }
    // The numbers on the diagonal and below it. A corner that is held has the row of m alone.
    template <class Add>
    static void entries(const Cloth& cloth, const Tangent& tangent, double h, const Add& add) {
        for (int i = 0; i < cloth.x().size(); ++i) add(i, i, cloth.mass());
        for (std::size_t i = 0; i < tangent.slopes().size(); ++i) {
            const auto& [a, b, length] = cloth.links()[i];
            const Cloth::Matrix3 block = h * h * tangent.slopes()[i];
            const bool held = cloth.held(a) || cloth.held(b);
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column <= row; ++column) {
                    if (!cloth.held(a)) add(3 * a + row, 3 * a + column, block(row, column));
                    if (!cloth.held(b)) add(3 * b + row, 3 * b + column, block(row, column));
                }
                for (int column = 0; column < 3 && !held; ++column)
                    add(3 * std::max(a, b) + row, 3 * std::min(a, b) + column, -block(row, column));
            }
        }
    }

    Cloth::Sparse matrix_;
    std::vector<Eigen::Index> where_;
    Eigen::SimplicialLLT<Cloth::Sparse> solver_;
};
