#include "core/silhouette/bit_image.hpp"

#include <algorithm>
#include <bit>

namespace core {
namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};

/// Calls change(word, mask) for the words that hold pixels x0 … x1.
template <typename Change>
void each_word(std::uint64_t* row, int x0, int x1, Change change) {
    const int first = x0 / 64, last = x1 / 64;
    const std::uint64_t from = kAll << (x0 % 64), to = kAll >> (63 - x1 % 64);
    if (first == last) {
        change(row[first], from & to);
        return;
    }
    change(row[first], from);
    for (int w = first + 1; w < last; ++w) change(row[w], kAll);
    change(row[last], to);
}

}  // namespace

BitImage::BitImage(int width, int height, bool value) : width_(width), height_(height), words_((width + 63) / 64) {
    bits_.resize(static_cast<std::size_t>(words_) * static_cast<std::size_t>(height));
    fill(value);
}

void BitImage::fill(bool value) {
    std::fill(bits_.begin(), bits_.end(), 0);
    if (!value) return;
    for (int y = 0; y < height_; ++y) set_run(y, 0, width_ - 1);
}

void BitImage::set_run(int y, int x0, int x1) {
    if (y < 0 || y >= height_) return;
    x0 = std::max(x0, 0);
    x1 = std::min(x1, width_ - 1);
    if (x0 <= x1) each_word(row(y), x0, x1, [](std::uint64_t& word, std::uint64_t mask) { word |= mask; });
}

void BitImage::clear_run(int y, int x0, int x1) {
    if (y < 0 || y >= height_) return;
    x0 = std::max(x0, 0);
    x1 = std::min(x1, width_ - 1);
    if (x0 <= x1) each_word(row(y), x0, x1, [](std::uint64_t& word, std::uint64_t mask) { word &= ~mask; });
}

void BitImage::copy_bytes(int y, int x0, int count, std::uint8_t* out) const {
    const std::uint64_t* words = row(y);
    for (int i = 0; i < count;) {
        const int x = x0 + i, in_word = std::min(64 - x % 64, count - i);
        std::uint64_t word = words[x / 64] >> (x % 64);
        for (int k = 0; k < in_word; ++k, word >>= 1U) out[i + k] = static_cast<std::uint8_t>(word & 1U);
        i += in_word;
    }
}

void RunParts::append_runs(const std::uint64_t* row, const BitImage& image, bool value, int y) {
    int open = -1;  // where a run began that has not ended yet
    for (int w = 0; w < image.words(); ++w) {
        std::uint64_t word = value ? row[w] : ~row[w];
        if (!value && w + 1 == image.words() && image.width() % 64 != 0) word &= kAll >> (64 - image.width() % 64);
        int at = 0;
        while (at < 64) {
            if (open < 0) {
                if (word == 0) break;
                at = std::countr_zero(word);
                open = w * 64 + at;
                word |= (std::uint64_t{1} << at) - 1;  // the run's end is the first 0 now
            }
            if (word == kAll) break;
            at = std::countr_one(word);
            runs_.push_back({y, open, w * 64 + at - 1, 0});
            open = -1;
            word &= kAll << at;
        }
    }
    if (open >= 0) runs_.push_back({y, open, image.width() - 1, 0});
}

int RunParts::root_of(int run) {
    while (parent_[static_cast<std::size_t>(run)] != run) {
        int& up = parent_[static_cast<std::size_t>(run)];
        up = parent_[static_cast<std::size_t>(up)];
        run = up;
    }
    return run;
}

void RunParts::join_rows(std::size_t above, std::size_t here, std::size_t end, int reach) {
    const std::size_t above_end = here;
    for (std::size_t a = above, b = here; a < above_end && b < end;) {
        const BitRun &up = runs_[a], &down = runs_[b];
        if (up.x0 <= down.x1 + reach && down.x0 <= up.x1 + reach) {
            const int p = root_of(static_cast<int>(a)), q = root_of(static_cast<int>(b));
            parent_[static_cast<std::size_t>(std::max(p, q))] = std::min(p, q);
        }
        up.x1 < down.x1 ? ++a : ++b;
    }
}

void RunParts::find(const BitImage& image, bool value, Joined joined, int top, int bottom) {
    const int reach = joined == Joined::ByCorners ? 1 : 0;
    runs_.clear();
    parent_.clear();
    std::size_t above = 0;
    for (int y = top; y <= bottom; ++y) {
        const std::size_t here = runs_.size();
        append_runs(image.row(y), image, value, y);
        for (std::size_t r = here; r < runs_.size(); ++r) parent_.push_back(static_cast<int>(r));
        join_rows(above, here, runs_.size(), reach);
        above = here;
    }
    count_ = 0;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
        const int root = root_of(static_cast<int>(r));
        runs_[r].part = root == static_cast<int>(r) ? count_++ : runs_[static_cast<std::size_t>(root)].part;
    }
}

}  // namespace core
