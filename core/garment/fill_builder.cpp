#include "core/garment/fill_builder.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace core {
namespace {

using Chain = std::vector<std::uint32_t>;  // vertices along a line, both ends included
using Kind = FillStep::Kind;

Chain part(const Chain& chain, int from, int to) {
    return {chain.begin() + from, chain.begin() + to + 1};
}
Chain reversed(Chain chain) {
    std::reverse(chain.begin(), chain.end());
    return chain;
}
int edges(const Chain& chain) {
    return static_cast<int>(chain.size()) - 1;
}

/// Takes the pieces of a plan away one by one. A distance of 0 makes vertices meet: they are united.
class Builder {
  public:
    explicit Builder(const SideCounts& sides) : boundary_(static_cast<std::uint32_t>(sides.total())) {
        parent_.resize(boundary_);
        std::iota(parent_.begin(), parent_.end(), 0U);
        is_corner_.assign(boundary_, false);
        std::uint32_t at = 0;
        for (int i = 0; i < sides.n; ++i) {
            Chain side;
            for (int k = 0; k <= sides[i]; ++k) side.push_back((at + static_cast<std::uint32_t>(k)) % boundary_);
            is_corner_[at] = true;
            at += static_cast<std::uint32_t>(sides[i]);
            sides_.push_back(std::move(side));
        }
    }

    /// False where a star does not fit.
    bool take(const FillStep& step) {
        switch (step.kind) {
            case Kind::Grid:
                grid(sides_[0], reversed(sides_[3]), reversed(sides_[2]), sides_[1]);
                return true;
            case Kind::Star:
                return star(sides_);
            case Kind::CornerRectangle:
                corner_rectangle(step);
                return true;
            case Kind::FiveStar:
                return five_star(step);
            case Kind::Split:
                split(step);
                return true;
            case Kind::Join:
                join(step);
                return true;
        }
        return false;
    }

    std::optional<RegionTopology> finish() {
        for (std::uint32_t v = 0; v < boundary_; ++v)
            if (find(v) != v) return std::nullopt;
        constexpr std::uint32_t kNone = ~0U;
        std::vector<std::uint32_t> number(parent_.size(), kNone);
        std::iota(number.begin(), number.begin() + boundary_, 0U);
        RegionTopology out{boundary_, boundary_, std::move(quads_), std::move(is_corner_), {}};
        for (Quad& quad : out.quads)
            for (std::uint32_t& v : quad) {
                v = find(v);
                if (number[v] == kNone) number[v] = out.vertices++;
                v = number[v];
            }
        const auto counts = count_quad_disc(out.quads, out.vertices, out.is_corner);
        if (!counts) return std::nullopt;
        out.counts = *counts;
        return out;
    }

  private:
    std::uint32_t add() {
        parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
        return parent_.back();
    }
    std::uint32_t find(std::uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);  // boundary vertices keep their numbers
    }

    Chain chain(std::uint32_t from, std::uint32_t to, int length) {
        Chain out{from};
        for (int k = 1; k < length; ++k) out.push_back(add());
        if (length > 0) {
            out.push_back(to);
        } else {
            unite(from, to);
        }
        return out;
    }

    /// Quads between four lines: u and v leave the first corner, v to the left of u; across lies opposite u, along
    /// opposite v.
    void grid(const Chain& u, const Chain& v, const Chain& across, const Chain& along) {
        const auto m = static_cast<std::size_t>(edges(u)), n = static_cast<std::size_t>(edges(v));
        unite(u[0], v[0]);
        unite(u[m], along[0]);
        unite(v[n], across[0]);
        unite(across[m], along[n]);
        for (std::size_t j = 0; m == 0 && j <= n; ++j) unite(v[j], along[j]);
        for (std::size_t i = 0; n == 0 && i <= m; ++i) unite(u[i], across[i]);
        Chain previous = v;
        for (std::size_t i = 1; i <= m && n > 0; ++i) {
            Chain next{u[i]};
            for (std::size_t j = 1; j < n && i < m; ++j) next.push_back(add());
            if (i < m) next.push_back(across[i]);
            if (i == m) next = along;
            for (std::size_t j = 0; j < n; ++j) quads_.push_back({previous[j], next[j], next[j + 1], previous[j + 1]});
            previous = std::move(next);
        }
    }

