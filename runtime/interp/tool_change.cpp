// tool_change.cpp — which tool is called, and its change.
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "interp/block_functions.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/cycle_shapes.h"
#include "interp/danger_watch.h"
#include "interp/feed_words.h"
#include "interp/spindles.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Op;
using path::SpindleMode;

ToolInUse::ToolInUse(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      tool_offsets_(channel.state.tool.tool_offsets),
      tool_names_(channel.state.tool.tool_names),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      extra_(channel.state.tool.extra),
      carrier_(channel.state.tool.carrier),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      comp_(channel.state.stage.comp),
      units_(channel.state.motion.units),
      reported_(channel.state.reported),
      dangers_(channel.state.stage.dangers),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift) {}

void ToolInUse::set_length_source(Tool::Source source, Actions& actions) {
    tool_.source = source;
    expect_length();
    actions.length_changed = true;
}

void ToolInUse::take_edge(const Block& block) {
    if (tool_.selected != tool_.current) return;
    tool_.edge = std::exchange(tool_.edge_called, 0);
    check_edge(block);
}

/// A tool whose data are known has no others; of one that is not known only the edge is reported.
void ToolInUse::check_edge(const Block& block) {
    const std::int64_t number = tool_.edge_number();
    if (tool_.current == 0 || tool_.edge == 1 || tool_offsets_.is_known(number)) return;
    const bool is_known_tool = tool_offsets_.edges(tool_.current) > 0;
    if (is_known_tool) {
        reporter_.report(diag::EdgeMissing, block, Function::ToolEdge)
            .arg(tool_.current)
            .arg(tool_.edge);
        return;
    }
    if (!reported_.first_time(NoticeEach::Edge, number)) return;
    reporter_.report(diag::EdgeUnknown, block, Function::ToolEdge)
        .arg(tool_.edge)
        .arg(tool_.current);
}

void ToolInUse::choose_sum_offset(const Block& block, const Invocation& invocation,
                                  Actions& actions) {
    constexpr std::int64_t kMost = 6;  // MD18110
    tool_.sum = count_of(block, invocation, parameter_of<Function::SumOffset>("number"));
    if (tool_.sum > kMost) {
        reporter_.report(diag::SumOffsetRange, block, invocation.function)
            .arg(tool_.sum)
            .arg(kMost);
        return;
    }
    expect_length();
    actions.length_changed = true;
    actions.comp_changed |= comp_.is_on();
}

double ToolInUse::sum_offset(std::size_t part) const {
    constexpr std::int64_t kWear = 300;
    constexpr std::int64_t kSetUp = 400;
    if (tool_.sum == 0 || tool_.source != Tool::Source::Edge) return 0;
    const std::int64_t datum = 2 + 10 * tool_.sum + static_cast<std::int64_t>(part);
    return tool_offsets_.datum(tool_.edge_number(), kWear + datum) +
           tool_offsets_.datum(tool_.edge_number(), kSetUp + datum);
}

std::int64_t ToolInUse::tool_number(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kTool = parameter_of_all<"tool", Function::ToolSelect, Function::Tool>();
    if (!invocation.has(kTool) && !block.text.empty()) return named_tool(block);
    const std::int64_t number = count_of(block, invocation, kTool);
    if (rules_.most_tool > 0 && number > rules_.most_tool) {
        reporter_.report(diag::ToolNumberRange, block, invocation.function)
            .arg(number)
            .arg(rules_.most_tool);
    }
    return number;
}

/// The tool that the block calls by its name. A name that neither the table nor the program has is
/// a tool of its own.
std::int64_t ToolInUse::named_tool(const Block& block) {
    const std::vector<std::int64_t> known = tool_names_.numbers(block.text);
    if (known.empty()) {
        const std::int64_t number = tool_names_.invent(block.text, tool_offsets_.last_tool());
        reported_.count_as_reported(NoticeEach::Tool, number);
        reporter_.report(diag::ToolUnknown, block).arg(block.text);
        return number;
    }
    if (known.size() > 1 && reported_.first_time_of_name(block.text))
        reporter_.report(diag::ToolNameShared, block).arg(block.text).arg(known[0]).arg(known[1]);
    return known[0];
}

void ToolInUse::change_tool(const Block& block) {
    const bool is_other = tool_.selected != tool_.current;
    if (is_other && rules_.comp_keeps_tool && comp_.is_on()) {
        reporter_.report(diag::CompToolChange, block);
        return;
    }
    if (is_other) {
        channel_.dangers.watch_change(block);
        tool_.current = tool_.selected;
        tool_.edge = 1;
        extra_ = {};
        if (block.find(Function::SumOffset) == nullptr) tool_.sum = 0;
        channel_.stages.put(Op::Tool, block).tool().number = tool_.current;
    }
    if (nc::stops_at_tool_change(rules_, channel_.functions.changer())) {
        channel_.spindles.turn(SpindleMode::Stop);
        reported_.renew_spindle();
        channel_.spindles.update_spindle(block);
    }
    // An edge that the block itself programs is chosen already.
    if (rules_.tool_change_activates_length && block.find(Function::ToolEdge) == nullptr)
        tool_.source = Tool::Source::Edge;
    // A length by number stays that of its offset; that it is another tool's now is looked at.
    if (tool_.source == Tool::Source::Edge || (is_other && tool_.source == Tool::Source::Offset))
        expect_length();
    channel_.feed.take_tooth_feed();
}

void ToolInUse::select_tool(const Block& block, const Invocation& invocation, Actions& actions) {
    constexpr std::size_t kOffset = parameter_of<Function::ToolSelect>("offset");
    tool_.selected = tool_number(block, invocation);
    if (invocation.function == Function::Tool)
        return set_length_source(Tool::Source::Edge, actions);
    if (!invocation.has(kOffset)) return;
    // The offset of a turret's station has length, radius and tip.
    tool_.offset = tool_.radius_offset = count_of(block, invocation, kOffset);
    set_length_source(tool_.offset == 0 ? Tool::Source::None : Tool::Source::Offset, actions);
}

void ToolInUse::select_edge(const Block& block, const Invocation& invocation, Actions& actions) {
    tool_.edge_called = count_of(block, invocation, parameter_of<Function::ToolEdge>("edge"));
    if (block.find(Function::SumOffset) == nullptr) tool_.sum = 0;
    set_length_source(tool_.edge_called == 0 ? Tool::Source::None : Tool::Source::Edge, actions);
    if (!channel_.shapes.keeps_shape()) actions.comp_changed |= comp_.is_on();
}

void ToolInUse::change_length(const Block& block, const Invocation& invocation, Actions& actions) {
    constexpr std::size_t kOffset =
        parameter_of_all<"offset", Function::LengthCompOn, Function::LengthCompMinus>();
    if (orienting_.has_length) channel_.transformation.end_length_transformation(actions);
    if (invocation.function == Function::LengthCompOff)
        return set_length_source(Tool::Source::None, actions);
    tool_.is_taken_off = invocation.function == Function::LengthCompMinus;
    if (invocation.has(kOffset)) tool_.offset = count_of(block, invocation, kOffset);
    set_length_source(Tool::Source::Offset, actions);
}

}  // namespace kadr::interp
