#include "core/garment/desk/face_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/garment/desk/limb_threads.hpp"

namespace core {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kReach_cm = 2.5;     // how far from a vertex a line's direction is taken
constexpr double kSpacing_cm = 1.25;  // at which the turn of a line is summed
/// A vertex whose order may be wrong: a line that leaves along the way out, or two whose directions are this near.
constexpr double kSteep = 0.6, kNear_rad = 0.7;
constexpr std::size_t kMostTried = 5;  // lines at a vertex whose orders are all tried
constexpr int kRounds = 4;
constexpr double kFlat = 0.5;     // share of an edge across the way out from which it has a direction there
constexpr double kFacing = 0.35;  // openings of the worked designs: 0.14 at most; their pieces: 0.7 at least

/// Half of a line: it, walked from one of its ends.
struct Half {
    int line = 0;
    bool reversed = false;
    [[nodiscard]] int id() const { return 2 * line + (reversed ? 1 : 0); }
};

struct Leaving {
    Half half;     // away from the vertex
    Vec3 way;      // unit
    double angle;  // about the way out
};

struct Corner {
    std::vector<Leaving> order;  // anti-clockwise about the way out
    bool flat = true;            // its angles can be measured about the way out
    bool weak = false;           // another order may be the right one
};

class FaceWalk {
  public:
    FaceWalk(const Network& network, int layer, const Obstacle& body)
        : net_(network), body_(body), threads_(limb_threads(body.parts())) {
        take_lines(layer);
        for (std::size_t v = 0; v < corners_.size(); ++v) order_lines(static_cast<int>(v));
        improve();
    }

    [[nodiscard]] std::vector<NetworkFace> faces() const {
        std::vector<NetworkFace> out;
        for (const std::vector<int>& walk : walks()) {
            NetworkFace face;
            std::set<int> lines;
            for (const int id : walk) {
                face.ring.push_back({id / 2, id % 2 == 1});
                lines.insert(id / 2);
            }
            face.turn_rad = turn_of(walk);
            const SpaceLine border = border_of(face.ring);
            face.facing = facing_of(border);
            face.is_opening = is_opening(walk);
            if (lines.size() == walk.size()) out.push_back(std::move(face));
        }
        return out;
    }

  private:
    [[nodiscard]] const NetworkLine& line(int i) const { return net_.lines()[static_cast<std::size_t>(i)]; }
    [[nodiscard]] int start_of(int id) const { return id % 2 == 0 ? line(id / 2).from : line(id / 2).to; }