    bool star(const std::vector<Chain>& sides) {
        SideCounts counts;
        for (const Chain& side : sides) counts.push_back(edges(side));
        const std::optional<SideCounts> d = star_distances(counts);
        if (!d) return false;
        const std::uint32_t centre = add();
        std::vector<Chain> spokes;
        for (int i = 0; i < d->n; ++i) {
            const std::uint32_t foot = sides[static_cast<std::size_t>(i)][static_cast<std::size_t>((*d)[i - 1])];
            spokes.push_back(chain(foot, centre, (*d)[i]));
        }
        for (int i = 0; i < d->n; ++i) {
            const auto here = static_cast<std::size_t>(i), next = static_cast<std::size_t>((i + 1) % d->n);
            grid(part(sides[next], 0, (*d)[i]), reversed(part(sides[here], (*d)[i - 1], counts[i])), spokes[here],
                 spokes[next]);
        }
        return true;
    }

    void corner_rectangle(const FillStep& step) {
        const auto i = static_cast<std::size_t>(step.side), next = (i + 1) % sides_.size();
        const Chain before = sides_[i], after = sides_[next];
        const int rest = edges(before) - step.a;
        const Chain u = part(after, 0, step.b), v = reversed(part(before, rest, edges(before)));
        const std::uint32_t inner = add();
        const Chain across = chain(v.back(), inner, step.b), along = chain(u.back(), inner, step.a);
        grid(u, v, across, along);
        Chain chord = across;
        for (int k = step.a - 1; k >= 0; --k) chord.push_back(along[static_cast<std::size_t>(k)]);
        sides_[i] = part(before, 0, rest);
        sides_[next] = part(after, step.b, edges(after));
        sides_.insert(sides_.begin() + step.side + 1, std::move(chord));
    }

    bool five_star(const FillStep& step) {
        std::rotate(sides_.begin(), sides_.begin() + step.side, sides_.end());
        const Chain first = sides_[0], last = sides_[3];
        const int rest = edges(first) - step.a;
        const Chain chord = chain(first[static_cast<std::size_t>(rest)], last[static_cast<std::size_t>(step.b)],
                                  edges(sides_[1]) + edges(sides_[2]) - step.a - step.b);
        if (!star({part(first, rest, edges(first)), sides_[1], sides_[2], part(last, 0, step.b), reversed(chord)}))
            return false;
        sides_[0] = part(first, 0, rest);
        sides_[1] = chord;
        sides_[2] = part(last, step.b, edges(last));
        sides_.erase(sides_.begin() + 3);
        return true;
    }

    void split(const FillStep& step) {
        const Chain side = sides_[static_cast<std::size_t>(step.side)];
        sides_[static_cast<std::size_t>(step.side)] = part(side, 0, step.a);
        sides_.insert(sides_.begin() + step.side + 1, part(side, step.a, edges(side)));
    }

    void join(const FillStep& step) {
        std::rotate(sides_.begin(), sides_.begin() + step.side, sides_.end());
        sides_[0].insert(sides_[0].end(), sides_[1].begin() + 1, sides_[1].end());
        sides_.erase(sides_.begin() + 1);
    }

    std::uint32_t boundary_;
    std::vector<std::uint32_t> parent_;
    std::vector<bool> is_corner_;
    std::vector<Chain> sides_;
    std::vector<Quad> quads_;
};

}  // namespace

std::optional<RegionTopology> build_fill(const SideCounts& sides, const FillPlan& plan) {
    Builder builder(sides);
    for (const FillStep& step : plan.steps)
        if (!builder.take(step)) return std::nullopt;
    return builder.finish();
}

}  // namespace core
