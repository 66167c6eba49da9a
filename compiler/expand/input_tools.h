// input_tools.h — tools, edges and length offsets of another control. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// `G49;` of a control that travels the change of the length at once: the axis goes where its
/// coordinate is the same with the new length.
///
/// returns  the function whose travel nobody knows, because the coordinate is not known; None
nc::Function name_length_axis(ModalState& modal, nc::Block& block);
/// `T0101`, for a target that selects tools without their offsets: the tool with its own ones.
Done take_station(Running& run, nc::Block& block, nc::Invocation& select, std::uint32_t at);
/// `H3` and `D3` of tool 3 are its first edge.
Done take_offsets_as_edges(Running& run, nc::Block& block, std::uint32_t at);
/// The common core has the words of both ways: those that the target has not are written in its
/// own.
Done take_core_offsets(Running& run, nc::Block& block, std::uint32_t at);
/// The first edge acts with the change of its tool; it has the offsets with the tool's number.
/// `D0` ends its length, and `D1` behind that brings it again; both wait for the next move.
Done take_edges_as_offsets(Running& run, nc::Block& block, std::uint32_t at);

}  // namespace kadr::expand
