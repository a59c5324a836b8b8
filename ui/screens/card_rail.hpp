#pragma once
// The nine cards beside the sheet over time: faces change by a calm cross-fade, one card after the other.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/draw/draw_list.hpp"

namespace ui {

inline constexpr std::size_t kCardCount = 9;  ///< the best, and 2 × 4 smaller ones

/// What a card shows.
struct CardFace {
    std::int64_t model = 0;
    std::string name;
    std::string caption;    ///< a quiet second line on the best card; may be empty
    std::vector<int> tags;  ///< part colours, ascending
    PictureId picture{};    ///< 0: there is none, the name stands alone
    /// The name as it stands beside the picture, line by line (card_text.hpp); empty: on one line as wide as the card.
    std::vector<std::string> lines{};
    friend bool operator==(const CardFace&, const CardFace&) = default;
};

/// One place on the rail: what it shows, what it showed, and how far the change is.
struct CardSlot {
    std::optional<CardFace> now, before;
    double mix = 1;  ///< 0: all before, 1: all now
    friend bool operator==(const CardSlot&, const CardSlot&) = default;
};

class CardRail {
  public:
    static constexpr std::int64_t kFade_us = 160'000;
    static constexpr std::int64_t kStagger_us = 40'000;
    static constexpr std::int64_t kPause_us = 250'000;  ///< least time between two changes

    /// The ranking to show, best first; empty leaves waiting places. Shown at the next update that may change cards.
    void set(std::vector<CardFace> ranking);
    /// Starts a waiting change when the last one is long enough ago. Frozen places
    /// change when they are no longer.
    void update(std::int64_t now_us, const std::array<bool, kCardCount>& frozen = {});
    /// Whether a change may start now.
    [[nodiscard]] bool ready(std::int64_t now_us) const { return now_us - changed_us_ >= kPause_us; }
    /// Ends all fades at once: the state that pictures for people to compare show.
    void settle();
    [[nodiscard]] std::array<CardSlot, kCardCount> slots(std::int64_t now_us) const;
    [[nodiscard]] bool moving(std::int64_t now_us) const;
    /// Whether any picture of that name is on show or about to be.
    [[nodiscard]] bool shows(PictureId picture) const;

  private:
    struct Place {
        std::optional<CardFace> now, before;
        std::int64_t since_us = -1'000'000'000;
    };
    void apply(std::int64_t now_us, bool at_once, const std::array<bool, kCardCount>& frozen);
    std::array<Place, kCardCount> places_;
    std::optional<std::vector<CardFace>> waiting_;
    std::int64_t changed_us_ = -1'000'000'000;
};

}  // namespace ui
