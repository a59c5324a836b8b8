#include "core/garment/fill_plan.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace core {
namespace {

using Kind = FillStep::Kind;

constexpr int kFewPlans = 24;
constexpr int kManyPlans = 100;
constexpr int kBudget = 12000;

struct Range {
    int low, high;
    [[nodiscard]] bool empty() const { return low > high; }
};

/// Values of a range worth a try, the middle first: it keeps irregular vertices away from everything.
class Values {
  public:
    Values(Range r, bool many, bool deep) {
        if (r.empty()) return;
        const int middle = r.low + (r.high - r.low) / 2;
        if (many) {
            for (int reach = 0; count_ + 1 < values_.size() && reach <= r.high - r.low; ++reach) {
                if (middle + reach <= r.high) add(middle + reach);
                if (reach > 0 && middle - reach >= r.low) add(middle - reach);
            }
            return;
        }
        for (const int v : {middle, r.low, r.high, r.low + 1, r.high - 1, (r.low + middle) / 2, (middle + r.high) / 2})
            if (v >= r.low && v <= r.high && std::find(begin(), end(), v) == end() && (!deep || count_ < 3)) add(v);
    }
    [[nodiscard]] const int* begin() const { return values_.data(); }
    [[nodiscard]] const int* end() const { return values_.data() + count_; }

  private:
    void add(int value) { values_[count_++] = value; }
    std::array<int, 64> values_;  // NOLINT: only the first count_ are read
    std::size_t count_ = 0;
};

/// A side longer than all others together: quads there run from the side back to itself.
bool has_excess(const SideCounts& sides) {
    const int half = sides.total() / 2;
    for (int i = 0; i < sides.n; ++i)
        if (sides[i] > half) return true;
    return false;
}

class PlanSearch {
  public:
    explicit PlanSearch(FillSearch search)
        : thorough_(search == FillSearch::Thorough),
          joining_(search == FillSearch::Joining),
          most_(static_cast<std::size_t>(thorough_ ? kManyPlans : kFewPlans)) {}

    std::vector<FillPlan> run(const SideCounts& sides, int irregular) {
        visit(sides, irregular);
        std::stable_sort(plans_.begin(), plans_.end(),
                         [](const FillPlan& x, const FillPlan& y) { return x.score > y.score; });
        return std::move(plans_);
    }

  private:
    [[nodiscard]] bool done() const { return plans_.size() >= most_ || used_ > kBudget; }

    void visit(const SideCounts& s, int k) {
        ++used_;
        if (done() || s.n < 2 || k < std::abs(s.n - 4) || (s.n + k) % 2 != 0) return;
        if (joining_ && s.n > 4) return joins(s, k);
        if (k == 0) return grid(s);
        if (k == 1) return star(s);
        if (s.n > 2 && k < (s.n == 4 ? 4 : std::abs(s.n - 4) + 2) && has_excess(s)) return;
        if (k == 2) {
            if (s.n == 2) two_sides(s);
            if (s.n == 4) four_sides(s);
            if (s.n == 6) six_sides(s);
        } else {
            five_stars(s, k);
            corner_rectangles(s, k);
        }
        if (thorough_) tiny(s, k);
    }

    void grid(const SideCounts& s) {
        if (s.n == 4 && s[0] == s[2] && s[1] == s[3] && s[0] > 0 && s[1] > 0) emit({Kind::Grid}, smallest_ + 1);
    }

    void star(const SideCounts& s) {
        const std::optional<SideCounts> d = star_distances(s);
        if (!d) return;
        int nearest = std::numeric_limits<int>::max();
        for (int i = 0; i < d->n; ++i) nearest = std::min(nearest, (*d)[i]);
        emit({Kind::Star}, std::min(smallest_, nearest));
    }

    void emit(FillStep last, int score) {
        steps_.push_back(last);
        plans_.push_back({steps_, score});
        steps_.pop_back();
    }

    void take(const SideCounts& s, int k, FillStep step, int distance) {
        if (s.n + 1 >= SideCounts::kMost) return;
        const int before = smallest_;
        smallest_ = std::min(smallest_, distance);
        steps_.push_back(step);
        visit(sides_after(s, step), k - 1);
        steps_.pop_back();
        smallest_ = before;
    }

    void rectangles(const SideCounts& s, int k, int side, Range a_range, Range b_range, int most_sum) {
        for (const int a : Values(a_range, thorough_, !steps_.empty()))
            for (const int b :
                 Values({b_range.low, std::min(b_range.high, most_sum - a)}, thorough_, !steps_.empty())) {
                if (done()) return;
                take(s, k, {Kind::CornerRectangle, side, a, b}, std::min(a, b));
            }
    }

    void five_star(const SideCounts& s, int k, int side, Range a_range, Range b_range, int most_sum) {
        for (const int a : Values(a_range, thorough_, !steps_.empty()))
            for (const int b :
                 Values({b_range.low, std::min(b_range.high, most_sum - a)}, thorough_, !steps_.empty())) {
                if (done()) return;
                const int inside = std::min({a, b, s[side + 2] - a, s[side + 1] - b});
                take(s, k, {Kind::FiveStar, side, a, b}, inside);
            }
    }

