#include "interp/snapshot.h"

#include <algorithm>

#include "interp/answers.h"
#include "interp/channel.h"
#include "interp/radius_compensation.h"
#include "interp/spindles.h"
#include "interp/stages.h"
#include "interp/transformation.h"

namespace kadr::interp {

Snapshot Answers::snapshot() const {
    Snapshot now;
    now.axes = axes_.present;
    // Beside a contour the axes stand where the blocks have sent them that are settled.
    const AxisValues machine =
        channel_.compensation.is_any_comp_on()
            ? channel_.transformation.machine_axes_at(channel_.compensation.cutter_position())
            : channel_.transformation.machine_axes();
    for (std::size_t i = 0; i < kAxes; ++i) {
        now.work[i] = position_.here()[i] / axes_.word_scale[i];
        now.machine[i] = machine[i];
    }
    if (modal_.has_feed) now.feed = modal_.feed;
    now.feed_mode = modal_.feed_mode;
    now.spindle = spindle_.mode;
    now.has_cutting_speed = spindle_.has_cutting_speed;
    now.speed = spindle_.has_cutting_speed ? spindle_.cutting_speed : spindle_.speed;
    now.master_spindle = channel_.spindles.shown_number();
    for (const ProgrammedSpindle& other : other_spindles_)
        now.spindles.push_back({other.number, other.mode, other.speed});
    if (!now.spindles.empty()) now.spindles.push_back({spindle_.number, now.spindle, now.speed});
    std::ranges::sort(now.spindles, {}, &Snapshot::NumberedSpindle::number);
    now.tool = tool_.current;
    now.selected_tool = tool_.selected;
    now.length_offset = tool_.source == Tool::Source::Offset ? tool_.offset : 0;
    now.radius_offset = tool_.radius_offset;
    if (dialect_.can_write(nc::Function::ToolEdge))
        now.edge = tool_.source == Tool::Source::Edge ? tool_.edge : 0;
    now.tool_length = tool_.lengths[static_cast<Eigen::Index>(index(tool_.axis))];
    now.work_offset = work_offset_;
    now.coolant = coolant_;
    if (modal_cycles_.modal.is_active)
        now.cycle = dialect_.cycles()[modal_cycles_.modal.cycle].name;
    return now;
}

}  // namespace kadr::interp
