#include "interp/listing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/json_writer.h"
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

template <std::size_t... I>
consteval std::array<JsonName, kAxes> axis_keys(std::index_sequence<I...>) {
    return {JsonName(kAxisNames[I])...};
}
constexpr std::array<JsonName, kAxes> kAxisKeys = axis_keys(std::make_index_sequence<kAxes>());

void put_field(JsonWriter& json, JsonName name, double value) { json.key(name).coordinate(value); }

void put_numbers(JsonWriter& json, std::span<const double> values) {
    json.array([&] {
        for (const double value : values) json.coordinate(value);
    });
}
void put_numbers(JsonWriter& json, const path::Vec3& values) {
    put_numbers(json, std::span<const double>(values.data(), 3));
}

/// Where the cutter touches from and to, and how: the path of the tip follows from it.
void put_contact(JsonWriter& json, const path::ContactMotion& motion) {
    json.key("touches").array([&] {
        put_numbers(json, motion.from);
        put_numbers(json, motion.to);
    });
    put_field(json, "radius", motion.contact.radius);
    if (motion.contact.kind != path::ContactKind::Face)
        return put_field(json, "depth", motion.contact.depth);
    put_field(json, "edge", motion.contact.depth);
    json.key("normals").array([&] {
        put_numbers(json, motion.contact.guide);
        put_numbers(json, path::guide_at(motion.contact, 1));
    });
}

/// In which coordinates the position is given.
void put_virtual(JsonWriter& json, const path::VirtualAxes& axes) {
    switch (axes.kind) {
        case path::VirtualKind::None: return;
        case path::VirtualKind::Polar: json.key("on").value("face"); return;
        case path::VirtualKind::Cylinder:
            json.key("on").value("cylinder");
            put_field(json, "radius", axes.size);
            return;
        case path::VirtualKind::Inclined: json.key("on").value("inclined"); return;
    }
}

/// The end of a motion: the axes that are shown, those that it turns by itself among them.
void put_end(JsonWriter& json, const path::Motion& motion, AxisMask axes) {
    if (motion.virtual_axes().turns()) axes |= bit(motion.virtual_axes().virtual_axis());
    json.key("to").object([&] {
        for (std::size_t i = 0; i < kAxes; ++i) {
            if ((axes >> i & 1u) != 0) json.key(kAxisKeys[i]).coordinate(motion.to[i]);
        }
    });
}

void put_target(JsonWriter& json, const path::Motion& motion, AxisMask axes) {
    put_end(json, motion, axes);
    if (motion.machine_coordinates) json.key("machine_coordinates").value(true);
    if (motion.virtual_axes().is_on()) return put_virtual(json, motion.virtual_axes());
    if (motion.orient_kind == path::OrientKind::None) return;
    json.key("tool");
    put_numbers(json, motion.direction);
    if (motion.orient_kind == path::OrientKind::Straight) json.key("point_to_point").value(true);
    if (motion.contact) put_contact(json, *motion.contact);
}

/// The control points between the ends; the weights of all, unless they are all one.
void put_spline(JsonWriter& json, const path::SplineShape& shape) {
    json.key("degree").value(shape.degree);
    const auto count = static_cast<std::size_t>(shape.degree);
    json.key("poles").array([&] {
        for (std::size_t i = 0; i + 1 < count; ++i) put_numbers(json, shape.inner[i]);
    });
    const std::span<const double> weights(shape.weights.data(), count + 1);
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 1; })) return;
    json.key("weights");
    put_numbers(json, weights);
}

/// The kind, what it works with, and the range of its parameter.
void put_curve(JsonWriter& json, const path::CurveShape& shape) {
    json.key("kind").value(shape.kind->name);
    json.key("numbers");
    put_numbers(json, shape.law.numbers);
    json.key("range").array([&] { json.coordinate(shape.law.from).coordinate(shape.law.to); });
    json.key("linear").array([&] {
        for (Eigen::Index i = 0; i < 3; ++i) put_numbers(json, path::Vec3(shape.linear.row(i)));
    });
}

/// Of an arc or an involute where its circle lies, and how it runs about it.
template <typename Circle>
void put_circle(JsonWriter& json, const Circle& circle, Plane plane) {
    json.key("center");
    put_numbers(json, circle.center);
    json.key("plane").value(plane_name(plane));
    json.key("dir").value(circle.is_clockwise ? "cw" : "ccw");
    // An arc in space goes counter-clockwise about its normal, whatever the plane.
    const path::Vec3 across = path::unit(path::axes_of(plane).normal);
    if (std::abs(circle.normal.dot(across)) < 1 - kSamePlane) {
        json.key("normal");
        put_numbers(json, circle.normal);
    }
}

void put_feed(JsonWriter& json, const path::Motion& motion) {
    put_field(json, "feed", motion.feed);
    if (motion.feed_mode == FeedMode::PerRevolution) json.key("feed_mode").value("per_revolution");
    if (motion.feed_mode == FeedMode::InverseTime) json.key("feed_mode").value("inverse_time");
}

