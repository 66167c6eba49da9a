// unknown.h — modal state that is not known: what needs it, and what is written again. For the room
// expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Adds a note which statement has made the position of an axis unknown, if one did.
void report_lost_position(const Running& run, DiagnosticBuilder& builder, std::size_t axis);
/// Reports that a block needs what nobody knows.
///
/// what, fix    for the message: "the plane", "say `G17` …"
Done refuse_lost_state(Running& run, std::string_view what, std::string_view fix, std::uint32_t at);
/// … in a message that has begun.
void report_loss(Running& run, DiagnosticBuilder builder, std::string_view what,
                 std::string_view fix);
/// What a cycle of the control needs of the modal state is known.
Done require_state_for_cycle(Running& run, const sema::FunctionCode& cycle, std::uint32_t given,
                             std::uint32_t at);
/// The frame is known, and if the function turns it, the plane.
Done require_frame(Running& run, bool turns, std::uint32_t at);
/// Reports a block that needs to know whether the cutter's radius is compensated, where that is the
/// operator's choice and the block is not part of it.
Done require_sure_compensation(Running& run, const nc::Block& block, std::uint32_t at);
/// Completes a message of compensation in doubt: which block is the operator's choice.
void compensation_chosen(Running& run, DiagnosticBuilder builder);
/// What F means is known.
Done require_feed_mode(Running& run, std::uint32_t at);
/// What S means is known.
Done require_speed_mode(Running& run, std::uint32_t at);
/// Writes what may have been left out, in a block of its own before a cycle that the control has
/// itself.
void say_again_alone(Running& run, SourceId source, std::uint32_t at, std::size_t depth);
/// Adds what X is to the first block that moves or that sets another state.
void say_diameter(Running& run, nc::Block& block);
/// Writes what X is, in a block of its own.
void say_diameter_alone(Running& run, SourceId source, std::uint32_t at, std::size_t depth);
/// Warns of a block that turns while nothing tells whether X is a diameter.
void warn_of_radius(Running& run, const nc::Block& block, std::uint32_t at);
/// Checks what the block needs of the modal state, and programs again what may have been left
/// out.
Done settle_unknown(Running& run, nc::Block& block, std::uint32_t at);
/// Completes a message of a spindle in doubt: which block is the operator's choice.
void warn_of_choice(Running& run, DiagnosticBuilder builder);
/// Sets back what raw text in a cycle may have changed, where the cycle ends.
Done keep_promise(Running& run, const OpenWith& promise, std::uint32_t at);
/// Warns once of blocks behind the end of the program.
void warn_after_end(Running& run, std::uint32_t at);
/// Reports an arc whose center is its start.
Done require_radius(Running& run, const nc::Block& block, std::uint32_t at);

}  // namespace kadr::expand
