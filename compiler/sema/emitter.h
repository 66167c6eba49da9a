// emitter.h — appends instructions to the code: registers, labels, jumps.
#pragma once

#include <vector>

#include "sema/code.h"
#include "sema/names.h"

namespace kadr::sema {

/// A point in the code that jumps go to, before or after it is known.
struct Label {
    std::int64_t target = -1;
    std::vector<std::uint32_t> pending;  // instructions that jump there
};

class Emitter {
  public:
    explicit Emitter(Code& code) : code_(code) {}

    std::uint32_t here() const { return static_cast<std::uint32_t>(code_.instructions.size()); }
    void set_location(const SourceRange& range) { location_ = range; }
    const SourceRange& location() const { return location_; }

    Instruction& emit(OpCode op, unsigned a = 0, unsigned b = 0, unsigned c = 0);
    void emit_integer(OpCode op, unsigned a, unsigned b, std::int64_t value);
    void emit_number(OpCode op, unsigned a, unsigned b, double value, unsigned c = 0);
    void emit_pair(OpCode op, unsigned a, unsigned b, unsigned c, std::int64_t first,
                   std::int64_t second = 0);

    /// A jump to a label; `second` is the loop depth of loop jumps.
    void jump(OpCode op, Label& label, unsigned a = 0, unsigned b = 0, unsigned c = 0,
              int second = 0);
    void bind(Label& label);

    /// Registers are a stack: taken for a while, given back by setting the mark.
    Reg take(unsigned slots);
    Reg mark() const { return next_; }
    void release_to(Reg mark) { next_ = mark; }
    void begin_function();
    std::uint32_t registers_used() const { return most_; }
    /// Whether something has asked for more registers than there are.
    bool has_overflowed() const { return overflowed_; }
    void forget_overflow() { overflowed_ = false; }

    Code& code() { return code_; }

  private:
    Code& code_;
    SourceRange location_;
    Reg next_ = 0;
    std::uint32_t most_ = 0;
    bool overflowed_ = false;
};

}  // namespace kadr::sema
