#pragma once
// Bodies and layers finished once and used by every state of a design that has the same: undo, redo and a worker
// thread find them here. What is found is the same as what would be made; calls from several threads are in order.

#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>

#include "core/garment/design.hpp"

namespace core {

class LayerStore {
  public:
    [[nodiscard]] std::shared_ptr<const WornForm> form(std::uint64_t key) const { return find(forms_, key); }
    [[nodiscard]] std::shared_ptr<const FinishedLayer> layer(std::uint64_t key) const { return find(layers_, key); }
    [[nodiscard]] std::shared_ptr<const Obstacle> obstacle(std::uint64_t key) const { return find(obstacles_, key); }

    void keep(std::uint64_t key, std::shared_ptr<const WornForm> form) { add(forms_, key, std::move(form), 4); }
    void keep(std::uint64_t key, std::shared_ptr<const FinishedLayer> layer) {
        add(layers_, key, std::move(layer), 32);
    }
    void keep(std::uint64_t key, std::shared_ptr<const Obstacle> obstacle) {
        add(obstacles_, key, std::move(obstacle), 8);
    }

  private:
    template <typename T>
    using Shelf = std::deque<std::pair<std::uint64_t, std::shared_ptr<const T>>>;  // the newest last

    template <typename T>
    std::shared_ptr<const T> find(const Shelf<T>& shelf, std::uint64_t key) const {
        const std::lock_guard lock(mutex_);
        for (const auto& [known, value] : shelf)
            if (known == key) return value;
        return nullptr;
    }
    template <typename T>
    void add(Shelf<T>& shelf, std::uint64_t key, std::shared_ptr<const T> value, std::size_t most) {
        const std::lock_guard lock(mutex_);
        shelf.emplace_back(key, std::move(value));
        if (shelf.size() > most) shelf.pop_front();
    }

    mutable std::mutex mutex_;
    Shelf<WornForm> forms_;
    Shelf<FinishedLayer> layers_;
    Shelf<Obstacle> obstacles_;
};

/// FNV-1a over plain values: what tells one state from another.
class StateHash {
  public:
    template <typename T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T>);
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        for (const unsigned char b : bytes) state_ = (state_ ^ b) * 1099511628211ULL;
    }
    void add(const std::string& text) {
        add(text.size());
        for (const char c : text) add(c);
    }
    void add(Vec3 v) { add(v.x), add(v.y), add(v.z); }
    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 14695981039346656037ULL;
};

}  // namespace core
