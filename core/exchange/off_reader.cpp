#include "core/exchange/off_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/mesh/mesh_welder.hpp"
#include "core/mesh/triangulate_face.hpp"

namespace core {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f' || c == ',';
}

/// The words of a text one after the other, comments left out, lines counted.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}

    /// The next word on any line; empty at the end.
    std::string_view next() {
        skip(false);
        return take();
    }
    /// The next word of this line; empty when the line ends.
    std::string_view next_on_line() {
        skip(true);
        return at_ < text_.size() && text_[at_] == '\n' ? std::string_view{} : take();
    }
    void skip_line() {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    }
    [[nodiscard]] std::size_t left() const { return text_.size() - at_; }
    [[nodiscard]] std::size_t line() const { return line_; }
    void push_back(std::string_view rest_of_last_word) { at_ -= rest_of_last_word.size(); }

  private:
    void skip(bool stop_at_line_end) {
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '\n') {
                if (stop_at_line_end) return;
                ++line_;
            } else if (c == '#') {
                skip_line();
                --at_;
            } else if (!is_space(c)) {
                return;
            }
        }
    }
    std::string_view take() {
        const std::size_t from = at_;
        while (at_ < text_.size() && !is_space(text_[at_]) && text_[at_] != '#') ++at_;
        return text_.substr(from, at_ - from);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

template <typename Number>
std::optional<Number> number(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if constexpr (std::is_floating_point_v<Number>) {
        // Too large counts as not finite, too small as 0: neither spoils the file.
        if (fault == std::errc::result_out_of_range) return word.find("e-") == word.npos ? HUGE_VAL : 0.0;
    }
    if (fault != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

class OffText {
  public:
    explicit OffText(std::string_view text) : words_(text) {}

    Result<TriangleMesh> read() {
        if (Result<void> done = read_header(); !done) return unexpected(done.error());
        if (Result<void> done = read_vertices(); !done) return unexpected(done.error());
        for (std::size_t i = 0; i < face_count_; ++i) {
            if (Result<void> done = read_face(); !done) return unexpected(done.error());
        }
        if (welder_.triangle_count() == 0) {
            return unexpected(ErrorCode::EmptyMesh, "the mesh has no usable faces; export it with its surface");
        }
        return std::move(welder_).finish();
    }

  private:
    Unexpected fault(std::string what, ErrorCode code = ErrorCode::BadFormat) const {
        return unexpected(code, "line " + std::to_string(words_.line()) + " of the OFF text " + std::move(what));
    }

    Result<void> read_header() {
        const std::string_view word = words_.next();
        const std::size_t off = word.find("OFF");
        if (off != word.npos) {
            if (Result<void> done = take_prefix(word.substr(0, off)); !done) return done;
            words_.push_back(word.substr(off + 3));
        } else {
            words_.push_back(word);
        }
        std::string_view first = words_.next();
        if (first == "BINARY") return fault("says that it is binary, which is not read; export it as text");
        const auto vertices = number<std::uint64_t>(first), faces = number<std::uint64_t>(words_.next());
        if (!vertices || !faces) return fault("should give the numbers of vertices and faces; is this an OFF file?");
        words_.next_on_line();  // the number of edges, which nobody fills in
        words_.skip_line();
        // A vertex takes at least "0 0 0", a face "0", and a break each; UINT32_MAX is kept for "none".
        if (*vertices > words_.left() / 6 + 1 || *faces > words_.left() / 2 + 1 || *vertices >= UINT32_MAX) {
            return fault("promises more vertices and faces than the file holds; it is cut short or damaged");
        }
        vertex_count_ = *vertices;
        face_count_ = *faces;
        return {};
    }

    Result<void> take_prefix(std::string_view prefix) {
        for (const char c : prefix) {
            if (c == '4' || c == 'n')
                return fault("announces points of other than three dimensions, which are not read");
            if (c == 'C') vertex_colours_ = true;
            if (c == 'N') numbers_before_colour_ += 3;
        }
        return {};
    }

    Result<void> read_vertices() {
        corners_.reserve(vertex_count_);
        for (std::size_t i = 0; i < vertex_count_; ++i) {
            std::array<double, 3> xyz{};
            for (double& value : xyz) {
                const std::string_view word = words_.next();
                if (word.empty()) return fault("is the last, but vertices are missing; the file is cut short");
                const std::optional<double> read = number<double>(word);
                if (!read) return fault("should hold a vertex but has a word that is no number; export the mesh again");
                value = *read;
            }
            corners_.push_back({{xyz[0], xyz[1], xyz[2]}, Rgb{}});
            if (vertex_colours_) {
                for (int k = 0; k < numbers_before_colour_; ++k) words_.next_on_line();
                if (const auto colour = read_colour()) corners_.back().colour = *colour;
            }
            words_.skip_line();
        }
        return {};
    }

    Result<void> read_face() {
        const std::string_view word = words_.next();
        if (word.empty()) return fault("is the last, but faces are missing; the file is cut short");
        const auto count = number<std::uint64_t>(word);
        if (!count || *count > words_.left()) return fault("should begin with the number of a face's corners");
        face_.clear();
        for (std::uint64_t k = 0; k < *count; ++k) {
            const auto index = number<std::int64_t>(words_.next());
            if (!index) return fault("should hold a face's corner numbers; the file is cut short or damaged");
            if (*index < 0 || static_cast<std::uint64_t>(*index) >= corners_.size()) {
                return fault("has a face with corner " + std::to_string(*index) + ", but there are only " +
                                 std::to_string(corners_.size()) + " vertices; export the mesh again",
                             ErrorCode::BadMesh);
            }
            face_.push_back(corners_[static_cast<std::size_t>(*index)]);
        }
        if (const auto colour = read_colour()) {
            for (MeshWelder::Corner& corner : face_) corner.colour = *colour;
        }
        words_.skip_line();
        add_face();
        return {};
    }

    /// Three or four numbers up to the end of the line; fewer are no colour (one is a place in a colour table).
    std::optional<Rgb> read_colour() {
        std::array<double, 4> values{};
        std::size_t count = 0;
        bool has_point = false;
        for (std::string_view w = words_.next_on_line(); !w.empty() && count < 4; w = words_.next_on_line()) {
            const std::optional<double> value = number<double>(w);
            if (!value || !std::isfinite(*value)) return std::nullopt;
            has_point = has_point || w.find('.') != w.npos;
            values[count++] = *value;
        }
        if (count < 3) return std::nullopt;
        // "1 0 0" is rather red than nearly black.
        const bool fractions = has_point || *std::max_element(values.begin(), values.end()) <= 1.0;
        const auto byte = [fractions](double v) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(fractions ? v * 255.0 : v, 0.0, 255.0)));
        };
        return Rgb{byte(values[0]), byte(values[1]), byte(values[2])};
    }

    void add_face() {
        if (face_.size() == 3) return welder_.add(face_[0], face_[1], face_[2]);
        places_.clear();
        for (const MeshWelder::Corner& corner : face_) {
            if (!is_usable(corner.position)) return;
            places_.push_back(corner.position);
        }
        cut_.clear();
        triangulate_face(places_, cut_);
        for (const auto& [a, b, c] : cut_) welder_.add(face_[a], face_[b], face_[c]);
    }

    Words words_;
    bool vertex_colours_ = false;
    int numbers_before_colour_ = 0;
    std::size_t vertex_count_ = 0;
    std::size_t face_count_ = 0;
    std::vector<MeshWelder::Corner> corners_;
    MeshWelder welder_;
    // Of the face at hand, kept so that a face needs no new memory.
    std::vector<MeshWelder::Corner> face_;
    std::vector<Vec3> places_;
    std::vector<std::array<std::uint32_t, 3>> cut_;
};

}  // namespace

Result<TriangleMesh> read_off(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return OffText(text).read();
}

}  // namespace core
