#include "core/mannequin/body_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/mesh/plane_section.hpp"

namespace core {
namespace {

constexpr double kStep = 0.006;  // between cuts, of the stature
/// Of the reference woman, 168 cm: bust and what is below it, of the stature; the knee, of the crotch's height; the
/// elbow, of the arm from shoulder to wrist; the nape below the middle of the neck.
constexpr double kBust = 0.714, kUnderBust = 0.042, kKnee = 0.6, kElbow = 0.574, kNape = 0.019;
constexpr double kSmallPiece = 0.12;  // of the largest piece's girth: fingers and thumbs are left out

/// One connected piece of a level cut.
struct Piece {
    std::vector<Vec3> points;
    Vec3 middle;  // of its bounding box
    double left = 0.0, right = 0.0, girth = 0.0;
};

struct Level {
    double y = 0.0;
    std::vector<Piece> pieces;
    [[nodiscard]] const Piece* trunk() const {
        const Piece* best = nullptr;
        for (const Piece& p : pieces)
            if (p.right < 0.0 && p.left > 0.0 && (best == nullptr || p.girth > best->girth)) best = &p;
        return best;
    }
    /// The piece farthest out on a side that does not cross the middle: an arm above the crotch, a leg below.
    [[nodiscard]] const Piece* beside(double sign) const {
        const Piece* best = nullptr;
        for (const Piece& p : pieces)
            if (p.right * p.left > 0.0 && p.middle.x * sign > 0.0 && (best == nullptr || p.girth > best->girth))
                best = &p;
        return best;
    }
};

class Finder {
  public:
    explicit Finder(const TriangleMesh& body) : body_(body) {
        mesh_.vertices = body.vertices;
        for (const auto& t : body.triangles) mesh_.quads.push_back({t[0], t[1], t[2], t[2]});
        for (const Vec3& v : body.vertices) stature_ = std::max(stature_, v.y);
    }

    bool run() {
        if (!find_crotch()) return false;
        for (double y = crotch_ + kStep * stature_; y < 0.93 * stature_; y += kStep * stature_)
            levels_.push_back(cut(y));
        return find_armpit() && find_levels() && follow_arm(1.0) && follow_arm(-1.0) && find_legs();
    }

    FoundBody finish() && {
        FoundBody out;
        out.landmarks = std::move(landmarks_);
        for (const auto& t : body_.triangles) {
            const Vec3 p = (body_.vertices[t[0]] + body_.vertices[t[1]] + body_.vertices[t[2]]) * (1.0 / 3.0);
            out.part_of_triangle.push_back(part_at(p));
        }
        return out;
    }

  private:
    [[nodiscard]] Level cut(double y) const {
        Level level{y, {}};
        double largest = 0.0;
        for (const std::vector<Point>& points : plane_section(mesh_, {{0, y, 0}, {1, 0, 0}, {0, 0, -1}})) {
            Piece piece;
            Vec3 low{1e300, y, 1e300}, high{-1e300, y, -1e300};
            for (const Point p : points) {
                piece.points.push_back({p.x, y, -p.y});
                low = {std::min(low.x, p.x), y, std::min(low.z, -p.y)};
                high = {std::max(high.x, p.x), y, std::max(high.z, -p.y)};
            }
            piece.right = low.x, piece.left = high.x;
            piece.middle = (low + high) * 0.5;
            piece.girth = hull_length(points);
            largest = std::max(largest, piece.girth);
            level.pieces.push_back(std::move(piece));
        }
        std::erase_if(level.pieces, [&](const Piece& p) { return p.girth < kSmallPiece * largest; });
        return level;
    }

    bool find_crotch() {
        double low = 0.3 * stature_, high = 0.0;
        for (double y = low; y < 0.62 * stature_ && high == 0.0; y += 0.01 * stature_)
            (cut(y).trunk() != nullptr ? high : low) = y;
        if (high == 0.0 || low >= high) return false;
        while (high - low > 0.05) {
            const double middle = 0.5 * (low + high);
            (cut(middle).trunk() != nullptr ? high : low) = middle;
        }
        crotch_ = high;
        const Level level = cut(crotch_ + 0.2);
        if (level.trunk() == nullptr) return false;
        add("crotch", {0.0, crotch_, level.trunk()->middle.z});
        return true;
    }