    /// Living lines of the layer, without those that lead nowhere.
    void take_lines(int layer) {
        std::vector<int> degree(net_.vertices().size(), 0);
        for (std::size_t i = 0; i < net_.lines().size(); ++i) {
            const NetworkLine& l = net_.lines()[i];
            if (!l.alive || l.layer != layer) continue;
            lines_.push_back(static_cast<int>(i));
            ++degree[static_cast<std::size_t>(l.from)], ++degree[static_cast<std::size_t>(l.to)];
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t k = 0; k < lines_.size(); ++k) {
                const auto from = static_cast<std::size_t>(line(lines_[k]).from),
                           to = static_cast<std::size_t>(line(lines_[k]).to);
                if (degree[from] > 1 && degree[to] > 1) continue;
                --degree[from], --degree[to];
                lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(k--));
                changed = true;
            }
        }
        corners_.resize(net_.vertices().size());
        place_in_order_.resize(2 * net_.lines().size(), 0);
        line_turn_.resize(net_.lines().size(), 0.0);
        passes_.resize(net_.lines().size());
        for (const int i : lines_) {
            corners_[static_cast<std::size_t>(line(i).from)].order.push_back({{i, false}, {}, 0.0});
            corners_[static_cast<std::size_t>(line(i).to)].order.push_back({{i, true}, {}, 0.0});
            for (const SpaceLine& thread : threads_)
                passes_[static_cast<std::size_t>(i)].push_back(passes_cone(thread, line(i).shape));
        }
        sum_turns();
    }

    [[nodiscard]] std::size_t degree(int vertex) const {
        return corners_[static_cast<std::size_t>(vertex)].order.size();
    }

    /// A line from where it leaves a vertex, and on through vertices that only two lines have: drawn as one.
    struct Chain {
        SpaceLine shape;
        std::vector<int> lines;
        bool closed = false;  ///< all its vertices are such
    };
    [[nodiscard]] Chain chain_from(Half half) const {
        Chain chain;
        for (const int first = half.line;;) {
            SpaceLine shape = line(half.line).shape;
            if (half.reversed) std::reverse(shape.begin(), shape.end());
            chain.shape.insert(chain.shape.end(), shape.begin() + (chain.shape.empty() ? 0 : 1), shape.end());
            chain.lines.push_back(half.line);
            const int end = half.reversed ? line(half.line).from : line(half.line).to;
            if (degree(end) != 2) return chain;
            const std::vector<Leaving>& two = corners_[static_cast<std::size_t>(end)].order;
            const bool came = two[0].half.line == half.line && two[0].half.reversed != half.reversed;
            half = came ? two[1].half : two[0].half;
            if (half.line == first) {
                chain.closed = true;
                return chain;
            }
        }
    }

    /// Turns of chains stand at their first lines.
    void sum_turns() {
        std::vector<bool> summed(net_.lines().size(), false);
        const auto sum = [&](Half half) {
            if (summed[static_cast<std::size_t>(half.line)]) return;
            Chain chain = chain_from(half);
            for (const int l : chain.lines) summed[static_cast<std::size_t>(l)] = true;
            if (chain.closed) {  // and past where it begins
                const SpaceLine begin(
                    chain.shape.begin() + 1,
                    chain.shape.begin() + std::min<std::ptrdiff_t>(4, static_cast<std::ptrdiff_t>(chain.shape.size())));
                chain.shape.insert(chain.shape.end(), begin.begin(), begin.end());
            }
            const double turn = turn_along(chain.shape);
            line_turn_[static_cast<std::size_t>(half.line)] = half.reversed ? -turn : turn;
        };
        for (const int l : lines_) {
            if (degree(line(l).from) != 2) sum({l, false});
            if (degree(line(l).to) != 2) sum({l, true});
        }
        for (const int l : lines_) sum({l, false});
    }

    /// The turn to the left between the ends of a line, about the way out.
    [[nodiscard]] double turn_along(const SpaceLine& shape) const {
        const int edges = std::max(2, static_cast<int>(std::lround(line_length(shape) / kSpacing_cm)));
        const SpaceLine points = resampled(shape, edges);
        double sum = 0.0;
        Vec3 last;  // the direction before, across the way out; what leads straight out or in has none
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec3 edge = points[i + 1] - points[i];
            const Vec3 out = normalised(body_.sample(points[i] + edge * 0.5).gradient);
            const Vec3 on = edge - out * dot(edge, out), in = last - out * dot(last, out);
            if (length(on) < kFlat * length(edge)) continue;
            if (length(in) > 0.0) sum += std::atan2(dot(out, cross(in, on)), dot(in, on));
            last = normalised(on);
        }
        return sum;
    }

    /// Out of the body about a vertex: with what it is a little along its lines, for it flips in folds of the body.
    [[nodiscard]] Vec3 way_out(const Corner& corner, Vec3 place) const {
        Vec3 sum = normalised(body_.sample(place).gradient);
        for (const Leaving& leaving : corner.order) {
            const SpaceLine shape = chain_from(leaving.half).shape;
            sum = sum +
                  normalised(body_.sample(place_along(shape, std::min(kReach_cm, 0.4 * line_length(shape)))).gradient);
        }
        return normalised(sum);
    }

    void order_lines(int vertex) {
        Corner& corner = corners_[static_cast<std::size_t>(vertex)];
        if (corner.order.empty()) return;
        const Vec3 place = net_.vertices()[static_cast<std::size_t>(vertex)].place;
        const Vec3 out = way_out(corner, place);
        const Vec3 aside = std::abs(out.y) < 0.8 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
        const Vec3 right = normalised(cross(aside, out)), up = cross(out, right);
        for (Leaving& leaving : corner.order) {
            const SpaceLine shape = chain_from(leaving.half).shape;
            for (const double reach : {1.0, 1.6, 2.4}) {  // farther along a line that leaves straight out
                leaving.way =
                    normalised(place_along(shape, std::min(reach * kReach_cm, 0.4 * line_length(shape))) - place);
                if (std::abs(dot(leaving.way, out)) < kSteep) break;
            }
            leaving.angle = std::atan2(dot(leaving.way, up), dot(leaving.way, right));
            corner.weak = corner.weak || std::abs(dot(leaving.way, out)) > kSteep;
        }
        std::sort(corner.order.begin(), corner.order.end(), [](const Leaving& a, const Leaving& b) {
            return a.angle < b.angle || (a.angle == b.angle && a.half.id() < b.half.id());
        });
        for (std::size_t k = 0; k < corner.order.size(); ++k) {
            double gap = corner.order[(k + 1) % corner.order.size()].angle - corner.order[k].angle;
            if (gap <= 0.0) gap += 2.0 * kPi;
            corner.weak = corner.weak || gap < kNear_rad;
        }
        note_order(corner);
    }

    void note_order(const Corner& corner) {
        for (std::size_t k = 0; k < corner.order.size(); ++k)
            place_in_order_[static_cast<std::size_t>(corner.order[k].half.id())] = k;
    }

    /// The half that follows in the face to the left.
    [[nodiscard]] int after(int id) const {
        const int back = id ^ 1;
        const Corner& corner = corners_[static_cast<std::size_t>(start_of(back))];
        const std::size_t k = place_in_order_[static_cast<std::size_t>(back)];
        return corner.order[(k + corner.order.size() - 1) % corner.order.size()].half.id();
    }

    [[nodiscard]] std::vector<std::vector<int>> walks() const {
        std::vector<std::vector<int>> out;
        std::vector<bool> seen(place_in_order_.size(), false);
        for (const int l : lines_)
            for (const int first : {2 * l, 2 * l + 1}) {
                if (seen[static_cast<std::size_t>(first)]) continue;
                std::vector<int>& walk = out.emplace_back();
                for (int id = first; !seen[static_cast<std::size_t>(id)]; id = after(id)) {
                    seen[static_cast<std::size_t>(id)] = true;
                    walk.push_back(id);
                }
            }
        return out;
    }

    /// How far the face's border turns to the left in all.
    [[nodiscard]] double turn_of(const std::vector<int>& walk) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < walk.size(); ++k) {
            const double along = line_turn_[static_cast<std::size_t>(walk[k] / 2)];
            sum += walk[k] % 2 == 0 ? along : -along;
            const int back = walk[k] ^ 1, next = walk[(k + 1) % walk.size()];
            const Corner& corner = corners_[static_cast<std::size_t>(start_of(next))];
            if (corner.order.size() == 2) continue;  // within a chain
            const Leaving& in = corner.order[place_in_order_[static_cast<std::size_t>(back)]];
            const Leaving& on = corner.order[place_in_order_[static_cast<std::size_t>(next)]];
            double inner = in.angle - on.angle;
            if (inner <= 0.0) inner += 2.0 * kPi;
            if (!corner.flat) inner = std::acos(std::clamp(dot(in.way, on.way), -1.0, 1.0));
            sum += kPi - inner;
        }
        return sum;
    }

    [[nodiscard]] SpaceLine border_of(const std::vector<LineUse>& ring) const {
        SpaceLine border;
        for (const LineUse use : ring) {
            SpaceLine shape = resampled(line(use.line).shape, 12);
            if (use.reversed) std::reverse(shape.begin(), shape.end());
            border.insert(border.end(), shape.begin(), shape.end() - 1);
        }
        return border;
    }

    [[nodiscard]] double facing_of(const SpaceLine& border) const {
        Vec3 normal;
        for (std::size_t i = 0; i < border.size(); ++i)
            normal = normal + cross(border[i], border[(i + 1) % border.size()]);
        normal = normalised(normal);
        std::vector<double> cosines;
        for (const Vec3& p : border) cosines.push_back(dot(normal, normalised(body_.sample(p).gradient)));
        const auto tenth = cosines.begin() + static_cast<std::ptrdiff_t>(cosines.size() * 9 / 10);
        std::nth_element(cosines.begin(), tenth, cosines.end());
        return *tenth;
    }

    /// Whether a thread passes through the border.
    [[nodiscard]] bool is_opening(const std::vector<int>& walk) const {
        for (std::size_t t = 0; t < threads_.size(); ++t) {
            int sum = 0;
            for (const int id : walk) {
                const int passes = passes_[static_cast<std::size_t>(id / 2)][t];
                sum += id % 2 == 0 ? passes : -passes;
            }
            if (sum != 0) return true;
        }
        return false;
    }

    /// How well the orders about vertices go together: every face more is a handle less (Euler), and then pieces that
    /// turn once about themselves count, and openings that do not turn.
    [[nodiscard]] double merit() const {
        double sum = 0.0;
        for (const std::vector<int>& walk : walks()) {
            const double off = std::abs(turn_of(walk) - (is_opening(walk) ? 0.0 : 2.0 * kPi)) / (2.0 * kPi);
            sum += 10.0 + std::max(0.0, 1.0 - off);
        }
        return sum;
    }

    /// Whether the order is that of the angles, which then say how wide a corner is.
    [[nodiscard]] static bool is_turning(const Corner& corner) {
        std::size_t falls = 0;
        for (std::size_t k = 0; k < corner.order.size(); ++k)
            falls += corner.order[(k + 1) % corner.order.size()].angle < corner.order[k].angle ? 1U : 0U;
        return falls == 1;
    }

    /// Tries every order about the vertices where directions do not tell it surely.
    void improve() {
        double best = merit();
        for (int round = 0; round < kRounds; ++round) {
            const double before = best;
            for (Corner& corner : corners_) {
                if (!corner.weak || corner.order.size() < 3 || corner.order.size() > kMostTried) continue;
                std::vector<Leaving> kept = corner.order;
                for (const std::vector<Leaving>& order : orders_of(kept)) {
                    set_order(corner, order);
                    if (const double now = merit(); now > best + 1e-9) best = now, kept = order;
                }
                set_order(corner, kept);
            }
            if (best <= before + 1e-9 && !improve_two(best)) break;
        }
    }

    /// Tries all orders about two vertices at once that a line joins: at the ends of lines that lie nearly on each
    /// other one alone would make things worse.
    bool improve_two(double& best) {
        std::set<std::pair<int, int>> pairs;
        for (const int l : lines_) {
            const int a = std::min(line(l).from, line(l).to), b = std::max(line(l).from, line(l).to);
            if (a != b && can_turn(a) && can_turn(b)) pairs.insert({a, b});
        }
        for (const auto& [a, b] : pairs) {
            Corner &one = corners_[static_cast<std::size_t>(a)], &two = corners_[static_cast<std::size_t>(b)];
            const std::vector<Leaving> one_kept = one.order, two_kept = two.order;
            for (const std::vector<Leaving>& first : orders_of(one_kept))
                for (const std::vector<Leaving>& second : orders_of(two_kept)) {
                    set_order(one, first);
                    set_order(two, second);
                    if (const double now = merit(); now > best + 1e-9) {
                        best = now;
                        return true;
                    }
                }
            set_order(one, one_kept);
            set_order(two, two_kept);
        }
        return false;
    }

    [[nodiscard]] bool can_turn(int vertex) const {
        const Corner& corner = corners_[static_cast<std::size_t>(vertex)];
        return corner.weak && corner.order.size() > 2 && corner.order.size() < kMostTried;
    }

    /// All orders round a vertex, the first line kept.
    [[nodiscard]] static std::vector<std::vector<Leaving>> orders_of(const std::vector<Leaving>& order) {
        std::vector<std::size_t> rest(order.size() - 1);
        for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = k + 1;
        std::vector<std::vector<Leaving>> out;
        do {
            std::vector<Leaving>& one = out.emplace_back(order);
            for (std::size_t k = 0; k < rest.size(); ++k) one[k + 1] = order[rest[k]];
        } while (std::next_permutation(rest.begin(), rest.end()));
        return out;
    }

    void set_order(Corner& corner, const std::vector<Leaving>& order) {
        corner.order = order;
        corner.flat = is_turning(corner);
        note_order(corner);
    }

    const Network& net_;
    const Obstacle& body_;
    std::vector<SpaceLine> threads_;
    std::vector<int> lines_;
    std::vector<Corner> corners_;              // by vertex
    std::vector<std::size_t> place_in_order_;  // of each half about the vertex it leaves
    std::vector<double> line_turn_;
    std::vector<std::vector<int>> passes_;  // of each line: each thread through its cone
};

