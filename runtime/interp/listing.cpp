#include "interp/listing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "base/numbers.h"
#include "base/render.h"
#include "path/frame.h"
#include "path/op_names.h"

namespace kadr::interp {

using path::Command;
using path::CoolantMode;
using path::FeedMode;
using path::Op;
using path::Plane;
using path::SpindleMode;

namespace {

std::string_view plane_name(Plane plane) {
    switch (plane) {
        case Plane::Xy: return "XY";
        case Plane::Zx: return "ZX";
        case Plane::Yz: return "YZ";
    }
    return "";
}

std::string_view spindle_name(SpindleMode mode) {
    switch (mode) {
        case SpindleMode::Stop: return "stop";
        case SpindleMode::Cw: return "cw";
        case SpindleMode::Ccw: return "ccw";
        case SpindleMode::Orient: return "orient";
    }
    return "";
}

std::string_view step_name(path::FunctionStep step) {
    switch (step) {
        case path::FunctionStep::Issue: return "issue";
        case path::FunctionStep::Await: return "await";
        case path::FunctionStep::Both: return "both";
    }
    return "";
}

std::string_view coolant_name(CoolantMode mode) {
    switch (mode) {
        case CoolantMode::Off: return "off";
        case CoolantMode::Flood: return "flood";
        case CoolantMode::Mist: return "mist";
    }
    return "";
}

/// Directions this close to each other are the same one.
constexpr double kSamePlane = 1e-9;

/// Nine decimals at most, without trailing zeros: frames leave noise behind them.
void append_number(std::string& out, double value) {
    constexpr double kScale = 1e9;
    constexpr double kQuickLimit = 1e6;  // below it 15 digits hold the value and its decimals
    if (!(std::abs(value) < kQuickLimit)) {
        append_shortest(out, round_to(value, 9));
        return;
    }
    const long long scaled = std::llround(value * kScale);
    if (scaled < 0) out += '-';
    const auto size = static_cast<unsigned long long>(scaled < 0 ? -scaled : scaled);
    char digits[24];
    const auto whole = std::to_chars(digits, digits + sizeof digits, size / 1'000'000'000);
    out.append(digits, whole.ptr);
    unsigned long long rest = size % 1'000'000'000;
    if (rest == 0) return;
    char decimals[9];
    for (std::size_t i = 9; i-- > 0; rest /= 10) decimals[i] = static_cast<char>('0' + rest % 10);
    std::size_t count = 9;
    while (decimals[count - 1] == '0') --count;
    out += '.';
    out.append(decimals, count);
}

/// `,"name":` and the value behind it.
void append_key(std::string& out, std::string_view name) {
    out += ",\"";
    out += name;
    out += "\":";
}
void append_field(std::string& out, std::string_view name, double value) {
    append_key(out, name);
    append_number(out, value);
}
void append_word(std::string& out, std::string_view name, std::string_view word) {
    append_key(out, name);
    out += '"';
    out += word;
    out += '"';
}

void append_text(std::string& out, std::string_view name, std::string_view text) {
    append_key(out, name);
    const auto is_plain = [](char c) { return c >= ' ' && c < 127 && c != '"' && c != '\\'; };
    if (std::all_of(text.begin(), text.end(), is_plain)) {  // nearly always; without a copy
        out += '"';
        out += text;
        out += '"';
    } else {
        out += json_string(text);
    }
}

void append_numbers(std::string& out, std::span<const double> values) {
    char separator = '[';
    for (const double value : values) {
        out += separator;
        append_number(out, value);
        separator = ',';
    }
    out += ']';
}

/// Where the cutter touches from and to, and how: the path of the tip follows from it.
void append_contact(std::string& out, const path::ContactMotion& motion) {
    append_key(out, "touches");
    out += '[';
    append_numbers(out, {motion.from.data(), 3});
    out += ',';
    append_numbers(out, {motion.to.data(), 3});
    out += ']';
    append_key(out, "radius");
    append_number(out, motion.contact.radius);
    const bool is_face = motion.contact.kind == path::ContactKind::Face;
    append_key(out, is_face ? "edge" : "depth");
    append_number(out, motion.contact.depth);
    if (!is_face) return;
    const path::Vec3 end = path::guide_at(motion.contact, 1);
    append_key(out, "normals");
    out += '[';
    append_numbers(out, {motion.contact.guide.data(), 3});
    out += ',';
    append_numbers(out, {end.data(), 3});
    out += ']';
}

/// In which coordinates the position is given.
void append_virtual(std::string& out, const path::VirtualAxes& axes) {
    switch (axes.kind) {
        case path::VirtualKind::None: return;
        case path::VirtualKind::Polar: return append_word(out, "on", "face");
        case path::VirtualKind::Cylinder:
            append_word(out, "on", "cylinder");
            append_field(out, "radius", axes.size);
            return;
        case path::VirtualKind::Inclined: append_word(out, "on", "inclined"); return;
    }
}

void append_target(std::string& out, const path::Motion& motion, AxisMask axes) {
    out += ",\"to\":";
    char separator = '{';
    for (std::size_t i = 0; i < kAxes; ++i) {
        const bool is_virtual = motion.virtual_axes().turns() &&
                                motion.virtual_axes().virtual_axis() == static_cast<Axis>(i);
        if ((axes >> i & 1u) == 0 && !is_virtual) continue;
        out += separator;
        out += '"';
        out += kAxisNames[i];
        out += "\":";
        append_number(out, motion.to[i]);
        separator = ',';
    }
    out += '}';
    if (motion.machine_coordinates) out += ",\"machine_coordinates\":true";
    if (motion.virtual_axes().is_on()) return append_virtual(out, motion.virtual_axes());
    if (motion.orient_kind == path::OrientKind::None) return;
    append_key(out, "tool");
    append_numbers(out, {motion.direction.data(), 3});
    if (motion.orient_kind == path::OrientKind::Straight) out += ",\"point_to_point\":true";
    if (motion.contact) append_contact(out, *motion.contact);
}

/// The control points between the ends; the weights of all, unless they are all one.
void append_spline(std::string& out, const path::SplineShape& shape) {
    append_key(out, "degree");
    append_number(out, shape.degree);
    const auto count = static_cast<std::size_t>(shape.degree);
    append_key(out, "poles");
    out += '[';
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (i > 0) out += ',';
        append_numbers(out, {shape.inner[i].data(), 3});
    }
    out += ']';
    const std::span<const double> weights(shape.weights.data(), count + 1);
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 1; })) return;
    append_key(out, "weights");
    append_numbers(out, weights);
}

