#pragma once
// Which model stands on which card while rankings come many times a second: an order that people can look at.
//
// A model keeps its card unless its rank was off by two or more, or it was among the cards no longer, in two rankings
// running. Only then do cards change, and then those that need not stay where they are.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ui {

class CalmOrder {
  public:
    static constexpr std::size_t kCards = 9;
    using Frozen = std::array<bool, kCards>;
    using Models = std::vector<std::int64_t>;

    /// Every new ranking, best first; more than nine are welcome, so that ranks just below are known.
    void see(const Models& ranking);
    /// Whether a change of cards has become due. Never for a ranking that shows what the cards show.
    [[nodiscard]] bool change_due() const;
    /// Puts the newest ranking on the cards and gives them, best first. Frozen cards keep their model.
    const Models& rearrange(const Frozen& frozen = {});
    /// The newest ranking as it is, but for frozen cards: for a drawing that rests.
    const Models& settle(const Frozen& frozen = {});
    /// Whether the cards show the newest ranking as it is.
    [[nodiscard]] bool settled() const;
    [[nodiscard]] const Models& shown() const { return shown_; }
    void clear();

  private:
    [[nodiscard]] std::size_t rank_of(std::int64_t model) const;
    [[nodiscard]] bool off(std::size_t card) const;
    [[nodiscard]] bool confirmed(std::size_t card) const { return off_before_[card] && off(card); }

    Models ranking_, shown_;
    std::array<bool, kCards> off_now_{}, off_before_{};
};

}  // namespace ui