std::set<int> lines_of(const std::vector<LineUse>& ring) {
    std::set<int> out;
    for (const LineUse use : ring) out.insert(use.line);
    return out;
}

bool is_half_of(const NetworkRegion& region, LineUse use) {
    return std::find(region.ring.begin(), region.ring.end(), use) != region.ring.end();
}

}  // namespace

bool NetworkFace::is_cloth() const {
    return turn_rad > kPi && facing > kFacing && !is_opening;
}

std::vector<NetworkFace> find_faces(const Network& network, int layer, const Obstacle& body) {
    return FaceWalk(network, layer, body).faces();
}

std::vector<OpenFace> open_faces(const Network& network, int layer, const Obstacle& body) {
    std::vector<NetworkFace> cloth = find_faces(network, layer, body);
    std::erase_if(cloth, [](const NetworkFace& face) { return !face.is_cloth(); });
    std::vector<OpenFace> out;
    const auto known = [&](const NetworkFace& face) {
        const std::set<int> lines = lines_of(face.ring);
        return std::any_of(network.regions().begin(), network.regions().end(),
                           [&](const NetworkRegion& r) { return r.layer == layer && lines_of(r.ring) == lines; });
    };
    for (const NetworkFace& face : cloth) {
        if (known(face)) continue;
        const NetworkRegion* over = nullptr;
        for (const NetworkRegion& region : network.regions())
            for (const LineUse use : face.ring)
                if (region.alive && region.layer == layer && over == nullptr && is_half_of(region, use)) over = &region;
        if (over == nullptr) {
            out.push_back({face.ring, {}});
            continue;
        }
        // lines drawn across a piece: its border and both sides of these lines are the borders of its parts
        std::set<int> inner;  // halves that are not the piece's
        bool parts = true;
        for (const NetworkFace& other : cloth) {
            const bool touches =
                std::any_of(other.ring.begin(), other.ring.end(), [&](LineUse u) { return is_half_of(*over, u); });
            if (!touches) continue;
            for (const LineUse use : other.ring)
                if (!is_half_of(*over, use)) inner.insert(2 * use.line + (use.reversed ? 1 : 0));
        }
        for (const int half : inner) parts = parts && inner.count(half ^ 1) != 0;
        if (parts) out.push_back({face.ring, over->name});
    }
    return out;
}