/// Whether it ends at rest, or how the corner behind it is blended; and within what it may be
/// joined to its neighbours, in mm.
void put_ending(JsonWriter& json, const path::Motion& motion) {
    if (motion.exact_stop) json.key("exact_stop").value(true);
    const path::Blending& blending = motion.blending;
    if (blending.kind != path::BlendKind::None && !motion.exact_stop) {
        const bool by_distance = blending.kind == path::BlendKind::Distance;
        put_field(json, by_distance ? JsonName("blend_distance") : JsonName("blend_tolerance"),
                  blending.size);
        if (blending.with_tangents) json.key("blend_tangents").value(true);
        if (motion.orient_kind != path::OrientKind::None && std::isfinite(blending.orientation))
            put_field(json, "blend_orientation", deg_from_rad(blending.orientation));
    }
    if (blending.smooths_orientation && motion.orient_kind > path::OrientKind::Straight &&
        !motion.exact_stop)
        put_field(json, "smooth_orientation", deg_from_rad(blending.orientation));
    if (motion.compress > 0) put_field(json, "compress", motion.compress);
}

void put_spindle(JsonWriter& json, const path::Spindle& spindle) {
    if (spindle.number != 0) put_field(json, "spindle", spindle.number);
    json.key("mode").value(spindle_name(spindle.mode));
    switch (spindle.mode) {
        case SpindleMode::Stop: break;
        case SpindleMode::Orient: put_field(json, "angle", spindle.angle_deg); break;
        case SpindleMode::Cw:
        case SpindleMode::Ccw:
            put_field(json,
                      spindle.has_cutting_speed ? JsonName("cutting_speed") : JsonName("speed"),
                      spindle.speed);
            break;
    }
}

void put_dwell(JsonWriter& json, const path::Dwell& dwell) {
    if (dwell.revolutions > 0) put_field(json, "revolutions", dwell.revolutions);
    else put_field(json, "time", dwell.time);
}

void put_speed_limit(JsonWriter& json, const path::SpeedLimit& limit) {
    put_field(json, "speed", limit.most);
    if (limit.least > 0) put_field(json, "least_speed", limit.least);
}

void put_tool_length(JsonWriter& json, const path::ToolLength& length) {
    static constexpr std::array<JsonName, 3> kNames = {"length_x", "length_y", "length_z"};
    json.key("tool").value(length.number);
    put_field(json, "length", length.length);
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const double aside = length.aside[static_cast<Eigen::Index>(i)];
        if (aside != 0) put_field(json, kNames[i], aside);
    }
}

/// Where a motion leads, on which shape, and how fast.
void put_motion(JsonWriter& json, const path::Motion& motion, AxisMask axes) {
    put_target(json, motion, axes);
    switch (motion.op()) {
        case Op::Rapid: return;
        case Op::Arc:
            put_circle(json, motion.arc(), motion.plane);
            if (motion.arc().turns != 0) put_field(json, "turns", motion.arc().turns);
            break;
        case Op::Spline: put_spline(json, motion.spline()); break;
        case Op::Involute:
            put_circle(json, motion.involute(), motion.plane);
            put_field(json, "base_radius", motion.involute().base_radius);
            break;
        case Op::Parametric: put_curve(json, motion.curve()); break;
        default: break;
    }
    put_feed(json, motion);
    if (motion.op() != Op::Thread) return;
    const path::ThreadShape& thread = motion.thread();
    if (thread.pitch_change != 0) put_field(json, "lead_change", thread.pitch_change);
    if (thread.start_deg != 0) put_field(json, "start", thread.start_deg);
}

/// What the command has beside its name and its location.
void put_command(JsonWriter& json, const Command& command, AxisMask axes) {
    switch (command.op()) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Spline:
        case Op::Involute:
        case Op::Parametric:
        case Op::Thread:
        case Op::Probe: put_motion(json, command.motion(), axes); break;
        case Op::Dwell: put_dwell(json, command.dwell()); break;
        case Op::Spindle:
        case Op::OtherSpindle: put_spindle(json, command.spindle()); break;
        case Op::SpeedLimit: put_speed_limit(json, command.speed_limit()); break;
        case Op::Tool: json.key("tool").value(command.tool().number); break;
        case Op::ToolLength: put_tool_length(json, command.tool_length()); break;
        case Op::Coolant: json.key("mode").value(coolant_name(command.coolant().mode)); break;
        case Op::Function:
            json.key("code").value(command.function().code);
            json.key("step").value(step_name(command.function().step));
            break;
        case Op::Message: json.key("text").value(command.message().text); break;
        case Op::External: put_field(json, "time", command.external().time); break;
        case Op::Stop:
        case Op::OptionalStop:
        case Op::ScannerOn:
        case Op::ScannerOff:
        case Op::End: break;
    }
    if (command.is_motion()) put_ending(json, command.motion());
}

}  // namespace

Listing::Listing(const machine::Machine& machine) {
    for (const machine::MachineAxis& axis : machine.axes) axes_ |= bit(axis.axis);
}

void Listing::append(const Command& command, std::string_view source, std::string& out) const {
    JsonWriter json(out);
    json.object([&] {
        json.key("op").value(path::op_name(command.op()));
        put_command(json, command, axes_);
        if (command.line != 0) json.key("iso").value(command.line);
        if (!source.empty()) json.key("src").value(source);
    });
    json.end_line();
}

}  // namespace kadr::interp
