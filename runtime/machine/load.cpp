#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/units.h"
#include "base/xml.h"
#include "machine/counting_sink.h"
#include "machine/described.h"
#include "machine/described_machine.h"
#include "machine/element_reader.h"
#include "machine/load_kinematics.h"
#include "machine/load_pipeline.h"
#include "machine/load_scanner.h"
#include "machine/machine.h"
#include "machine/pulse_clock.h"

namespace kadr::machine {

namespace {

namespace fs = std::filesystem;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// G54 … G59, and the 300 further ones that the largest controls have.
constexpr std::int64_t kMostOffsets = 306;
constexpr std::int64_t kMostTools = 99'999'999;

constexpr auto Filled = XmlAttributeRule::Use::Filled;

/// What a machine file may hold, and where; mirrors machine.xsd.
const XmlShape& machine_shape() {
    static const std::vector<XmlRule> rules = {
        {"machine",
         {{"name", Filled},
          "title",
          "kind",
          "tick",
          "max_feed",
          "max_speed",
          "orient_time",
          "tool_change_time",
          "corner_tolerance",
          "orientation_tolerance",
          "compressor_tolerance",
          "tools"},
         {"axis", "tool", "offset", "spindle_drive", "feed_drive", "cutting", "laser", "function",
          "scanner", "spindle", "kinematics", "pipeline", "data", "probe"}},
        {"axis",
         {{"name", Filled},
          "limits",
          {"velocity", Filled},
          {"acceleration", Filled},
          "jerk",
          "corner_jump",
          "curvature_jump",
          "home",
          "home2",
          "home3",
          "home4",
          "machine_name"},
         {}},
        {"probe", {"radius", "length_to", "offset", "error"}, {"plane", "block", "boss", "bore"}},
        {"plane", {{"axis", Filled}, {"at", Filled}, "material"}, {}},
        {"block", {{"from", Filled}, {"to", Filled}}, {}},
        {"boss", {{"center", Filled}, {"diameter", Filled}, "height"}, {}},
        {"bore", {{"center", Filled}, {"diameter", Filled}, "depth"}, {}},
        {"data", {{"name", Filled}, {"value", XmlAttributeRule::Use::Needed}}, {}},
        {"tool", {{"number", Filled}, "edge", "length", "length_x", "radius", "tip", "name"}, {}},
        {"offset", {{"number", Filled}, "x", "y", "z", "a", "b", "c", "u", "v", "w"}, {}},
        {"spindle_drive",
         {{"inertia", Filled},
          {"torque_constant", Filled},
          {"time_constant", Filled},
          "friction",
          "damping",
          "max_current"},
         {}},
        {"feed_drive", {{"gain", Filled}, {"time_constant", Filled}, "feed_forward"}, {}},
        {"cutting", {{"force", Filled}}, {}},
        {"spindle", {{"number", Filled}, "max_speed", "orient_time"}, {}},
        {"function", {{"code", Filled}, {"takes", Filled}, "acts", "waits"}, {}},
        {"pipeline", {"ahead"}, {"serve", "translate", "interpolate", "output"}},
        {"serve", {{"command", Filled}, {"by", Filled}}, {}},
        {"translate", {"period", "batch", "queue"}, {}},
        {"interpolate", {"period", "queue"}, {}},
        {"output", {"period", "file", "columns"}, {}},
        {"laser", {"pulse", "tolerance", "mode", "power", "least_power"}, {}},
        {"scanner",
         {{"on", Filled},
          {"off", Filled},
          {"field", Filled},
          {"jump_speed", Filled},
          "mark_speed",
          "step",
          "jump_delay",
          "mark_delay",
          "polygon_delay",
          "polygon",
          "laser_on_delay",
          "laser_off_delay",
          "pulse",
          "matrix",
          "correction",
          "chord_tolerance",
          "list_size"},
         {}},
        {"kinematics",
         {"tool_direction", "l1", "l2", "start", "uvw_compensation", "path_choice",
          "pole_tolerance", "swivel_reference"},
         {"rotary", "tool_rotation"}},
        {"rotary", {{"axis", Filled}, {"on", Filled}, {"direction", Filled}, "point", "sign"}, {}},
        {"tool_rotation", {{"axis", Filled}, "sign"}, {}},
    };
    static const XmlShape shape = {"a machine file", rules};
    return shape;
}

// The attributes of an <offset> that are axes, in the order of `Axis`.
constexpr std::array<std::string_view, kAxes> kOffsetAxes = {"x", "y", "z", "a", "b",
                                                             "c", "u", "v", "w"};
constexpr std::string_view kKinds[] = {"mill", "lathe"};
constexpr std::string_view kYesNo[] = {"yes", "no"};
// In the order of FunctionTime.
constexpr std::string_view kFunctionTimes[] = {"before", "with", "after"};
constexpr std::string_view kPulseModes[] = {"synchronised", "stop"};

/// The dimensions of an axis' attributes.
struct AxisDimensions {
    QuantityKind position;
    QuantityKind velocity;
    QuantityKind acceleration;
    QuantityKind jerk;
};
constexpr AxisDimensions kLinear = {QuantityKind::Length, QuantityKind::Velocity,
                                    QuantityKind::Acceleration, QuantityKind::Jerk};
constexpr AxisDimensions kRotary = {QuantityKind::Angle, QuantityKind::AngularVelocity,
                                    QuantityKind::AngularAcceleration, QuantityKind::AngularJerk};

/// A position with its unit, as messages show it.
std::string shown_position(const MachineAxis& axis, double position) {
    const double value = axis.is_rotary ? deg_from_rad(position) : position;
    return format_shortest(round_to(value, 6)) + (axis.is_rotary ? " deg" : " mm");
}

/// Builds one Machine from its element; mistakes go to the sink and loading goes on, so that one
/// look at the file finds them all.
class MachineBuilder {
  public:
    MachineBuilder(const XmlElement& root, Sources& sources, DiagnosticSink& sink)
        : root_(root), sources_(sources), sink_(sink) {}

