// cuts.h — what a block that cuts needs: feed, speed, a spindle that turns, one tool. For the room
// expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Whether no tool was called, and that has not been reported yet.
inline bool misses_tool(const Running& run) {
    return run.modal.tool.is_missing() && !run.modal.reported.has_reported(ProgramNotice::NoTool);
}
/// Whether a block that cuts is to be looked at: nearly all are not.
inline bool is_cut_doubtful(const Running& run) {
    return !run.modal.feed.is_known() ||
           (run.options.warns_of_cuts && (misses_tool(run) || !run.modal.is_spindle_turning()));
}
/// Reports a constant cutting speed that is none, and a limit that lets no spindle turn.
Done check_cutting_speed(Running& run, const nc::Block& block, std::uint32_t at);
/// Reports another tool under cutter radius compensation: each of the compensated blocks was worked
/// out for the radius of one.
Done check_tool_change(Running& run, const nc::Block& block, std::uint32_t at);
/// Reports an arc that begins or ends the compensation: controls go to a compensated contour, and
/// leave it, on straight lines only.
///
/// source       F PS0034, S 10753
Done check_pitch(Running& run, const nc::Block& block, std::uint32_t at);
/// Reports a further mirror of an axis, where source and target do not take it alike: it goes on
/// mirroring, or undoes the one that acts.
Done check_mirror(Running& run, const nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// Warns once that the tool's length goes over to another axis of a mill with the plane.
void warn_of_plane(Running& run, const nc::Block& block, std::uint32_t at);
/// What a block that cuts needs: a feed that belonged to another feed mode does not count.
Done check_cut(Running& run, const nc::Block& block, std::uint32_t at);
/// Reports a feed of another feed mode: a number of millimetres per minute would cut as millimetres
/// per revolution.
Done refuse_lost_feed(Running& run, std::uint32_t at, std::size_t depth);
/// Whether the block brings a tool in, be it by a T alone, as some controls do on lathes.
bool changes_tool(const Running& run, const nc::Block& block);
/// Reports what the interpreter finds when the text is run, where only the text is made: no feed,
/// no tool, a spindle that stands.
void warn_of_cut(Running& run, std::uint32_t at, bool needs_feed = true);
/// Warns of a rapid below the zero of the workpiece while the spindle stands. The block has not
/// moved yet.
void check_rapid(Running& run, const nc::Block& block, std::uint32_t at);

}  // namespace kadr::expand
