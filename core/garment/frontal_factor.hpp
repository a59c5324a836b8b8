#pragma once
// Cholesky factors of a sparse symmetric matrix whose pattern stays while its values change, with dense arithmetic.
//
// The multifrontal method (I. Duff and J. Reid, The multifrontal solution of indefinite sparse symmetric linear
// systems, 1983; J. Liu's survey, 1992): columns with like structure are eliminated together in a small dense matrix, a
// front, and what they change of the rest is passed up the elimination tree. Eigen's own simplicial factorisation does
// the same work an entry at a time; on cloth of 10,000 vertices this takes less than half of its time.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace core {

class FrontalFactor {
  public:
    using Matrix = Eigen::SparseMatrix<double>;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

    /// Orders and plans for the pattern of `lower`, the lower triangle of a symmetric matrix, every diagonal entry
    /// present. Values do not matter.
    void analyse(const Matrix& lower);

    /// For values on the pattern analysed. False when the matrix is not positive definite; then solve must not be used.
    [[nodiscard]] bool factorise(const Matrix& lower);

    /// Replaces three right hand sides by their solutions.
    void solve(Rows& right);

  private:
    /// Columns first … first + columns - 1 of the ordered matrix, and the rows of their factor.
    struct Front {
        int first = 0, columns = 0, parent = -1;
        std::vector<int> rows;         // ordered numbers, ascending; the front's own columns come first
        std::vector<int> in_parent;    // of the rows below the own columns: their places among the parent's rows
        std::size_t panel = 0;         // where its part of the factor begins, rows.size() x columns
        std::size_t entries = 0, end;  // its entries of the matrix in sources_ and targets_
    };
    void make_fronts(const std::vector<std::vector<int>>& below, const std::vector<int>& parent);
    void place_entries(const Matrix& lower);

    std::vector<int> place_of_;  // of each row of the matrix: its number in the order
    std::vector<int> front_of_;  // of each ordered column
    std::vector<Front> fronts_;
    std::vector<std::size_t> sources_, targets_;  // an entry of the matrix goes to a place of its front
    std::vector<double> panels_, work_;
    std::vector<std::vector<double>> updates_;  // of each front, until its parent took it
    Rows moved_;
    std::vector<std::vector<int>> children_;
};

}  // namespace core
