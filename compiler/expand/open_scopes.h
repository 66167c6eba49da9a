// open_scopes.h — each `with` and each `preserves` that has begun, and what it found. For the room
// expand only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "expand/modal.h"
#include "sema/code.h"

namespace kadr::expand {

/// What a `with` or a promise of a cycle found, and which of it holds again behind it.
struct OpenWith {
    sema::ModalMask mask = 0;
    ModalState before;
};

class OpenScopes {
  public:
    void begin_with(const OpenWith& with) { withs_.push_back(with); }
    /// The innermost `with` ends.
    OpenWith end_with() {
        OpenWith with = withs_.back();
        withs_.pop_back();
        return with;
    }

    void promise(const OpenWith& promise) { promises_.push_back(promise); }
    const OpenWith& last_promise() const { return promises_.back(); }
    std::uint32_t promises() const { return static_cast<std::uint32_t>(promises_.size()); }
    /// The function that began with so many promises is left.
    void leave_function(std::uint32_t promises) {
        if (promises_.size() != promises) [[unlikely]]
            promises_.resize(promises);
    }

  private:
    std::vector<OpenWith> withs_;
    std::vector<OpenWith> promises_;
};

}  // namespace kadr::expand
