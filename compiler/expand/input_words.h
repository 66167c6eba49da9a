// input_words.h — functions in a block become others. For the room expand only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/axes.h"
#include "expand/running.h"
#include "nc/block.h"
#include "nc/parameters.h"

namespace kadr::expand {

inline constexpr std::size_t kEdge = nc::parameter_of<nc::Function::ToolEdge>("edge");

/// Takes a function out of the block, by its place.
inline void erase(nc::Block& block, std::size_t at) {
    for (std::size_t i = at + 1; i < block.function_count; ++i)
        block.functions[i - 1] = block.functions[i];
    --block.function_count;
}

/// Makes another function of an invocation that has no arguments of use, with one argument.
inline void become(nc::Block& block, nc::Invocation& invocation, nc::Function function,
                   std::size_t parameter, double argument) {
    invocation.function = function;
    invocation.given = 0;
    invocation.first = block.argument_count;
    block.argument_count = static_cast<std::uint8_t>(block.argument_count + parameter + 1);
    block.set_argument(invocation, parameter, argument);
}

/// Whether the block has words of axes.
inline bool names_axes(const sema::Plan& plan, const Instruction& instruction) {
    return (instruction.op == OpCode::Emit && instruction.b != 0) ||
           (plan.given & nc::kTargetSlots) != 0 ||
           std::ranges::any_of(plan.fillings, [](const sema::Filling& filling) {
               return !filling.is_argument && filling.index < kAxes;
           });
}

}  // namespace kadr::expand
