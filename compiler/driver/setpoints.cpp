#include "driver/setpoints.h"

#include "base/units.h"
#include "driver/columns.h"

namespace kadr::driver {

namespace {

constexpr int kDecimals = 9;
constexpr int kFeedDecimals = 6;

}  // namespace

SetpointTable::SetpointTable(const machine::Machine& machine, Output& out)
    : machine_(machine), out_(out) {
    std::string header = "t";
    for (const machine::MachineAxis& axis : machine.axes) header += ',' + axis.name;
    out_.write(header + ",tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso\n");
}

void SetpointTable::write(std::span<const motion::Setpoint> setpoints) {
    text_.clear();
    for (const motion::Setpoint& setpoint : setpoints) {
        append_trimmed(text_, setpoint.time, kDecimals);
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            const double value = setpoint.axis[i];
            append_column(text_, machine_.axes[i].is_rotary ? deg_from_rad(value) : value,
                          kDecimals);
        }
        for (int i = 0; i < 3; ++i) append_column(text_, setpoint.tip[i], kDecimals);
        for (int i = 0; i < 3; ++i) append_column(text_, setpoint.tool[i], kDecimals);
        append_column(text_, mm_min_from_feed(setpoint.feed), kFeedDecimals);
        append_column(text_, setpoint.line);
        text_ += '\n';
    }
    out_.write(text_);
}

}  // namespace kadr::driver