/// The kind, what it works with, and the range of its parameter.
void append_curve(std::string& out, const path::CurveShape& shape) {
    append_word(out, "kind", shape.kind->name);
    append_key(out, "numbers");
    append_numbers(out, shape.law.numbers);
    append_key(out, "range");
    const std::array<double, 2> range = {shape.law.from, shape.law.to};
    append_numbers(out, range);
    append_key(out, "linear");
    const path::Vec3 rows[] = {shape.linear.row(0), shape.linear.row(1), shape.linear.row(2)};
    char separator = '[';
    for (const path::Vec3& row : rows) {
        out += separator;
        append_numbers(out, {row.data(), 3});
        separator = ',';
    }
    out += ']';
}

/// Of an arc or an involute where its circle lies, and how it runs about it.
template <typename Circle>
void append_circle(std::string& out, const Circle& circle, Plane plane) {
    append_key(out, "center");
    append_numbers(out, {circle.center.data(), 3});
    append_word(out, "plane", plane_name(plane));
    append_word(out, "dir", circle.is_clockwise ? "cw" : "ccw");
    // An arc in space goes counter-clockwise about its normal, whatever the plane.
    const path::Vec3 across = path::unit(path::axes_of(plane).normal);
    if (std::abs(circle.normal.dot(across)) < 1 - kSamePlane) {
        append_key(out, "normal");
        append_numbers(out, {circle.normal.data(), 3});
    }
}

void append_feed(std::string& out, const path::Motion& motion) {
    append_field(out, "feed", motion.feed);
    if (motion.feed_mode == FeedMode::PerRevolution) {
        append_word(out, "feed_mode", "per_revolution");
    }
    if (motion.feed_mode == FeedMode::InverseTime) append_word(out, "feed_mode", "inverse_time");
}

/// Whether it ends at rest, or how the corner behind it is blended; and within what it may be
/// joined to its neighbours, in mm.
void append_ending(std::string& out, const path::Motion& motion) {
    if (motion.exact_stop) out += ",\"exact_stop\":true";
    const path::Blending& blending = motion.blending;
    if (blending.kind != path::BlendKind::None && !motion.exact_stop) {
        const bool by_distance = blending.kind == path::BlendKind::Distance;
        append_field(out, by_distance ? "blend_distance" : "blend_tolerance", blending.size);
        if (blending.with_tangents) out += ",\"blend_tangents\":true";
        if (motion.orient_kind != path::OrientKind::None && std::isfinite(blending.orientation))
            append_field(out, "blend_orientation", deg_from_rad(blending.orientation));
    }
    if (blending.smooths_orientation && motion.orient_kind > path::OrientKind::Straight &&
        !motion.exact_stop)
        append_field(out, "smooth_orientation", deg_from_rad(blending.orientation));
    if (motion.compress > 0) append_field(out, "compress", motion.compress);
}

