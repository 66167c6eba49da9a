#include "driver/setpoints.h"

#include <array>
#include <charconv>

#include "base/numbers.h"
#include "base/units.h"

namespace kadr::driver {

namespace {

constexpr int kDecimals = 9;
constexpr int kFeedDecimals = 6;

void append_trimmed(std::string& out, double value, int decimals) {
    std::array<char, kMaxFixedLength> text;
    char* end = format_fixed(text.data(), value, decimals);
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
    out.append(text.data(), end);
}

void append_column(std::string& out, double value, int decimals = kDecimals) {
    out += ',';
    append_trimmed(out, value, decimals);
}

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
            append_column(text_, machine_.axes[i].is_rotary ? deg_from_rad(value) : value);
        }
        for (int i = 0; i < 3; ++i) append_column(text_, setpoint.tip[i]);
        for (int i = 0; i < 3; ++i) append_column(text_, setpoint.tool[i]);
        append_column(text_, mm_min_from_feed(setpoint.feed), kFeedDecimals);
        std::array<char, 16> line;
        const auto end = std::to_chars(line.data(), line.data() + line.size(), setpoint.line);
        text_ += ',';
        text_.append(line.data(), end.ptr);
        text_ += '\n';
    }
    out_.write(text_);
}

}  // namespace kadr::driver
