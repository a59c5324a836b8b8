#include "core/garment/frontal_factor.hpp"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cstddef>

namespace core {
namespace {

using Dense = Eigen::Map<Eigen::MatrixXd>;
using Panel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// A front takes in its parent's columns where that adds few zeros: small fronts cost more than they compute.
constexpr int kSmallFront = 12;
constexpr double kZeroShare = 0.25;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Children of each node of a forest, the first in the order; then all nodes, children before parents.
std::vector<int> postorder(const std::vector<int>& parent) {
    const auto n = static_cast<int>(parent.size());
    std::vector<int> head(parent.size(), -1), next(parent.size(), -1), order, stack;
    for (int v = n - 1; v >= 0; --v)
        if (parent[at(v)] >= 0) next[at(v)] = head[at(parent[at(v)])], head[at(parent[at(v)])] = v;
    for (int root = 0; root < n; ++root) {
        if (parent[at(root)] >= 0) continue;
        stack.push_back(root);
        while (!stack.empty()) {
            const int v = stack.back(), child = head[at(v)];
            if (child >= 0) {
                head[at(v)] = next[at(child)];
                stack.push_back(child);
            } else {
                order.push_back(v);
                stack.pop_back();
            }
        }
    }
    return order;
}

/// Rows below the diagonal of each column of a matrix in an order.
std::vector<std::vector<int>> ordered_columns(const FrontalFactor::Matrix& lower, const std::vector<int>& place_of) {
    std::vector<std::vector<int>> below(place_of.size());
    for (int j = 0; j < lower.cols(); ++j)
        for (FrontalFactor::Matrix::InnerIterator it(lower, j); it; ++it) {
            const int a = place_of[at(static_cast<int>(it.row()))], b = place_of[at(j)];
            if (a != b) below[at(std::min(a, b))].push_back(std::max(a, b));
        }
    return below;
}

/// The rows of the factor: those of the matrix and those of the children, whose parent is their first row.
std::vector<int> fill_in(std::vector<std::vector<int>>& below) {
    std::vector<int> parent(below.size(), -1), seen(below.size(), -1);
    std::vector<std::vector<int>> children(below.size());
    for (std::size_t j = 0; j < below.size(); ++j) {
        const auto column = static_cast<int>(j);
        std::vector<int>& rows = below[j];
        for (const int row : rows) seen[at(row)] = column;
        seen[j] = column;
        for (const int child : children[j])
            for (const int row : below[at(child)]) {
                if (seen[at(row)] == column) continue;
                seen[at(row)] = column;
                rows.push_back(row);
            }
        if (rows.empty()) continue;
        std::sort(rows.begin(), rows.end());
        parent[j] = rows.front();
        children[at(rows.front())].push_back(column);
    }
    return parent;
}

}  // namespace

void FrontalFactor::analyse(const Matrix& lower) {
    // minimum degree, then children right before their parents
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> degree_order;
    const Matrix whole = lower.selfadjointView<Eigen::Lower>();
    Eigen::AMDOrdering<int>()(whole, degree_order);
    place_of_.assign(at(static_cast<int>(lower.rows())), 0);
    for (int i = 0; i < degree_order.size(); ++i) place_of_[at(degree_order.indices()[i])] = i;
    std::vector<std::vector<int>> early = ordered_columns(lower, place_of_);
    const std::vector<int> early_parent = fill_in(early), order = postorder(early_parent);
    std::vector<int> later(order.size()), parent(order.size(), -1);
    for (std::size_t k = 0; k < order.size(); ++k) later[at(order[k])] = static_cast<int>(k);
    for (int& place : place_of_) place = later[at(place)];
    std::vector<std::vector<int>> below(order.size());  // the same fill, renumbered
    for (std::size_t k = 0; k < order.size(); ++k) {
        below[k] = std::move(early[at(order[k])]);
        for (int& row : below[k]) row = later[at(row)];
        std::sort(below[k].begin(), below[k].end());
        if (!below[k].empty()) parent[k] = below[k].front();
    }
    make_fronts(below, parent);
    place_entries(lower);
}

void FrontalFactor::make_fronts(const std::vector<std::vector<int>>& below, const std::vector<int>& parent) {
    fronts_.clear();
    front_of_.assign(below.size(), 0);
    const auto n = static_cast<int>(below.size());
    for (int j = 0; j < n; ++j) {
        bool joins = false;
        if (!fronts_.empty()) {
            // the front so far ends right before j: does j go with it?
            const Front& last = fronts_.back();
            const int end = last.first + last.columns - 1;
            const std::size_t had = below[at(end)].size(), has = below[at(j)].size() + 1;
            if (parent[at(end)] == j) {
                const double zeros = static_cast<double>(has - std::min(had, has)) * last.columns;
                const double size = static_cast<double>(has + at(last.columns)) * (last.columns + 1);
                joins = had == has || (last.columns < kSmallFront && zeros < kZeroShare * size);
            }
        }
        if (joins) {
            ++fronts_.back().columns;
        } else {
            fronts_.emplace_back();
            fronts_.back().first = j;
            fronts_.back().columns = 1;
        }
        front_of_[at(j)] = static_cast<int>(fronts_.size()) - 1;
    }
    std::size_t panels = 0, largest = 0;
    children_.assign(fronts_.size(), {});
    for (std::size_t f = 0; f < fronts_.size(); ++f) {
        Front& front = fronts_[f];
        const int end = front.first + front.columns - 1;
        for (int j = front.first; j <= end; ++j) front.rows.push_back(j);
        front.rows.insert(front.rows.end(), below[at(end)].begin(), below[at(end)].end());
        front.panel = panels;
        panels += front.rows.size() * at(front.columns);
        largest = std::max(largest, front.rows.size() * front.rows.size());
        if (parent[at(end)] < 0) continue;
        front.parent = front_of_[at(parent[at(end)])];
        children_[at(front.parent)].push_back(static_cast<int>(f));
    }
    for (Front& front : fronts_) {
        front.in_parent.clear();
        if (front.parent < 0) continue;
        const std::vector<int>& theirs = fronts_[at(front.parent)].rows;
        std::size_t k = 0;
        for (std::size_t i = at(front.columns); i < front.rows.size(); ++i) {
            while (theirs[k] != front.rows[i]) ++k;
            front.in_parent.push_back(static_cast<int>(k));
        }
    }
    panels_.assign(panels, 0.0);
    work_.assign(largest, 0.0);
    updates_.assign(fronts_.size(), {});
}

void FrontalFactor::place_entries(const Matrix& lower) {
    const auto front_at = [&](int row, int column) {
        return at(front_of_[at(std::min(place_of_[at(row)], place_of_[at(column)]))]);
    };
    for (Front& front : fronts_) front.entries = front.end = 0;
    for (int j = 0; j < lower.cols(); ++j)
        for (Matrix::InnerIterator it(lower, j); it; ++it) ++fronts_[front_at(static_cast<int>(it.row()), j)].end;
    std::size_t count = 0;
    for (Front& front : fronts_) {
        front.entries = count;
        count += front.end;
        front.end = front.entries;
    }
    sources_.resize(count);
    targets_.resize(count);
    std::size_t source = 0;
    for (int j = 0; j < lower.cols(); ++j)
        for (Matrix::InnerIterator it(lower, j); it; ++it, ++source) {
            Front& front = fronts_[front_at(static_cast<int>(it.row()), j)];
            const int a = place_of_[at(static_cast<int>(it.row()))], b = place_of_[at(j)];
            const auto row = static_cast<std::size_t>(
                std::lower_bound(front.rows.begin(), front.rows.end(), std::max(a, b)) - front.rows.begin());
            sources_[front.end] = source;
            targets_[front.end++] = at(std::min(a, b) - front.first) * front.rows.size() + row;
        }
}

bool FrontalFactor::factorise(const Matrix& lower) {
    const double* values = lower.valuePtr();
    for (std::size_t f = 0; f < fronts_.size(); ++f) {
        const Front& front = fronts_[f];
        const auto m = static_cast<Eigen::Index>(front.rows.size()), k = static_cast<Eigen::Index>(front.columns);
        std::fill_n(work_.begin(), m * m, 0.0);
        for (std::size_t e = front.entries; e < front.end; ++e) work_[targets_[e]] = values[sources_[e]];
        for (const int child : children_[f]) {  // what the children passed up, a column at a time
            const std::vector<int>& in = fronts_[at(child)].in_parent;
            const double* from = updates_[at(child)].data();
            for (std::size_t c = 0; c < in.size(); ++c, from += in.size()) {
                double* to = work_.data() + at(in[c]) * front.rows.size();
                for (std::size_t r = c; r < in.size(); ++r) to[in[r]] += from[r];
            }
        }
        Dense whole(work_.data(), m, m);
        auto corner = whole.topLeftCorner(k, k);
        if (Eigen::internal::llt_inplace<double, Eigen::Lower>::blocked(corner) >= 0) return false;
        if (m > k) {
            auto beside = whole.bottomLeftCorner(m - k, k);
            corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(beside);
            std::vector<double>& update = updates_[f];
            update.resize(static_cast<std::size_t>((m - k) * (m - k)));
            Dense passed(update.data(), m - k, m - k);
            passed.triangularView<Eigen::Lower>() = whole.bottomRightCorner(m - k, m - k);
            passed.selfadjointView<Eigen::Lower>().rankUpdate(beside, -1.0);
        }
        std::copy_n(work_.begin(), m * k, panels_.begin() + static_cast<std::ptrdiff_t>(front.panel));
    }
    return true;
}

void FrontalFactor::solve(Rows& right) {
    moved_.resize(right.rows(), 3);
    for (Eigen::Index i = 0; i < right.rows(); ++i) moved_.row(place_of_[at(static_cast<int>(i))]) = right.row(i);
    for (const Front& front : fronts_) {
        const auto m = front.rows.size();
        for (int c = 0; c < front.columns; ++c) {
            const double* column = panels_.data() + front.panel + at(c) * m;
            const Eigen::RowVector3d value = moved_.row(front.first + c) / column[c];
            moved_.row(front.first + c) = value;
            for (std::size_t r = at(c) + 1; r < m; ++r) moved_.row(front.rows[r]) -= column[r] * value;
        }
    }
    for (std::size_t f = fronts_.size(); f-- > 0;) {
        const Front& front = fronts_[f];
        const auto m = front.rows.size();
        for (int c = front.columns - 1; c >= 0; --c) {
            const double* column = panels_.data() + front.panel + at(c) * m;
            Eigen::RowVector3d value = moved_.row(front.first + c);
            for (std::size_t r = at(c) + 1; r < m; ++r) value -= column[r] * moved_.row(front.rows[r]);
            moved_.row(front.first + c) = value / column[c];
        }
    }
    for (Eigen::Index i = 0; i < right.rows(); ++i) right.row(i) = moved_.row(place_of_[at(static_cast<int>(i))]);
}

}  // namespace core
