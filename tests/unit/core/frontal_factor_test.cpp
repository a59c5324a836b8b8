#include "core/garment/frontal_factor.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <set>

using core::FrontalFactor;
using Matrix = FrontalFactor::Matrix;

namespace {

/// The lower triangle of a grid's Laplacian plus a little, with `extra` links between far places; scaled by `scale`.
Matrix grid_matrix(int n, int extra, double scale) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> any(0, n * n - 1);
    std::set<std::pair<int, int>> links;
    for (int i = 0; i < n * n; ++i) {
        if (i % n + 1 < n) links.emplace(i + 1, i);
        if (i + n < n * n) links.emplace(i + n, i);
    }
    for (int k = 0; k < extra; ++k) {
        const int a = any(random), b = any(random);
        if (a != b) links.emplace(std::max(a, b), std::min(a, b));
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n * n; ++i) entries.emplace_back(i, i, 0.1 * scale);
    for (const auto& [a, b] : links) {
        entries.emplace_back(a, b, -scale);
        entries.emplace_back(a, a, scale);
        entries.emplace_back(b, b, scale);
    }
    Matrix m(n * n, n * n);
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
}

double residual(FrontalFactor& factor, const Matrix& lower) {
    const FrontalFactor::Rows right = FrontalFactor::Rows::Random(lower.rows(), 3);
    FrontalFactor::Rows x = right;
    factor.solve(x);
    const FrontalFactor::Rows rest = lower.selfadjointView<Eigen::Lower>() * x - right;
    return rest.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("solutions fit for grids, with far links, and of one row", "[frontal_factor]") {
    for (const auto& [n, extra] : {std::pair(1, 0), std::pair(2, 0), std::pair(9, 0), std::pair(25, 40)}) {
        INFO(n << " " << extra);
        FrontalFactor factor;
        const Matrix one = grid_matrix(n, extra, 1.0), other = grid_matrix(n, extra, 3.5);
        factor.analyse(one);
        REQUIRE(factor.factorise(one));
        CHECK(residual(factor, one) < 1e-10);
        REQUIRE(factor.factorise(other));  // new values on the same pattern
        CHECK(residual(factor, other) < 1e-10);
    }
}

TEST_CASE("a matrix of two parts, and one that is not definite", "[frontal_factor]") {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < 6; ++i) entries.emplace_back(i, i, 2.0);
    entries.emplace_back(1, 0, -1.0);
    entries.emplace_back(5, 4, -1.0);
    Matrix parts(6, 6);
    parts.setFromTriplets(entries.begin(), entries.end());
    FrontalFactor factor;
    factor.analyse(parts);
    REQUIRE(factor.factorise(parts));
    CHECK(residual(factor, parts) < 1e-12);
    parts.coeffRef(5, 4) = -3.0;
    CHECK_FALSE(factor.factorise(parts));
}
