// call_stack.h — the calls of a running program. For the room expand only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sema/code.h"

namespace kadr::expand {

/// A call that has not returned yet.
struct CallFrame {
    const sema::FunctionCode* function = nullptr;
    std::uint32_t return_to = 0;  // instruction behind the call
    std::uint32_t base = 0;       // of its registers in the stack
    std::uint32_t given = 0;      // bit i: argument i was given
    std::uint32_t promises = 0;   // `preserves` open when it began
    std::uint32_t loops = 0;      // loop counters of its callers
};

/// The calls that have not returned, outermost first. A vector that never shrinks: a call writes
/// its frame into memory that is there.
class CallStack {
  public:
    CallFrame& push() {
        if (size_ == frames_.size()) [[unlikely]]
            frames_.resize(2 * size_ + 64);
        return frames_[size_++];
    }
    void pop() { --size_; }
    CallFrame& back() { return frames_[size_ - 1]; }
    const CallFrame& back() const { return frames_[size_ - 1]; }
    const CallFrame& operator[](std::size_t i) const { return frames_[i]; }
    std::size_t size() const { return size_; }

    /// Whether the innermost function was called by an instruction of the program.
    bool is_called() const { return size_ > 1 && back().return_to > 0; }
    /// The instruction that called the innermost function; 0: the program calls it by itself.
    std::uint32_t caller() const { return back().return_to > 0 ? back().return_to - 1 : 0; }

  private:
    std::vector<CallFrame> frames_;
    std::size_t size_ = 0;
};

}  // namespace kadr::expand
