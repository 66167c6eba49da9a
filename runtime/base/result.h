// result.h — the answer of a calculation that may have none.
//
// The error is a plain enum or a small struct; the caller, who knows the source range, words it
// as a diagnostic. Nothing of ours throws.
#pragma once

#include <utility>
#include <variant>

#include "base/assert.h"

namespace kadr {

/// Either a value or the reason why there is none. Asking for the wrong one is our own fault.
template <typename T, typename E>
class Result {
  public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(E error) : state_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return state_.index() == 0; }
    bool has_value() const { return state_.index() == 0; }

    const T& value() const& {
        KADR_ASSERT(has_value(), "a Result without value was read");
        return std::get<0>(state_);
    }
    T&& value() && {
        KADR_ASSERT(has_value(), "a Result without value was read");
        return std::get<0>(std::move(state_));
    }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    const T* operator->() const { return &value(); }

    const E& error() const {
        KADR_ASSERT(!has_value(), "the error of a Result with a value was read");
        return std::get<1>(state_);
    }

  private:
    std::variant<T, E> state_;
};

}  // namespace kadr