std::vector<OpenEnd> open_ends(const Network& network, int layer) {
    std::vector<int> degree(network.vertices().size(), 0);
    for (const NetworkLine& line : network.lines())
        if (line.alive && line.layer == layer)
            ++degree[static_cast<std::size_t>(line.from)], ++degree[static_cast<std::size_t>(line.to)];
    std::vector<OpenEnd> out;
    for (std::size_t i = 0; i < network.lines().size(); ++i) {
        const NetworkLine& line = network.lines()[i];
        if (!line.alive || line.layer != layer) continue;
        for (const int v : {line.from, line.to}) {
            if (degree[static_cast<std::size_t>(v)] != 1) continue;
            const auto root = static_cast<std::size_t>(v == line.from ? line.to : line.from);
            if (degree[root] > 2 && line_length(line.shape) < 2.0 * network.options().snap_cm) continue;
            const NetworkVertex& vertex = network.vertices()[static_cast<std::size_t>(v)];
            OpenEnd end{vertex.place, network.piece_name(static_cast<int>(i)), 0.0, {}, {}};
            double least = std::numeric_limits<double>::max();
            for (std::size_t k = 0; k < network.lines().size(); ++k) {
                const NetworkLine& other = network.lines()[k];
                if (!other.alive || other.layer != layer) continue;
                NearestOnLine near;
                if (k == i) {  // its own other end
                    near.place =
                        network.vertices()[static_cast<std::size_t>(v == line.from ? line.to : line.from)].place;
                    near.distance = length(near.place - vertex.place);
                } else {
                    near = nearest_on_line(other.shape, vertex.place);
                }
                if (near.distance >= least) continue;
                least = near.distance;
                end.gap_cm = near.distance;
                end.nearest = network.piece_name(static_cast<int>(k));
                end.nearest_place = near.place;
            }
            out.push_back(std::move(end));
        }
    }
    return out;
}

std::vector<std::string> names_of_ring(const Network& network, int layer, const std::vector<LineUse>& ring) {
    const std::set<int> lines = lines_of(ring);
    std::vector<std::string> names;
    for (const LineUse use : ring) {
        const std::string& name = network.lines()[static_cast<std::size_t>(use.line)].name;
        bool whole = true;
        for (std::size_t i = 0; i < network.lines().size(); ++i) {
            const NetworkLine& other = network.lines()[i];
            if (other.alive && other.layer == layer && other.name == name)
                whole = whole && lines.count(static_cast<int>(i)) != 0;
        }
        const std::string piece = whole ? name : network.piece_name(use.line);
        if (std::find(names.begin(), names.end(), piece) == names.end()) names.push_back(piece);
    }
    return names;
}

}  // namespace core