void append_spindle(std::string& out, const path::Spindle& spindle) {
    if (spindle.number != 0) append_field(out, "spindle", spindle.number);
    append_word(out, "mode", spindle_name(spindle.mode));
    switch (spindle.mode) {
        case SpindleMode::Stop: break;
        case SpindleMode::Orient: append_field(out, "angle", spindle.angle_deg); break;
        case SpindleMode::Cw:
        case SpindleMode::Ccw:
            append_field(out, spindle.has_cutting_speed ? "cutting_speed" : "speed", spindle.speed);
            break;
    }
}

void append_dwell(std::string& out, const path::Dwell& dwell) {
    if (dwell.revolutions > 0) append_field(out, "revolutions", dwell.revolutions);
    else append_field(out, "time", dwell.time);
}

void append_speed_limit(std::string& out, const path::SpeedLimit& limit) {
    append_field(out, "speed", limit.most);
    if (limit.least > 0) append_field(out, "least_speed", limit.least);
}

void append_tool_length(std::string& out, const path::ToolLength& length) {
    append_field(out, "tool", static_cast<double>(length.number));
    append_field(out, "length", length.length);
    for (std::size_t i = 0; i < 3; ++i) {
        static constexpr std::array kNames = {"length_x", "length_y", "length_z"};
        const double aside = length.aside[static_cast<Eigen::Index>(i)];
        if (aside != 0) append_field(out, kNames[i], aside);
    }
}

/// Where a motion leads, on which shape, and how fast.
void append_motion(std::string& out, const path::Motion& motion, AxisMask axes) {
    append_target(out, motion, axes);
    switch (motion.op()) {
        case Op::Rapid: return;
        case Op::Arc:
            append_circle(out, motion.arc(), motion.plane);
            if (motion.arc().turns != 0) append_field(out, "turns", motion.arc().turns);
            break;
        case Op::Spline: append_spline(out, motion.spline()); break;
        case Op::Involute:
            append_circle(out, motion.involute(), motion.plane);
            append_field(out, "base_radius", motion.involute().base_radius);
            break;
        case Op::Parametric: append_curve(out, motion.curve()); break;
        default: break;
    }
    append_feed(out, motion);
    if (motion.op() != Op::Thread) return;
    const path::ThreadShape& thread = motion.thread();
    if (thread.pitch_change != 0) append_field(out, "lead_change", thread.pitch_change);
    if (thread.start_deg != 0) append_field(out, "start", thread.start_deg);
}

}  // namespace

Listing::Listing(const machine::Machine& machine) {
    for (const machine::MachineAxis& axis : machine.axes) axes_ |= bit(axis.axis);
}

void Listing::append(const Command& command, std::string_view source, std::string& out) const {
    out += "{\"op\":\"";
    out += path::op_name(command.op());
    out += '"';
    switch (command.op()) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Spline:
        case Op::Involute:
        case Op::Parametric:
        case Op::Thread:
        case Op::Probe: append_motion(out, command.motion(), axes_); break;
        case Op::Dwell: append_dwell(out, command.dwell()); break;
        case Op::Spindle:
        case Op::OtherSpindle: append_spindle(out, command.spindle()); break;
        case Op::SpeedLimit: append_speed_limit(out, command.speed_limit()); break;
        case Op::Tool: append_field(out, "tool", static_cast<double>(command.tool().number)); break;
        case Op::ToolLength: append_tool_length(out, command.tool_length()); break;
        case Op::Coolant: append_word(out, "mode", coolant_name(command.coolant().mode)); break;
        case Op::Function:
            append_field(out, "code", static_cast<double>(command.function().code));
            append_word(out, "step", step_name(command.function().step));
            break;
        case Op::Message: append_text(out, "text", command.message().text); break;
        case Op::External: append_field(out, "time", command.external().time); break;
        case Op::Stop:
        case Op::OptionalStop:
        case Op::ScannerOn:
        case Op::ScannerOff:
        case Op::End: break;
    }
    if (command.is_motion()) append_ending(out, command.motion());
    if (command.line != 0) append_field(out, "iso", command.line);
    if (!source.empty()) append_text(out, "src", source);
    out += "}\n";
}

}  // namespace kadr::interp