    /// The highest level below which both arms are on their own.
    bool find_armpit() {
        for (std::size_t i = levels_.size(); i-- > 0;) {
            const Level& level = levels_[i];
            if (level.y > 0.88 * stature_ || level.trunk() == nullptr) continue;
            const Piece *left = level.beside(1.0), *right = level.beside(-1.0);
            if (left == nullptr || right == nullptr || left->left < level.trunk()->left) continue;
            if (level.y < crotch_ + 0.1 * stature_) return false;
            armpit_ = i;
            gap_ = 0.5 * (level.trunk()->left + left->right);
            return gap_ > 0.0;
        }
        return false;
    }

    /// Height of the level between two heights whose trunk is narrowest (sign 1) or widest (sign -1).
    [[nodiscard]] double extreme(double from, double to, double sign) const {
        double best = std::numeric_limits<double>::max(), at = 0.5 * (from + to);
        for (const Level& level : levels_) {
            if (level.y < from || level.y > to || level.trunk() == nullptr) continue;
            if (sign * level.trunk()->girth < best) best = sign * level.trunk()->girth, at = level.y;
        }
        return at;
    }

    bool find_levels() {
        const double top = levels_[armpit_].y;
        const double bust = std::min(kBust * stature_, top - 0.003 * stature_);
        neck_ = extreme(top + 0.04 * stature_, 0.9 * stature_, 1.0);
        waist_ = extreme(crotch_ + 0.08 * stature_, bust - 0.05 * stature_, 1.0);
        const double hip = extreme(crotch_ + 0.02 * stature_, waist_ - 0.03 * stature_, -1.0);
        const std::array<std::pair<const char*, double>, 5> rows{{{"bust", bust},
                                                                  {"under_bust", bust - kUnderBust * stature_},
                                                                  {"waist", waist_},
                                                                  {"hip", hip},
                                                                  {"neck", neck_}}};
        for (const auto& [name, y] : rows)
            if (!add_level(name, y)) return false;
        nape_ = neck_ - kNape * stature_;
        const Level nape = cut(nape_);
        if (nape.trunk() == nullptr) return false;
        add("nape", in_front(*nape.trunk(), 0.0, -1.0));
        return true;
    }

    /// The point of a piece farthest to the front (sign 1) or back (-1), near x.
    [[nodiscard]] static Vec3 in_front(const Piece& piece, double x, double sign) {
        const double near = std::max(1.0, 0.12 * (piece.left - piece.right));
        Vec3 best = piece.middle;
        double most = -std::numeric_limits<double>::max();
        for (const Vec3& p : piece.points)
            if (std::abs(p.x - x) < near && sign * p.z > most) most = sign * p.z, best = {x, p.y, p.z};
        return best;
    }
    [[nodiscard]] static Vec3 to_side(const Piece& piece, double z, double sign) {
        const double near = std::max(1.0, 0.06 * piece.girth);
        Vec3 best = piece.middle;
        double most = -std::numeric_limits<double>::max();
        for (const Vec3& p : piece.points)
            if (std::abs(p.z - z) < near && sign * p.x > most) most = sign * p.x, best = {p.x, p.y, z};
        return best;
    }

    bool add_level(const std::string& name, double y) {
        const Level level = cut(y);
        const Piece* trunk = level.trunk();
        if (trunk == nullptr) return false;
        const Vec3 front = in_front(*trunk, 0.0, 1.0), back = in_front(*trunk, 0.0, -1.0);
        const double z = 0.5 * (front.z + back.z);
        add(name + "_front", front);
        add(name + "_back", back);
        add(name + "_left", to_side(*trunk, z, 1.0));
        add(name + "_right", to_side(*trunk, z, -1.0));
        return true;
    }

