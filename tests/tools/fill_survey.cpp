// Fills regions of very many side lengths and prints how many irregular vertices they get and how long it takes.
//
//     fill_survey     69,000 regions; exit code 1 when one fails, a quad folds on a circle, or a row is worse than its
//     limit
//
// The limits are those of pattern-based quadrangulation (Takayama, Panozzo, Sorkine-Hornung 2014) as measured on the
// same inputs: the share of regions with more than so many irregular vertices.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/garment/fill_topology.hpp"
#include "core/garment/region.hpp"
#include "support/outlines.hpp"

namespace {

using Sides = std::vector<int>;

struct Row {
    int sides, longest;
    int random_cases;              ///< 0: every even input
    std::map<int, double> limits;  ///< of regions with more irregular vertices than the key, in per cent
};

const std::vector<Row> kRows{
    {3, 12, 0, {{1, 33.0}, {3, 0.0}}},
    {3, 20, 0, {{1, 39.4}, {3, 0.0}}},
    {4, 10, 0, {{0, 98.0}, {2, 6.4}, {4, 0.0}}},
    {5, 7, 0, {{1, 54.6}, {3, 12.7}, {5, 0.0}}},
    {6, 5, 0, {{2, 36.9}, {4, 7.1}, {6, 2.3}, {8, 0.0}}},
    {2, 60, 0, {}},
    {7, 6, 4000, {}},
    {8, 6, 4000, {}},
    {3, 40, 8000, {}},
    {4, 40, 8000, {}},
    {5, 40, 8000, {}},
    {6, 40, 8000, {}},
    {7, 3, 0, {}},
    {8, 3, 0, {}},
};

class Survey {
  public:
    explicit Survey(const Row& row) : row_(row) {
        if (row.random_cases == 0) {
            every();
        } else {
            random();
        }
    }

    /// Prints a line; true when nothing is at fault.
    bool report() const {
        std::printf("%d  %3d  %6d  %8d  %5d  %6d  %.3f / %.2f ", row_.sides, row_.longest, cases_, failed_, folded_,
                    raised_, total_ms_ / cases_, longest_ms_);
        for (const auto& [irregular, count] : counts_) std::printf("  %d: %.1f %%", irregular, share(count));
        bool good = failed_ == 0 && folded_ == 0 && total_ms_ / cases_ < 0.5;
        for (const auto& [most, limit] : row_.limits) {
            int above = 0;
            for (const auto& [irregular, count] : counts_) above += irregular > most ? count : 0;
            if (share(above) <= limit + 0.05) continue;
            std::printf("  MORE THAN %d: %.1f %%, limit %.1f %%", most, share(above), limit);
            good = false;
        }
        std::printf("\n");
        return good;
    }
    [[nodiscard]] int cases() const { return cases_; }

  private:
    [[nodiscard]] double share(int count) const { return 100.0 * count / cases_; }

    void every() {
        Sides sides(static_cast<std::size_t>(row_.sides), 1);
        for (std::size_t i = 0; i < sides.size();) {
            add(sides);
            for (i = 0; i < sides.size() && ++sides[i] > row_.longest; ++i) sides[i] = 1;
        }
    }

    void random() {
        std::mt19937 generator(20260101);
        while (cases_ < row_.random_cases) {
            Sides sides;
            for (int i = 0; i < row_.sides; ++i)
                sides.push_back(1 + static_cast<int>(generator() % static_cast<unsigned>(row_.longest)));
            add(sides);
        }
    }

    void add(const Sides& sides) {
        const int total = std::accumulate(sides.begin(), sides.end(), 0);
        if (total % 2 != 0 || total < 4) return;
        ++cases_;
        double ms = 1e300;
        core::Result<core::RegionTopology> topology = core::fill_topology(sides);
        for (int k = 0; k < 4 && ms > 0.3; ++k) {  // once more where the machine may have been busy
            const auto start = std::chrono::steady_clock::now();
            topology = core::fill_topology(sides);
            ms = std::min(ms,
                          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        }
        total_ms_ += ms;
        longest_ms_ = std::max(longest_ms_, ms);
        if (!topology) {
            ++failed_;
            return;
        }
        ++counts_[topology->counts.irregular()];
        if (cases_ % 8 != 0) return;  // the solves would take most of the time
        const core::Result<std::vector<core::Vec3>> ring = core::outline_ring(support::circle_outline(sides));
        const core::FilledRegion flat = core::fill_ring(*topology, *ring, core::kHarmonicAlpha);
        const core::FilledRegion full = core::fill_ring(*topology, *ring, core::kCoonsAlpha);
        folded_ += support::folded_quad(flat.mesh) >= 0 || support::folded_quad(full.mesh) >= 0;
        raised_ += full.alpha > core::kCoonsAlpha;
    }

    Row row_;
    int cases_ = 0, failed_ = 0, folded_ = 0, raised_ = 0;
    double total_ms_ = 0.0, longest_ms_ = 0.0;
    std::map<int, int> counts_;
};

}  // namespace

int main() {
    std::printf("n  to   cases   failed  folded  raised  ms mean / max  share by number of irregular vertices\n");
    bool good = true;
    int cases = 0;
    for (const Row& row : kRows) {
        const Survey survey(row);
        good = survey.report() && good;
        cases += survey.cases();
        std::fflush(stdout);
    }
    std::printf("%d regions, %s\n", cases, good ? "none at fault" : "SOME AT FAULT");
    return good ? 0 : 1;
}