    DescribedMachine build() {
        machine_.work_offsets.resize(1, AxisValues{});
        read_machine();
        for (const XmlElement& child : root_.children) read_child(child);
        // Behind the axes, wherever they stand in the file.
        if (kinematics_ != nullptr)
            machine_.kinematics = read_kinematics(*kinematics_, machine_.axes, sink_);
        if (pipeline_ != nullptr) machine_.pipeline = read_pipeline(*pipeline_, machine_, sink_);
        check_edges();
        check_pulses();
        if (has_spindle_drive_ && has_feed_drive_) machine_.drives = drives_;
        if (machine_.axes.empty()) {
            sink_.report(diag::MachineWithoutAxes, root_.range).arg(machine_.name);
        }
        return {std::move(machine_), std::move(machine_data_)};
    }

  private:
    void read_machine() {
        const ElementReader reader(root_, sink_);
        machine_.name = reader.text("name");
        machine_.title = reader.text("title");
        machine_.is_lathe = reader.choice("kind", kKinds).value_or(0) == 1;
        machine_.tick = reader.positive("tick", QuantityKind::Time).value_or(machine_.tick);
        check_tick();
        machine_.max_feed = reader.positive("max_feed", QuantityKind::Velocity).value_or(0);
        machine_.max_speed =
            reader.positive("max_speed", QuantityKind::AngularVelocity).value_or(0) /
            (2 * std::numbers::pi);
        machine_.orient_time = reader.magnitude("orient_time", QuantityKind::Time).value_or(0);
        machine_.tool_change_time =
            reader.magnitude("tool_change_time", QuantityKind::Time).value_or(0);
        machine_.corner_tolerance = reader.magnitude("corner_tolerance", QuantityKind::Length)
                                        .value_or(machine_.corner_tolerance);
        machine_.orientation_tolerance =
            reader.magnitude("orientation_tolerance", QuantityKind::Angle)
                .value_or(machine_.orientation_tolerance);
        machine_.compressor_tolerance =
            reader.magnitude("compressor_tolerance", QuantityKind::Length)
                .value_or(machine_.compressor_tolerance);
        const fs::path tools = reader.text("tools");
        if (!tools.empty())
            machine_data_.tools =
                (fs::path(sources_.name(root_.range.file)).parent_path() / tools).string();
    }

    void check_tick() {
        const XmlAttribute* attribute = root_.find("tick");
        if (attribute == nullptr || !(machine_.tick > 0)) return;
        if (machine_.tick >= kShortestTick && machine_.tick <= kLongestTick) return;
        sink_.report(diag::MachineTick, attribute->value_range).arg(attribute->value);
        machine_.tick = kLongestTick;
    }

