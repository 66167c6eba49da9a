// stream.h — how the hot rooms are joined.
//
// The consumer pulls batches; the producer never runs ahead of it, so memory does not grow with
// the length of a program, and one virtual call serves about a thousand items.
#pragma once

#include <cstddef>
#include <span>

namespace kadr {

/// How many items one pull asks for.
inline constexpr std::size_t kBatch = 512;

template <typename T>
class Stream {
  public:
    virtual ~Stream() = default;

    /// Fills the front of `out` and returns how many items were written. 0 means the end, for a
    /// non-empty `out`; after the end every further pull returns 0. Items in `out` are reused:
    /// the producer must overwrite or reset each one.
    virtual std::size_t pull(std::span<T> out) = 0;
};

}  // namespace kadr
