#include "core/exchange/svg_path.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace core {
namespace {

constexpr double kPi = std::numbers::pi;

/// Numbers separated by white space, one comma, or nothing where a sign or point tells them apart.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    void skip_separators() {
        while (at_ < text_.size() && (std::isspace(byte()) || text_[at_] == ',')) ++at_;
    }
    [[nodiscard]] bool done() {
        skip_separators();
        return at_ >= text_.size();
    }
    [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip() { ++at_; }
    [[nodiscard]] bool at_letter() {
        skip_separators();
        return at_ < text_.size() && std::isalpha(byte());
    }
    std::string_view word() {
        const std::size_t start = at_;
        while (at_ < text_.size() && std::isalpha(byte())) ++at_;
        return text_.substr(start, at_ - start);
    }

    bool number(double& value) {
        skip_separators();
        if (at_ < text_.size() && text_[at_] == '+') ++at_;
        const auto [end, failure] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (failure != std::errc() || !std::isfinite(value)) return false;
        at_ = static_cast<std::size_t>(end - text_.data());
        return true;
    }
    /// The flags of an arc may stand without a separator: "a1 1 0 01 5 5".
    bool flag(bool& value) {
        skip_separators();
        if (peek() != '0' && peek() != '1') return false;
        value = text_[at_++] == '1';
        return true;
    }

  private:
    [[nodiscard]] unsigned char byte() const { return static_cast<unsigned char>(text_[at_]); }
    std::string_view text_;
    std::size_t at_ = 0;
};

class PathReader {
  public:
    explicit PathReader(std::string_view data) : scan_(data) {}

    std::optional<std::vector<Polyline>> read() {
        char command = '\0';
        while (!scan_.done()) {
            if (scan_.at_letter()) {
                command = scan_.peek();
                scan_.skip();
            } else if (command == 'M' || command == 'm') {
                command = command == 'M' ? 'L' : 'l';  // further pairs after a move are lines
            } else if (command == 'Z' || command == 'z') {
                return std::nullopt;
            }
            if (!started_ && command != 'M' && command != 'm') return std::nullopt;
            if (!segment(command) || points_ > kMaxSvgPoints) return std::nullopt;
        }
        return std::move(subpaths_);
    }

  private:
    bool segment(char command) {
        relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        bool good = false;
        switch (kind) {
            case 'M':
                good = move();
                break;
            case 'L':
                good = line();
                break;
            case 'H':
                good = horizontal();
                break;
            case 'V':
                good = vertical();
                break;
            case 'C':
                good = cubic(false);
                break;
            case 'S':
                good = cubic(true);
                break;
            case 'Q':
                good = quadratic(false);
                break;
            case 'T':
                good = quadratic(true);
                break;
            case 'A':
                good = arc();
                break;
            case 'Z':
                good = close();
                break;
            default:
                break;
        }
        last_ = kind;
        return good;
    }

    bool pair(Point& p) {
        if (!scan_.number(p.x) || !scan_.number(p.y)) return false;
        if (relative_) p = p + here_;
        return true;
    }
    void to(Point p) {
        if (subpaths_.empty() || closed_) {  // a command after Z goes on from the closed subpath's start
            subpaths_.push_back({here_});
            closed_ = false;
        }
        subpaths_.back().push_back(p);
        here_ = p;
        ++points_;
    }

    bool move() {
        Point p;
        if (!pair(p)) return false;
        start_ = here_ = p;
        started_ = true;
        closed_ = false;
        subpaths_.push_back({here_});
        ++points_;
        return true;
    }
    bool line() {
        Point p;
        if (!pair(p)) return false;
        to(p);
        return true;
    }
    bool horizontal() {
        double x = 0.0;
        if (!scan_.number(x)) return false;
        to({relative_ ? here_.x + x : x, here_.y});
        return true;
    }
    bool vertical() {
        double y = 0.0;
        if (!scan_.number(y)) return false;
        to({here_.x, relative_ ? here_.y + y : y});
        return true;
    }
    bool close() {
        if (!closed_) to(start_);
        here_ = start_;
        closed_ = true;
        return true;
    }

    bool cubic(bool smooth) {
        Point c1 = last_ == 'C' || last_ == 'S' ? here_ * 2.0 - control_ : here_;
        Point c2, end;
        if ((!smooth && !pair(c1)) || !pair(c2) || !pair(end)) return false;
        const Point from = here_;
        for (int i = 1; i <= kChordsPerCurve; ++i) {
            const double t = static_cast<double>(i) / kChordsPerCurve, s = 1.0 - t;
            to(from * (s * s * s) + c1 * (3 * s * s * t) + c2 * (3 * s * t * t) + end * (t * t * t));
        }
        control_ = c2;
        return true;
    }
    bool quadratic(bool smooth) {
        Point c = last_ == 'Q' || last_ == 'T' ? here_ * 2.0 - control_ : here_;
        Point end;
        if ((!smooth && !pair(c)) || !pair(end)) return false;
        const Point from = here_;
        for (int i = 1; i <= kChordsPerCurve; ++i) {
            const double t = static_cast<double>(i) / kChordsPerCurve, s = 1.0 - t;
            to(from * (s * s) + c * (2 * s * t) + end * (t * t));
        }
        control_ = c;
        return true;
    }