    /// Elements that are not known have been reported by the check of the shape.
    void read_child(const XmlElement& child) {
        if (child.name == "axis") read_axis(child);
        if (child.name == "tool") read_tool(child);
        if (child.name == "offset") read_offset(child);
        if (child.name == "spindle") read_spindle(child);
        if (child.name == "spindle_drive") read_spindle_drive(child);
        if (child.name == "feed_drive") read_feed_drive(child);
        if (child.name == "cutting") read_cutting(child);
        if (child.name == "laser") read_laser(child);
        if (child.name == "function") read_function(child);
        if (child.name == "data") read_datum(child);
        if (child.name == "probe" && described_.require_first("the probe", child.range))
            machine_data_.probe = read_probe(child, sink_);
        if (child.name == "scanner" && described_.require_first("the scanner", child.range))
            machine_.scanner = read_scanner(child, sources_, sink_);
        if (child.name == "kinematics" &&
            described_.require_first("the chain of rotary axes", child.range))
            kinematics_ = &child;
        // Read behind the others, which it refers to.
        if (child.name == "pipeline" && described_.require_first("the pipeline", child.range))
            pipeline_ = &child;
    }

    void read_axis(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("name")) return;
        MachineAxis axis;
        axis.name = reader.text("name");
        const auto known = std::find(kAxisNames.begin(), kAxisNames.end(), axis.name);
        if (known == kAxisNames.end()) {
            auto message = sink_.report(diag::MachineAxisName, reader.location("name"));
            message.arg(axis.name);
            const std::string upper = upper_ascii(axis.name);
            if (std::find(kAxisNames.begin(), kAxisNames.end(), upper) != kAxisNames.end()) {
                message.fix(reader.location("name"), upper, "axes are written in upper case");
            }
            return;
        }
        axis.axis = static_cast<Axis>(known - kAxisNames.begin());
        axis.is_rotary = is_rotary(axis.axis);
        const AxisDimensions& dimension = axis.is_rotary ? kRotary : kLinear;
        axis.velocity = reader.positive("velocity", dimension.velocity).value_or(1);
        axis.acceleration = reader.positive("acceleration", dimension.acceleration).value_or(1);
        axis.jerk = reader.positive("jerk", dimension.jerk).value_or(kInfinity);
        read_jumps(reader, axis, dimension);
        axis.home = reader.quantity("home", dimension.position).value_or(0);
        axis.further_homes = {reader.quantity("home2", dimension.position),
                              reader.quantity("home3", dimension.position),
                              reader.quantity("home4", dimension.position)};
        read_limits(reader, axis, dimension.position);
        const std::string machine_name = upper_ascii(reader.text("machine_name"));
        if (!machine_name.empty() && described_.require_first("an axis `" + machine_name + '`',
                                                              reader.location("machine_name")))
            machine_data_.axis_names.emplace(machine_name, axis.axis);
        if (described_.require_first("axis " + axis.name, reader.location("name")))
            machine_.axes.push_back(axis);
    }

    void read_jumps(const ElementReader& reader, MachineAxis& axis,
                    const AxisDimensions& dimension) {
        axis.corner_jump = reader.positive("corner_jump", dimension.velocity);
        axis.curvature_jump = reader.positive("curvature_jump", dimension.acceleration);
        if (axis.curvature_jump && !reader.has("jerk")) {
            sink_.report(diag::MachineJumpWithoutJerk, reader.location("curvature_jump"))
                .arg(axis.name);
            axis.curvature_jump.reset();
        }
    }

    void read_datum(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("name") || !reader.has("value")) return;
        MachineDatum datum{reader.text("name"), reader.text("value"), element.range};
        if (described_.require_first("`" + datum.name + '`', reader.location("name")))
            machine_data_.data.push_back(std::move(datum));
    }

    void read_limits(const ElementReader& reader, MachineAxis& axis, QuantityKind dimension) {
        const auto limits = reader.range("limits", dimension);
        axis.lower = limits ? limits->lower : -kInfinity;
        axis.upper = limits ? limits->upper : kInfinity;
        if (!(axis.lower < axis.upper)) {
            sink_.report(diag::MachineLimitsReversed, reader.location("limits"))
                .arg(shown_position(axis, axis.lower))
                .arg(shown_position(axis, axis.upper));
        } else {
            check_home(reader, axis, "home", axis.home);
            for (std::size_t i = 0; i < axis.further_homes.size(); ++i) {
                if (!axis.further_homes[i]) continue;
                check_home(reader, axis, "home" + std::to_string(i + 2), *axis.further_homes[i]);
            }
        }
    }

