#include "sema/emitter.h"

#include <algorithm>

namespace kadr::sema {

Instruction& Emitter::emit(OpCode op, unsigned a, unsigned b, unsigned c) {
    // More than an operand can hold: of what is numbered here only a function that is too large has
    // so many.
    overflowed_ |= ((a | b | c) >> 16) != 0;
    Instruction instruction;
    instruction.op = op;
    instruction.a = static_cast<std::uint16_t>(a);
    instruction.b = static_cast<std::uint16_t>(b);
    instruction.c = static_cast<std::uint16_t>(c);
    code_.instructions.push_back(instruction);
    code_.locations.push_back(location_);
    return code_.instructions.back();
}

void Emitter::emit_integer(OpCode op, unsigned a, unsigned b, std::int64_t value) {
    emit(op, a, b).immediate.integer = value;
}

void Emitter::emit_number(OpCode op, unsigned a, unsigned b, double value, unsigned c) {
    emit(op, a, b, c).immediate.number = value;
}

void Emitter::emit_pair(OpCode op, unsigned a, unsigned b, unsigned c, std::int64_t first,
                        std::int64_t second) {
    emit(op, a, b, c).immediate.pair = {static_cast<std::int32_t>(first),
                                        static_cast<std::int32_t>(second)};
}

void Emitter::jump(OpCode op, Label& label, unsigned a, unsigned b, unsigned c, int second) {
    if (label.target < 0) label.pending.push_back(here());
    emit_pair(op, a, b, c, label.target, second);
}

void Emitter::bind(Label& label) {
    label.target = here();
    for (const std::uint32_t at : label.pending) {
        code_.instructions[at].immediate.pair.first = static_cast<std::int32_t>(label.target);
    }
    label.pending.clear();
}

Reg Emitter::take(unsigned slots) {
    if (next_ + slots > kMostRegisters) {
        overflowed_ = true;
        return next_;
    }
    const Reg first = next_;
    next_ = static_cast<Reg>(next_ + slots);
    most_ = std::max<std::uint32_t>(most_, next_);
    return first;
}

void Emitter::begin_function() {
    next_ = 0;
    most_ = 0;
    overflowed_ = false;
}

}  // namespace kadr::sema