    /// Shoulder, elbow and wrist of one arm, down its cuts from the armpit.
    bool follow_arm(double sign) {
        const std::string side = sign > 0.0 ? "_left" : "_right";
        Vec3 shoulder{sign * gap_, 0.0, levels_[armpit_].trunk()->middle.z};
        for (const auto& points : plane_section(mesh_, {{sign * gap_, 0, 0}, {0, 0, 1}, {0, 1, 0}}))
            for (const Point p : points)
                if (p.y > shoulder.y) shoulder = {shoulder.x, p.y, p.x};
        std::vector<const Piece*> arm;
        for (std::size_t i = armpit_ + 1; i-- > 0;) {
            const Piece* piece = levels_[i].beside(sign);
            if (piece == nullptr || levels_[i].trunk() == nullptr) break;
            if (!arm.empty() && length(piece->middle - arm.back()->middle) > 0.06 * stature_) break;
            arm.push_back(piece);
        }
        if (arm.size() < 8) return false;
        const auto share = [&](double s) { return static_cast<std::size_t>(s * static_cast<double>(arm.size() - 1)); };
        std::size_t wrist = share(0.5);
        for (std::size_t i = share(0.5); i < share(0.85); ++i)
            if (arm[i]->girth < arm[wrist]->girth) wrist = i;
        const Vec3 at_wrist = in_front(*arm[wrist], arm[wrist]->middle.x, 1.0);
        const double elbow_y = shoulder.y + kElbow * (at_wrist.y - shoulder.y);
        const auto elbow = std::min_element(arm.begin(), arm.end(), [&](const Piece* a, const Piece* b) {
            return std::abs(a->middle.y - elbow_y) < std::abs(b->middle.y - elbow_y);
        });
        add("shoulder" + side, shoulder);
        add("elbow" + side, in_front(**elbow, (*elbow)->middle.x, 1.0));
        add("wrist" + side, at_wrist);
        return true;
    }

    bool find_legs() {
        double ankle = 0.0, least = std::numeric_limits<double>::max();
        for (double y = 0.045 * stature_; y < 0.12 * stature_; y += kStep * stature_) {
            const Level level = cut(y);
            const Piece* piece = level.beside(1.0);
            if (piece != nullptr && piece->girth < least) least = piece->girth, ankle = y;
        }
        const Level knees = cut(kKnee * crotch_), ankles = cut(ankle);
        for (const double sign : {1.0, -1.0}) {
            const std::string side = sign > 0.0 ? "_left" : "_right";
            const Piece *at_knee = knees.beside(sign), *at_ankle = ankles.beside(sign);
            if (at_knee == nullptr || at_ankle == nullptr) return false;
            add("knee" + side, in_front(*at_knee, at_knee->middle.x, 1.0));
            add("ankle" + side, to_side(*at_ankle, at_ankle->middle.z, sign));
        }
        return true;
    }

    /// Where arms end and the trunk begins at a height.
    [[nodiscard]] double arm_gap(double y) const {
        if (y >= levels_[armpit_].y) return gap_;
        const auto i = static_cast<std::size_t>(
            std::clamp((y - levels_.front().y) / (kStep * stature_), 0.0, static_cast<double>(armpit_)));
        const Piece *trunk = levels_[i].trunk(), *arm = levels_[i].beside(1.0);
        return trunk != nullptr && arm != nullptr ? 0.5 * (trunk->left + arm->right) : gap_ + 0.1 * stature_;
    }

    [[nodiscard]] BodyPart part_at(Vec3 p) const {
        if (p.y > neck_ + 0.012 * stature_) return BodyPart::Head;
        if (std::abs(p.x) > arm_gap(p.y) && p.y > 0.75 * crotch_)
            return p.x > 0 ? BodyPart::ArmLeft : BodyPart::ArmRight;
        if (p.y < crotch_) return p.x > 0 ? BodyPart::LegLeft : BodyPart::LegRight;
        if (p.y > nape_) return BodyPart::Neck;
        return p.y < waist_ ? BodyPart::Hips : BodyPart::Torso;
    }

    void add(std::string name, Vec3 place) { landmarks_.push_back({std::move(name), place}); }

    const TriangleMesh& body_;
    QuadMesh mesh_;
    std::vector<Level> levels_;  // from the crotch up
    std::vector<Landmark> landmarks_;
    double stature_ = 0.0, crotch_ = 0.0, waist_ = 0.0, neck_ = 0.0, nape_ = 0.0, gap_ = 0.0;
    std::size_t armpit_ = 0;
};

}  // namespace

std::optional<FoundBody> find_body(const TriangleMesh& body) {
    if (body.empty()) return std::nullopt;
    Finder finder(body);
    if (!finder.run()) return std::nullopt;
    return std::move(finder).finish();
}

}  // namespace core