    void check_home(const ElementReader& reader, const MachineAxis& axis, const std::string& name,
                    double home) {
        if (home >= axis.lower && home <= axis.upper) return;
        sink_.report(diag::MachineHomeOutside, reader.location(name))
            .arg(axis.name)
            .arg(shown_position(axis, home));
    }

    void read_tool(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("number")) return;
        const auto number = reader.whole("number", 1, kMostTools);
        ToolData tool;
        tool.name = reader.text("name");
        tool.length = reader.quantity("length", QuantityKind::Length).value_or(0);
        tool.length_x = reader.quantity("length_x", QuantityKind::Length).value_or(0);
        tool.radius = reader.magnitude("radius", QuantityKind::Length).value_or(0);
        tool.tip = static_cast<int>(reader.whole("tip", 0, 9).value_or(0));
        const bool has_edge = reader.has("edge");
        const auto edge = has_edge ? reader.whole("edge", 1, kMostEdges) : 1;
        if (!number || !edge) return;
        tool.edge = *edge;
        const std::string what =
            "tool " + std::to_string(*number) +
            (tool.edge == 1 ? std::string() : ", edge " + std::to_string(tool.edge));
        if (!described_.require_first(what, reader.location(has_edge ? "edge" : "number"))) return;
        if (tool.edge == 1) first_edges_.insert(*number);
        else further_edges_.push_back({*number, tool.edge, reader.location("edge")});
        if (tool.edge != 1 && !tool.name.empty()) {
            sink_.report(diag::MachineEdgeName, reader.location("name"))
                .arg(*number)
                .arg(tool.edge);
            return;
        }
        if (!tool.name.empty() &&
            !described_.require_first("a tool `" + tool.name + '`', reader.location("name")))
            return;
        tool.number = *number;
        machine_.tools.push_back(tool);
    }

    /// A tool is known by its first edge.
    void check_edges() {
        for (const EdgeLocation& location : further_edges_) {
            if (first_edges_.contains(location.tool)) continue;
            sink_.report(diag::MachineEdgeAlone, location.range)
                .arg(location.tool)
                .arg(location.edge);
        }
    }

    void read_function(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("code")) return;
        const std::string text = reader.text("code");
        const std::string digits = text.starts_with('M') ? text.substr(1) : "";
        MachineFunction function;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), function.code);
        const bool is_code = !digits.empty() && error == std::errc() &&
                             end == digits.data() + digits.size() && function.code >= 0;
        const char* other = is_code ? said_elsewhere(function.code) : "";
        if (!is_code || other != nullptr) {
            auto message = sink_.report(diag::MachineFunctionCode, reader.location("code"));
            message.arg(text).arg(is_code ? other : "not an M function; write `M10`");
            return;
        }
        function.takes = reader.magnitude("takes", QuantityKind::Time).value_or(0);
        const bool is_off = function.code == 5 || function.code == 9;
        function.acts = static_cast<FunctionTime>(
            reader.choice("acts", kFunctionTimes).value_or(is_off ? 2 : 0));
        function.waits = reader.choice("waits", kYesNo).value_or(0) == 0;
        if (described_.require_first("function M" + std::to_string(function.code),
                                     reader.location("code")))
            machine_.functions.push_back(function);
    }

    /// M functions that have no time of their own; null: this one may have.
    static const char* said_elsewhere(std::int64_t code) {
        switch (code) {
            case 6: return "given by `tool_change_time`";
            case 19: return "given by `orient_time`";
            case 0:
            case 1:
            case 2:
            case 17:
            case 30: return "a stop or an end of the program, which waits for the operator";
            case 98:
            case 99: return "a call or a return";
            default: return nullptr;
        }
    }

    void read_offset(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("number")) return;
        const auto number = reader.whole("number", 1, kMostOffsets);
        AxisValues values{};
        for (std::size_t i = 0; i < kAxes; ++i) {
            const bool rotary = is_rotary(static_cast<Axis>(i));
            // Attribute names are the axes' in lower case, as everything in the file is.
            const auto value = reader.quantity(kOffsetAxes[i],
                                               rotary ? QuantityKind::Angle : QuantityKind::Length);
            if (value) values[i] = rotary ? deg_from_rad(*value) : *value;
            if (value && !has_axis(static_cast<Axis>(i))) {
                sink_.report(diag::MachineOffsetAxis, reader.location(kOffsetAxes[i]))
                    .arg(machine_.name)
                    .arg(kAxisNames[i]);
            }
        }
        if (!number || !described_.require_first("offset " + std::to_string(*number),
                                                 reader.location("number"))) {
            return;
        }
        const auto position = static_cast<std::size_t>(*number);
        if (machine_.work_offsets.size() <= position) {
            machine_.work_offsets.resize(position + 1, AxisValues{});
        }
        machine_.work_offsets[position] = values;
    }

    /// Whether an element of the file describes the axis, wherever it stands.
    bool has_axis(Axis axis) const {
        return std::ranges::any_of(root_.children, [&](const XmlElement& child) {
            const XmlAttribute* name = child.name == "axis" ? child.find("name") : nullptr;
            return name != nullptr && name->value == kAxisNames[index(axis)];
        });
    }

    void read_spindle(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("number")) return;
        const auto number = reader.whole("number", 2, kMostSpindles);
        MachineSpindle spindle;
        spindle.max_speed =
            reader.positive("max_speed", QuantityKind::AngularVelocity).value_or(0) /
            (2 * std::numbers::pi);
        spindle.orient_time = reader.magnitude("orient_time", QuantityKind::Time).value_or(0);
        if (!number || !described_.require_first("spindle " + std::to_string(*number),
                                                 reader.location("number")))
            return;
        spindle.number = *number;
        machine_.spindles.push_back(spindle);
        std::ranges::sort(machine_.spindles, {}, &MachineSpindle::number);
    }

    // Values that are wrong have been reported; 1 stands for them until the file is refused.
    void read_spindle_drive(const XmlElement& element) {
        if (!described_.require_first("the spindle drive", element.range)) return;
        const ElementReader reader(element, sink_);
        SpindleDrive& drive = drives_.spindle;
        drive.inertia = reader.positive("inertia", QuantityKind::Inertia).value_or(1);
        drive.torque_constant =
            reader.positive("torque_constant", QuantityKind::TorquePerCurrent).value_or(1);
        drive.time_constant = reader.positive("time_constant", QuantityKind::Time).value_or(1);
        drive.friction = reader.magnitude("friction", QuantityKind::Torque).value_or(0);
        drive.damping = reader.magnitude("damping", QuantityKind::Damping).value_or(0);
        drive.max_current =
            reader.positive("max_current", QuantityKind::Current).value_or(kInfinity);
        has_spindle_drive_ = true;
    }

    void read_feed_drive(const XmlElement& element) {
        if (!described_.require_first("the feed drive", element.range)) return;
        const ElementReader reader(element, sink_);
        FeedDrive& drive = drives_.feed;
        drive.gain = reader.positive("gain", QuantityKind::Rate).value_or(1);
        drive.time_constant = reader.positive("time_constant", QuantityKind::Time).value_or(1);
        drive.feed_forward = reader.share("feed_forward").value_or(1);
        has_feed_drive_ = true;
    }

    void read_cutting(const XmlElement& element) {
        if (!described_.require_first("the cutting load", element.range)) return;
        const ElementReader reader(element, sink_);
        drives_.cutting_force = reader.magnitude("force", QuantityKind::Force).value_or(0);
    }

    void read_laser(const XmlElement& element) {
        if (!described_.require_first("the laser", element.range)) return;
        const ElementReader reader(element, sink_);
        Laser laser;
        laser.pulse = reader.positive("pulse", QuantityKind::Frequency).value_or(0);
        laser.tolerance = reader.share("tolerance").value_or(0);
        laser.mode = static_cast<PulseMode>(reader.choice("mode", kPulseModes).value_or(0));
        laser.power = reader.positive("power", QuantityKind::Power).value_or(0);
        laser.least_power = reader.magnitude("least_power", QuantityKind::Power).value_or(0);
        if (laser.power > 0 && laser.least_power > laser.power) {
            sink_.report(diag::LaserLeastPower, reader.location("least_power"))
                .arg(laser.least_power)
                .arg(laser.power);
        }
        machine_.laser = laser;
        laser_location_ = reader.location("pulse");
    }

    /// Points are burnt on ticks.
    void check_pulses() {
        if (!machine_.laser || machine_.laser->pulse == 0) return;
        if (pulse_clock(*machine_.laser, machine_.tick)) return;
        sink_.report(diag::MachinePulseBetweenTicks, laser_location_)
            .arg(round_to(machine_.laser->pulse, 6))
            .arg(round_to(1 / (machine_.laser->pulse * machine_.tick), 3));
    }

    const XmlElement& root_;
    Sources& sources_;
    DiagnosticSink& sink_;
    Machine machine_;
    MachineData machine_data_;
    SourceRange laser_location_;
    /// A further edge of a tool, and where the file has it.
    struct EdgeLocation {
        std::int64_t tool = 0;
        std::int64_t edge = 0;
        SourceRange range;
    };
    std::vector<EdgeLocation> further_edges_;
    std::set<std::int64_t> first_edges_;  // tools that have one
    const XmlElement* kinematics_ = nullptr;
    Drives drives_;
    bool has_spindle_drive_ = false;
    bool has_feed_drive_ = false;
    const XmlElement* pipeline_ = nullptr;
    Described described_{sink_};
};

