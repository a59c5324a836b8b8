#pragma once
// A value or an Error. Spelt like std::expected (C++23), so that it can be swapped for it later.
//
//     core::Result<Mesh> mesh = read_mesh(path);
//     if (!mesh) return core::unexpected(mesh.error());
//     use(*mesh);

#include <cassert>
#include <optional>
#include <utility>
#include <variant>

#include "core/base/error.hpp"

namespace core {

struct Unexpected {
    Error error;
};

[[nodiscard]] inline Unexpected unexpected(Error error) {
    return Unexpected{std::move(error)};
}
[[nodiscard]] inline Unexpected unexpected(ErrorCode code, std::string message, std::string where = {}) {
    return Unexpected{Error{code, std::move(message), std::move(where)}};
}

template <typename T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit as expected
    Result(Unexpected failure) : state_(std::in_place_index<1>, std::move(failure.error)) {}  // NOLINT

    [[nodiscard]] bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    [[nodiscard]] T& value() & { return get(); }
    [[nodiscard]] const T& value() const& { return get(); }
    [[nodiscard]] T&& value() && { return std::move(get()); }
    [[nodiscard]] T& operator*() & { return get(); }
    [[nodiscard]] const T& operator*() const& { return get(); }
    [[nodiscard]] T&& operator*() && { return std::move(get()); }
    [[nodiscard]] T* operator->() { return &get(); }
    [[nodiscard]] const T* operator->() const { return &get(); }

    [[nodiscard]] const Error& error() const {
        assert(!has_value());
        return *std::get_if<1>(&state_);
    }

  private:
    [[nodiscard]] T& get() {
        assert(has_value());
        return *std::get_if<0>(&state_);
    }
    [[nodiscard]] const T& get() const {
        assert(has_value());
        return *std::get_if<0>(&state_);
    }
    std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Unexpected failure) : error_(std::move(failure.error)) {}  // NOLINT: implicit as expected

    [[nodiscard]] bool has_value() const { return !error_.has_value(); }
    explicit operator bool() const { return has_value(); }
    [[nodiscard]] const Error& error() const {
        assert(error_.has_value());
        return *error_;
    }

  private:
    std::optional<Error> error_;
};

}  // namespace core
