// data_input.cpp — blocks that write data of the control: its parameters, the lives of its tools.
//
// A parameter that this run knows acts; of the others is reported that they do not.
// source: FANUC reference 3.4 (G10 L52, G10 L3), 3.1 (No.1006), 3.5 (No.3410)
#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/answers.h"
#include "interp/block_functions.h"
#include "interp/channel.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;

namespace {

/// A parameter of bits is written as eight digits, the highest bit first: 1000 is bit 3.
bool bit_of(double digits, int bit) {
    const double parameter = std::floor(std::abs(digits) / std::pow(10.0, bit));
    return std::fmod(parameter, 10) != 0;
}

}  // namespace

void BlockFunctions::write_parameter(const Block& block, const Invocation& invocation) {
    constexpr std::int64_t kAxisKind = 1006;  // bit 3: the axis is programmed as a diameter
    constexpr std::int64_t kArcTolerance = 3410;
    constexpr int kDiameter = 3;
    constexpr std::size_t kAxis = parameter_of<Function::ParameterData>("axis");
    const std::int64_t number = block.number;
    if (number < 0) {
        reporter_.report(diag::ParameterNumber, block, Function::ParameterData);
        return;
    }
    const double value = block.argument(invocation, parameter_of<Function::ParameterData>("value"));
    const bool has_axis = invocation.has(kAxis);
    const auto axis =
        has_axis ? channel_.answers.axis_of(std::llround(block.argument(invocation, kAxis)))
                 : std::optional<Axis>();
    if (has_axis && !axis) {
        reporter_.report(diag::ParameterAxis, block, Function::ParameterData)
            .arg(block.argument(invocation, kAxis));
        return;
    }
    if (number == kAxisKind && axis == Axis::X) {
        axes_.count_x_as(bit_of(value, kDiameter) ? 0.5 : 1);
        return;
    }
    if (number == kArcTolerance && !has_axis) {
        // Written in increments of a thousandth; with 0 nothing is checked.
        rules_.arc_tolerance = value == 0 ? 1e6 : value * 0.001;
        return;
    }
    if (!reported_.first_time(NoticeEach::Parameter, number)) return;
    reporter_.report(diag::ParameterIdle, block, Function::ParameterData).arg(number);
}

/// Lives of tools are the control's matter: no tool wears here.
void BlockFunctions::report_life_data(const Block& block) {
    if (reported_.first_time(RunNotice::LifeData))
        reporter_.report(diag::LifeDataIdle, block, Function::LifeData);
}

}  // namespace kadr::interp