std::optional<DescribedMachine> load_text(FileId file, Sources& sources, DiagnosticSink& sink) {
    const auto root = parse_xml(file, sources, machine_shape(), sink);
    if (!root) return std::nullopt;
    // One look at the file finds the mistakes of its shape and those of its values.
    CountingSink counting(sink);
    const Done has_shape = check_xml(*root, machine_shape(), counting);
    DescribedMachine machine = MachineBuilder(*root, sources, counting).build();
    if (!has_shape || counting.has_errors()) return std::nullopt;
    return machine;
}

bool is_file_name(const std::string& text) {
    return text.find('/') != std::string::npos || text.ends_with(".xml");
}

/// The stock file of this name, if any folder has it.
std::optional<std::string> find_stock(const std::string& name, const SearchPath& folders,
                                      const Files& files) {
    for (const std::string& folder : folders) {
        std::string path = (fs::path(folder) / (name + ".xml")).string();
        if (files.is_file(path)) return path;
    }
    return std::nullopt;
}

void report_unknown_machine(const std::string& name, const SearchPath& folders, const Files& files,
                            DiagnosticSink& sink) {
    const std::vector<MachineSummary> machines = list(folders, files);
    std::vector<std::string_view> names;
    std::string known;
    for (const MachineSummary& machine : machines) {
        names.push_back(machine.name);
        known.append(known.empty() ? "`" : ", `").append(machine.name).append("`");
    }
    auto message = sink.report(diag::MachineUnknown);
    message.arg(name);
    if (const auto better = proposal(name, names)) message.fix("there is `" + *better + "`");
    if (!known.empty()) message.note("known are " + known);
}

}  // namespace

