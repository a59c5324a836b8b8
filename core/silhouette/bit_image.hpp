#pragma once
// Binary images of one bit a pixel, and their connected parts found run by run: a page of 512² pixels is 32 kB, and its
// parts cost as much as it has runs, not pixels.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

class BitImage {
  public:
    BitImage() = default;
    BitImage(int width, int height, bool value = false);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int words() const { return words_; }
    [[nodiscard]] std::uint64_t* row(int y) { return bits_.data() + index(y); }
    [[nodiscard]] const std::uint64_t* row(int y) const { return bits_.data() + index(y); }
    [[nodiscard]] bool at(int x, int y) const { return (row(y)[x / 64] >> (x % 64) & 1U) != 0; }
    /// Sets pixels x0 … x1 of a row; those outside the image are passed over.
    void set_run(int y, int x0, int x1);
    void clear_run(int y, int x0, int x1);
    void fill(bool value);
    /// Pixels x0 … x0 + count - 1 of a row as bytes of 0 and 1. Inside the image.
    void copy_bytes(int y, int x0, int count, std::uint8_t* out) const;
    friend bool operator==(const BitImage&, const BitImage&) = default;

  private:
    [[nodiscard]] std::size_t index(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(words_);
    }
    int width_ = 0, height_ = 0, words_ = 0;
    std::vector<std::uint64_t> bits_;  ///< pixels beyond the width are 0
};

/// Pixels x0 … x1 of row y, all of one value, none of it beside them. x1 >= x0.
struct BitRun {
    int y = 0, x0 = 0, x1 = 0;
    int part = 0;  ///< number of the connected part that it belongs to
};

/// The connected parts of one value of a BitImage, by union-find over its runs. Holds its memory, so that asking again
/// allocates nothing. Parts are numbered from 0 in the order of their first run, rows first.
class RunParts {
  public:
    enum class Joined { BySides, ByCorners };  ///< 4 or 8 neighbours

    /// Finds the parts of the pixels with `value` in rows top … bottom. Linear in the words and runs of those rows.
    void find(const BitImage& image, bool value, Joined joined, int top, int bottom);

    [[nodiscard]] const std::vector<BitRun>& runs() const { return runs_; }  ///< row by row, left to right
    [[nodiscard]] int count() const { return count_; }

  private:
    void append_runs(const std::uint64_t* row, const BitImage& image, bool value, int y);
    void join_rows(std::size_t above, std::size_t here, std::size_t end, int reach);
    [[nodiscard]] int root_of(int run);

    std::vector<BitRun> runs_;
    std::vector<int> parent_;
    int count_ = 0;
};

}  // namespace core
