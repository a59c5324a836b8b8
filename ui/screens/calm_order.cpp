#include "ui/screens/calm_order.hpp"

#include <algorithm>
#include <optional>

namespace ui {

std::size_t CalmOrder::rank_of(std::int64_t model) const {
    return static_cast<std::size_t>(std::find(ranking_.begin(), ranking_.end(), model) - ranking_.begin());
}

/// By two ranks or more, or not among the cards' models any more.
bool CalmOrder::off(std::size_t card) const {
    const std::size_t rank = rank_of(shown_[card]);
    if (rank >= std::min(ranking_.size(), kCards)) return true;
    return std::max(rank, card) - std::min(rank, card) >= 2;
}

void CalmOrder::see(const Models& ranking) {
    off_before_ = off_now_;
    ranking_ = ranking;
    off_now_ = {};
    for (std::size_t card = 0; card < shown_.size(); ++card) off_now_[card] = off(card);
}

bool CalmOrder::change_due() const {
    if (shown_.size() < std::min(ranking_.size(), kCards)) return true;
    for (std::size_t card = 0; card < shown_.size(); ++card) {
        if (confirmed(card)) return true;
    }
    return false;
}

const CalmOrder::Models& CalmOrder::rearrange(const Frozen& frozen) {
    const std::size_t count = std::min(ranking_.size(), kCards);
    std::vector<std::optional<std::int64_t>> cards(count);
    std::vector<std::int64_t> kept;
    for (std::size_t card = 0; card < std::min(shown_.size(), count); ++card) {
        if (!frozen[card] && (confirmed(card) || rank_of(shown_[card]) >= ranking_.size())) continue;
        cards[card] = shown_[card];
        kept.push_back(shown_[card]);
    }
    std::size_t next = 0;
    bool near_their_ranks = true;
    for (std::size_t card = 0; card < count; ++card) {
        if (cards[card]) continue;
        while (std::find(kept.begin(), kept.end(), ranking_[next]) != kept.end()) ++next;
        near_their_ranks = near_their_ranks && std::max(card, next) - std::min(card, next) < 2;
        cards[card] = ranking_[next++];
    }
    // a newcomer that belongs elsewhere moves all between: then the ranking itself is calmer than many small changes
    if (!near_their_ranks) return settle(frozen);
    shown_.clear();
    for (const auto& model : cards) shown_.push_back(*model);
    off_now_ = off_before_ = {};
    return shown_;
}

const CalmOrder::Models& CalmOrder::settle(const Frozen& frozen) {
    const std::size_t count = std::min(ranking_.size(), kCards);
    Models cards, held;
    for (std::size_t card = 0; card < std::min(shown_.size(), count); ++card) {
        if (frozen[card]) held.push_back(shown_[card]);
    }
    std::size_t next = 0;
    for (std::size_t card = 0; card < count; ++card) {
        if (card < shown_.size() && frozen[card]) {
            cards.push_back(shown_[card]);
            continue;
        }
        while (std::find(held.begin(), held.end(), ranking_[next]) != held.end()) ++next;
        cards.push_back(ranking_[next++]);
    }
    shown_ = std::move(cards);
    off_now_ = off_before_ = {};
    return shown_;
}

bool CalmOrder::settled() const {
    return std::equal(shown_.begin(), shown_.end(), ranking_.begin(),
                      ranking_.begin() + static_cast<std::ptrdiff_t>(std::min(ranking_.size(), kCards)));
}

void CalmOrder::clear() {
    *this = {};
}

}  // namespace ui