std::optional<Machine> load_machine(const std::string& name_or_file, const SearchPath& folders,
                                    Sources& sources, DiagnosticSink& sink) {
    auto described = load_described_machine(name_or_file, folders, sources, sink);
    if (!described) return std::nullopt;
    return std::move(described->machine);
}

std::optional<DescribedMachine> load_described_machine(const std::string& name_or_file,
                                                       const SearchPath& folders, Sources& sources,
                                                       DiagnosticSink& sink) {
    std::string path = name_or_file;
    if (!is_file_name(name_or_file)) {
        const auto stock = find_stock(name_or_file, folders, sources.files());
        if (!stock) {
            report_unknown_machine(name_or_file, folders, sources.files(), sink);
            return std::nullopt;
        }
        path = *stock;
    }
    const auto file = sources.read(path);
    if (!file) {
        sink.report(diag::FileUnreadable).arg(path);
        return std::nullopt;
    }
    return load_text(*file, sources, sink);
}

namespace {

MachineSummary summary_of(const fs::path& file, const Files& files) {
    MachineSummary summary;
    summary.name = file.stem().string();
    summary.file = file.string();
    Sources sources(files);
    DiagnosticList unheard;  // `kadr machine check` reports what is wrong with a file
    if (const auto machine = load_machine(summary.file, {}, sources, unheard)) {
        summary.title = machine->title;
        for (const MachineAxis& axis : machine->axes) {
            summary.axes.append(summary.axes.empty() ? "" : " ").append(axis.name);
        }
    }
    return summary;
}

}  // namespace

std::vector<MachineSummary> list(const SearchPath& folders, const Files& files) {
    std::map<std::string, MachineSummary> machines;
    for (const std::string& folder : folders) {
        for (const FolderEntry& entry : files.list(folder)) {
            const fs::path file = fs::path(folder) / entry.name;
            if (file.extension() != ".xml" || machines.contains(file.stem().string())) continue;
            machines.emplace(file.stem().string(), summary_of(file, files));
        }
    }
    std::vector<MachineSummary> sorted;
    sorted.reserve(machines.size());
    for (auto& [name, summary] : machines) sorted.push_back(std::move(summary));
    return sorted;
}

}  // namespace kadr::machine
