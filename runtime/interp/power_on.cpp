// power_on.cpp — how the control begins: with the default of every group of its dialect.
#include <algorithm>
#include <utility>

#include "interp/block_functions.h"
#include "interp/channel.h"
#include "interp/radius_compensation.h"
#include "interp/tool_in_use.h"
#include "nc/tables.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Group;

namespace {

/// How the cutter comes to a contour, and what joins its elements: the rule of that name can mean
/// more than the functions of the group do, and counts where a file sets it.
bool is_ruled(const nc::Dialect& dialect, Group group) {
    if (group == Group::CompStart) return dialect.names_rule(nc::Rule::comp_start);
    return group == Group::CompCorner && dialect.names_rule(nc::Rule::comp_corner);
}

}  // namespace

void BlockFunctions::power_on() {
    const Reporter::Silence silence(reporter_, Reporter::Locations::Hidden);
    const nc::DialectTables& tables = dialect_.tables();
    for (std::size_t i = 0; i < tables.power_on.size(); ++i) {
        const auto group = static_cast<Group>(i);
        const Function function = tables.power_on[i];
        if (function == Function::None || group == Group::Units || is_ruled(dialect_, group))
            continue;
        begin_with(function);
    }
    for (const nc::DialectGroup& group : tables.groups) {
        for (const Function function : group.power_on)
            if (nc::info(function).group == Group::NonModal) begin_with(function);
    }
    channel_.tool.expect_length(tool_.source != Tool::Source::None);
}

void BlockFunctions::begin_with(Function function) {
    Block block{};
    if (!block.add(function)) return;
    if (nc::info(function).group == Group::Motion) modal_.move_by(function);
    const Actions actions = apply_functions(block);
    if (!reporter_.has_ended()) act_before_motion(block, actions);
    // What this machine, without a tool, cannot do does not act.
    if (reporter_.has_ended()) channel_.compensation.leave();
    reporter_.go_on();
}

}  // namespace kadr::interp