    /// SVG 1.1, appendix F.6: from end points to a centre, radii enlarged where they are too small.
    bool arc() {
        double rx = 0.0, ry = 0.0, turn_deg = 0.0;
        bool large = false, sweep = false;
        Point end;
        if (!scan_.number(rx) || !scan_.number(ry) || !scan_.number(turn_deg) || !scan_.flag(large) ||
            !scan_.flag(sweep) || !pair(end)) {
            return false;
        }
        rx = std::abs(rx);
        ry = std::abs(ry);
        if (rx == 0.0 || ry == 0.0 || end == here_) {
            to(end);
            return true;
        }
        const double turn = turn_deg * kPi / 180.0, cos_t = std::cos(turn), sin_t = std::sin(turn);
        const Point half = (here_ - end) * 0.5;
        const Point p{cos_t * half.x + sin_t * half.y, -sin_t * half.x + cos_t * half.y};
        const double excess = (p.x / rx) * (p.x / rx) + (p.y / ry) * (p.y / ry);
        if (excess > 1.0) {
            rx *= std::sqrt(excess);
            ry *= std::sqrt(excess);
        }
        const double apart = (p.x / rx) * (p.x / rx) + (p.y / ry) * (p.y / ry);
        const double k =
            (large == sweep ? -1.0 : 1.0) * std::sqrt(std::max(0.0, (1.0 - apart) / std::max(apart, 1e-300)));
        const Point c{k * rx * p.y / ry, -k * ry * p.x / rx};
        const Point centre = Point{cos_t * c.x - sin_t * c.y, sin_t * c.x + cos_t * c.y} + midpoint(here_, end);
        const double from = std::atan2((p.y - c.y) / ry, (p.x - c.x) / rx);
        double sweep_angle = std::atan2((-p.y - c.y) / ry, (-p.x - c.x) / rx) - from;
        if (sweep && sweep_angle < 0.0) sweep_angle += 2 * kPi;
        if (!sweep && sweep_angle > 0.0) sweep_angle -= 2 * kPi;
        if (!std::isfinite(sweep_angle)) return false;
        const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(sweep_angle) / (kPi / 16))));
        for (int i = 1; i < chords; ++i) {
            const double angle = from + sweep_angle * i / chords;
            const Point q{rx * std::cos(angle), ry * std::sin(angle)};
            to(centre + Point{cos_t * q.x - sin_t * q.y, sin_t * q.x + cos_t * q.y});
        }
        to(end);
        return true;
    }

    Scanner scan_;
    std::vector<Polyline> subpaths_;
    std::size_t points_ = 0;
    Point here_, start_, control_;
    char last_ = '\0';
    bool relative_ = false, closed_ = false, started_ = false;
};

/// One transform from its name and its numbers.
std::optional<Affine> named_transform(std::string_view name, const std::array<double, 6>& v, std::size_t count) {
    const double angle = v[0] * kPi / 180.0;
    if (name == "matrix" && count == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (count == 1 || count == 2)) return Affine{1, 0, 0, 1, v[0], v[1]};
    if (name == "scale" && count == 1) return Affine{v[0], 0, 0, v[0], 0, 0};
    if (name == "scale" && count == 2) return Affine{v[0], 0, 0, v[1], 0, 0};
    if (name == "skewX" && count == 1) return Affine{1, 0, std::tan(angle), 1, 0, 0};
    if (name == "skewY" && count == 1) return Affine{1, std::tan(angle), 0, 1, 0, 0};
    if (name == "rotate" && (count == 1 || count == 3)) {
        const Affine turn{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
        return Affine{1, 0, 0, 1, v[1], v[2]}.after(turn).after({1, 0, 0, 1, -v[1], -v[2]});
    }
    return std::nullopt;
}

}  // namespace

Affine Affine::after(const Affine& inner) const {
    return {a * inner.a + c * inner.b, b * inner.a + d * inner.b,     a * inner.c + c * inner.d,
            b * inner.c + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
}

std::optional<std::vector<Polyline>> parse_svg_path(std::string_view data) {
    return PathReader(data).read();
}

std::optional<Polyline> parse_svg_points(std::string_view data) {
    Scanner scan(data);
    Polyline points;
    while (!scan.done()) {
        Point p;
        if (points.size() >= kMaxSvgPoints || !scan.number(p.x) || !scan.number(p.y)) return std::nullopt;
        points.push_back(p);
    }
    return points;
}

std::optional<Affine> parse_svg_transform(std::string_view text) {
    Scanner scan(text);
    Affine total;
    while (!scan.done()) {
        const std::string_view name = scan.word();
        scan.skip_separators();
        if (name.empty() || scan.peek() != '(') return std::nullopt;
        scan.skip();
        std::array<double, 6> values{};
        std::size_t count = 0;
        for (scan.skip_separators(); scan.peek() != ')'; scan.skip_separators()) {
            if (count == values.size() || !scan.number(values[count])) return std::nullopt;
            ++count;
        }
        scan.skip();
        const std::optional<Affine> next = named_transform(name, values, count);
        if (!next) return std::nullopt;
        total = total.after(*next);
    }
    return total;
}

std::optional<double> parse_svg_length(std::string_view text) {
    Scanner scan(text);
    if (scan.done()) return 0.0;
    double value = 0.0;
    if (!scan.number(value)) return std::nullopt;
    return value;
}

Polyline ellipse_chain(Point centre, double radius_x, double radius_y) {
    constexpr int kChords = 64;
    Polyline chain;
    for (int i = 0; i <= kChords; ++i) {
        const double angle = 2 * kPi * (i % kChords) / kChords;
        chain.push_back({centre.x + radius_x * std::cos(angle), centre.y + radius_y * std::sin(angle)});
    }
    return chain;
}

}  // namespace core
