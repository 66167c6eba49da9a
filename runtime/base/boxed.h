// boxed.h — a rare part of a value, kept beside it: a struct that nearly never has it stays small.
//
// A value as any other: a copy has a part of its own, and equal parts are equal.
#pragma once

#include <memory>
#include <utility>

#include "base/assert.h"

namespace kadr {

/// A T, or none.
template <typename T>
class Boxed {
  public:
    Boxed() = default;
    Boxed(T value) : held_(std::make_unique<T>(std::move(value))) {}
    Boxed(const Boxed& other) : held_(other ? std::make_unique<T>(*other.held_) : nullptr) {}
    Boxed(Boxed&&) noexcept = default;
    ~Boxed() = default;

    Boxed& operator=(Boxed&&) noexcept = default;
    Boxed& operator=(const Boxed& other) {
        if (other) *this = *other.held_;
        else reset();
        return *this;
    }
    /// What is there already is written over, so that a slot that is used again does not allocate.
    Boxed& operator=(const T& value) {
        if (held_) *held_ = value;
        else held_ = std::make_unique<T>(value);
        return *this;
    }

    explicit operator bool() const { return held_ != nullptr; }
    const T& operator*() const { return *get(); }
    T& operator*() { return *get(); }
    const T* operator->() const { return get(); }
    T* operator->() { return get(); }

    /// The part, which begins here as T{} where there was none.
    T& made() {
        if (!held_) held_ = std::make_unique<T>();
        return *held_;
    }
    void reset() { held_.reset(); }

    friend bool operator==(const Boxed& a, const Boxed& b) {
        if (!a || !b) return !a && !b;
        return *a.held_ == *b.held_;
    }

  private:
    T* get() const {
        KADR_ASSERT(held_ != nullptr, "a part is read that is not there");
        return held_.get();
    }

    std::unique_ptr<T> held_;
};

}  // namespace kadr