    /// Two of valence 3. All a, b with |l0 - l1| <= 2a, 2b and 2(a + b) <= l0 + l1 do.
    void two_sides(const SideCounts& s) {
        for (int i = 0; i < 2; ++i) {
            const int x = s[i], y = s[i + 1];
            rectangles(s, 2, i, {std::max(1, (x - y) / 2), x}, {std::max(1, (y - x) / 2), y}, (x + y) / 2);
        }
    }

    /// One of valence 3 and one of valence 5: the rectangle leaves the corner of the two sides that are longer than the
    /// two others together; what remains is a star whose five distances bound a and b apart from each other.
    void four_sides(const SideCounts& s) {
        for (int i = 0; i < 4; ++i) {
            const int l0 = s[i], l1 = s[i + 1], l2 = s[i + 2], l3 = s[i + 3];
            if (l0 + l1 < l2 + l3) continue;
            rectangles(s, 2, i, {std::max(1, (l0 + l3 - l1 - l2) / 2), std::min(l0, (l0 + l2 + l3 - l1) / 2)},
                       {std::max(1, (l1 + l2 - l0 - l3) / 2), std::min(l1, (l1 + l2 + l3 - l0) / 2)}, l0 + l1);
        }
    }

    /// Two of valence 5, likewise.
    void six_sides(const SideCounts& s) {
        for (int i = 0; i < 6; ++i) {
            const int l0 = s[i], l1 = s[i + 1], l2 = s[i + 2], l3 = s[i + 3], l4 = s[i + 4], l5 = s[i + 5];
            five_star(
                s, 2, i,
                {std::max(0, (l0 + l1 + l2 - l3 - l4 - l5) / 2), std::min({l0, l2, (l0 + l1 + l2 + l5 - l3 - l4) / 2})},
                {std::max(0, (l1 + l2 + l3 - l4 - l5 - l0) / 2), std::min({l1, l3, (l1 + l2 + l3 + l4 - l5 - l0) / 2})},
                std::min(l1 + l2 - 1, (l0 + l1 + l2 + l3 - l4 - l5) / 2));
        }
    }

    /// A side that must lose its excess gives at least half of it.
    void corner_rectangles(const SideCounts& s, int k) {
        const int half = s.total() / 2;
        const bool excess_may_stay = k - 1 >= std::abs(s.n - 3) + 2;
        for (int i = 0; i < s.n; ++i) {
            const int x = s[i], y = s[i + 1];
            const Range a{std::max(1, excess_may_stay ? 1 : x - half), x};
            const Range b{std::max(1, excess_may_stay ? 1 : y - half), y};
            rectangles(s, k, i, a, b, excess_may_stay ? x + y : half);
        }
    }

    void five_stars(const SideCounts& s, int k) {
        if (s.n < 5) return;
        for (int i = 0; i < s.n; ++i) {
            const int l0 = s[i], l1 = s[i + 1], l2 = s[i + 2], l3 = s[i + 3];
            five_star(s, k, i, {0, std::min(l0, l2)}, {0, std::min(l1, l3)}, l1 + l2 - 1);
        }
    }

    void tiny(const SideCounts& s, int k) {
        for (int i = 0; i < s.n; ++i)
            for (int a = 1; a < s[i]; ++a) take(s, k, {Kind::Split, i, a, 0}, 0);
        joins(s, k);
    }

    void joins(const SideCounts& s, int k) {
        for (int i = 0; i < s.n && s.n > 2; ++i) take(s, k, {Kind::Join, i, 0, 0}, 0);
    }

    bool thorough_, joining_;
    std::size_t most_;
    int used_ = 0;
    int smallest_ = std::numeric_limits<int>::max() - 1;
    std::vector<FillStep> steps_;
    std::vector<FillPlan> plans_;
};

}  // namespace

SideCounts sides_after(const SideCounts& s, const FillStep& step) {
    SideCounts rest;
    const int i = step.side;
    switch (step.kind) {
        case Kind::CornerRectangle:
            for (int j = 0; j < s.n; ++j) {
                rest.push_back(s[j] - (j == i ? step.a : 0) - (j == (i + 1) % s.n ? step.b : 0));
                if (j == i) rest.push_back(step.a + step.b);
            }
            break;
        case Kind::FiveStar:
            rest.push_back(s[i] - step.a);
            rest.push_back(s[i + 1] + s[i + 2] - step.a - step.b);
            rest.push_back(s[i + 3] - step.b);
            for (int j = 4; j < s.n; ++j) rest.push_back(s[i + j]);
            break;
        case Kind::Split:
            for (int j = 0; j < s.n; ++j) {
                rest.push_back(j == i ? step.a : s[j]);
                if (j == i) rest.push_back(s[j] - step.a);
            }
            break;
        case Kind::Join:
            rest.push_back(s[i] + s[i + 1]);
            for (int j = 2; j < s.n; ++j) rest.push_back(s[i + j]);
            break;
        case Kind::Grid:
        case Kind::Star:
            break;
    }
    return rest;
}

std::vector<FillPlan> fill_plans(const SideCounts& sides, int irregular, FillSearch search) {
    return PlanSearch(search).run(sides, irregular);
}

}  // namespace core
