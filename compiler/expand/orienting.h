// orienting.h — tool centre point control and the tool's direction. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

struct ArgumentValue {
    std::size_t parameter;  // of the function, as parameter_of<> counts
    double value;
};

enum class ToolTaken : std::uint8_t {
    Failed,
    Done,
    Nothing,  // of it: the block is like any other
};

/// A block of nothing but one function; what is NaN is not given.
void put_function(Running& run, nc::Function function, std::span<const ArgumentValue> arguments,
                  SourceId source, std::uint32_t at, unsigned depth);
inline void put_function(Running& run, nc::Function function,
                         std::initializer_list<ArgumentValue> arguments, SourceId source,
                         std::uint32_t at, unsigned depth) {
    put_function(run, function, std::span(arguments.begin(), arguments.size()), source, at, depth);
}
/// Tool centre point control, its interpolation and directions, and what must not stand under it.
ToolTaken take_tool(Running& run, const sema::Plan& plan, const Instruction& instruction,
                    std::uint32_t at);
/// Reports what cannot stand under tool centre point control.
Done refuse_under_tcp(Running& run, std::string_view what, std::uint32_t at);
/// What a `with` found: on or off.
Done set_back_tcp(Running& run, const ModalState& before, SourceId source, std::uint32_t at,
                  unsigned depth);
/// The direction that a block gives, in numbers that the target writes.
Done settle_direction(Running& run, nc::Block& block, std::uint32_t at);
/// The motion of a block may stand under tool centre point control.
Done check_leading(Running& run, const nc::Block& block, std::uint32_t at);

}  // namespace kadr::expand
