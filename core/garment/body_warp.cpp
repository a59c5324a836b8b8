#include "core/garment/body_warp.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace core {
namespace {

constexpr std::size_t kFewest = 8;

}  // namespace

std::optional<BodyWarp> BodyWarp::between(const std::vector<Landmark>& from, const std::vector<Landmark>& to) {
    BodyWarp warp;
    std::vector<Vec3> goals;
    for (const Landmark& l : from)
        if (const Landmark* other = find_landmark(to, l.name); other != nullptr) {
            warp.centres_.push_back(l.place);
            goals.push_back(other->place);
        }
    if (goals.size() < kFewest) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(goals.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n + 4, 3);
    const auto at = [](const std::vector<Vec3>& list, Eigen::Index i) { return list[static_cast<std::size_t>(i)]; };
    for (Eigen::Index i = 0; i < n; ++i) {
        const Vec3 p = at(warp.centres_, i), goal = at(goals, i);
        for (Eigen::Index j = 0; j < n; ++j) system(i, j) = length(at(warp.centres_, j) - p);
        system.row(i).tail(4) << 1.0, p.x, p.y, p.z;
        system.col(i).tail(4) << 1.0, p.x, p.y, p.z;
        right.row(i) << goal.x, goal.y, goal.z;
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> solver(system);
    if (!solver.isInvertible()) return std::nullopt;
    const Eigen::MatrixX3d w = solver.solve(right);
    const auto row = [&](Eigen::Index i) { return Vec3{w(i, 0), w(i, 1), w(i, 2)}; };
    for (Eigen::Index i = 0; i < n; ++i) warp.weights_.push_back(row(i));
    warp.shift_ = row(n), warp.x_ = row(n + 1), warp.y_ = row(n + 2), warp.z_ = row(n + 3);
    return warp;
}

Vec3 BodyWarp::operator()(Vec3 p) const {
    Vec3 sum = shift_ + x_ * p.x + y_ * p.y + z_ * p.z;
    for (std::size_t i = 0; i < centres_.size(); ++i) sum = sum + weights_[i] * length(p - centres_[i]);
    return sum;
}

}  // namespace core
