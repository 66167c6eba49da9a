// machine.h — a machine tool as its XML file describes it. Immutable.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/diagnostic.h"
#include "base/units.h"
#include "machine/chain.h"
#include "machine/pipeline_data.h"
#include "machine/process_data.h"
#include "machine/scanner_data.h"

namespace kadr::machine {

/// Reference points of an axis: the one where it is referenced, and three that the builder sets.
inline constexpr std::size_t kReferencePoints = 4;

/// One physical axis. Canonical units: mm or rad, and seconds.
struct MachineAxis {
    std::string name;     // "X"
    Axis axis = Axis::X;  // the logical axis that programs it
    bool is_rotary = false;
    double lower = 0;  // software limits; infinite if the machine has none
    double upper = 0;
    double velocity = 0;      // > 0; rapid traverse
    double acceleration = 0;  // > 0
    double jerk = 0;          // > 0; infinite if not limited
    /// By how much its velocity may change in a tick at a corner, and its acceleration where the
    /// curvature changes; > 0. Not given: acceleration · tick, jerk · tick.
    std::optional<double> corner_jump{};
    std::optional<double> curvature_jump{};
    double home = 0;  // reference point, where the axis stands at program start
    /// Reference points 2, 3 and 4, if the machine has them.
    std::array<std::optional<double>, kReferencePoints - 1> further_homes{};
};

/// A tool may have so many cutting edges; SINUMERIK reference 2.3.
inline constexpr std::int64_t kMostEdges = 12;

/// One cutting edge of a tool.
struct ToolData {
    std::int64_t number = 0;
    std::int64_t edge = 1;  // 1 to kMostEdges; every tool has edge 1
    double length = 0;      // mm
    double radius = 0;      // mm
    double length_x = 0;    // mm, of a lathe's tool: along X, on the radius
    int tip = 0;            // where the programmed point lies on the nose of a lathe's tool, 1 to 9
    std::string name;       // of edge 1: of the tool; further edges have none
};

/// The spindles of a machine are numbered from 1 to this one at most.
inline constexpr std::int64_t kMostSpindles = 4;

/// A spindle besides the first one.
struct MachineSpindle {
    std::int64_t number = 2;  // to kMostSpindles
    double max_speed = 0;     // rev/s; 0: no limit
    double orient_time = 0;   // s
};

/// When an M function is issued, as the motion of its block sees it.
enum class FunctionTime : std::uint8_t { BeforeMotion, WithMotion, AfterMotion };

/// An M function of the machine as its PLC answers it.
struct MachineFunction {
    std::int64_t code = 0;  // M10: 10
    double takes = 0;       // s, ≥ 0, from being issued to being acknowledged
    FunctionTime acts = FunctionTime::BeforeMotion;
    bool waits = true;  // what comes behind it waits for the acknowledgement
};

/// Longest interpolation period, s: limits hold from tick to tick.
inline constexpr double kShortestTick = 1e-6;
inline constexpr double kLongestTick = 1;

struct Machine {
    std::string name;
    std::string title;
    double tick = 0.001;             // s, interpolation period, kShortestTick to kLongestTick
    double corner_tolerance = 0.05;  // mm, of corner blending if the program gives none
    double orientation_tolerance = rad_from_deg(0.05);  // rad, of the tool at blended corners
    double compressor_tolerance = 0.01;      // mm, of compressed lines if the program gives none
    double max_feed = 0;                     // mm/s, path; 0: no limit of its own
    double max_speed = 0;                    // rev/s of the first spindle; 0: no limit
    double orient_time = 0;                  // s, of the first spindle
    std::vector<MachineSpindle> spindles;    // besides the first one, in the order of their numbers
    double tool_change_time = 0;             // s
    bool is_lathe = false;                   // X is programmed as a diameter; axis X is the radius
    std::vector<MachineAxis> axes;           // in the order of setpoint columns
    std::vector<ToolData> tools;             // an entry for each cutting edge
    std::vector<MachineFunction> functions;  // M functions that take time
    std::vector<AxisValues> work_offsets;    // [0] none, [1] G54 …; mm, deg
    std::optional<Kinematics> kinematics;    // if it has rotary axes that the file places
    std::optional<Drives> drives;            // if the file describes both drives
    std::optional<Laser> laser;
    std::optional<Scanner> scanner;
    Pipeline pipeline;

    const MachineAxis* find(Axis axis) const;
    /// The first edge of the tool; null: there is none with this number.
    const ToolData* find_tool(std::int64_t number) const;
    bool has_spindle(std::int64_t number) const;
    /// Of a spindle by its number, 0 and 1 the first one: rev/s, 0 no limit; s.
    double max_speed_of(std::int64_t number) const;
    double orient_time_of(std::int64_t number) const;
    const MachineFunction* find_function(std::int64_t code) const;
};

using SearchPath = std::vector<std::string>;

/// Loads a machine by name or by file; a text with a `/` or with the ending `.xml` is a file. Every
/// mistake is reported with its location; nothing is returned then.
std::optional<Machine> load_machine(const std::string& name_or_file, const SearchPath& folders,
                                    Sources& sources, DiagnosticSink& sink);

/// A machine that can be loaded by name.
struct MachineSummary {
    std::string name;  // of the file, without its ending
    std::string title;
    std::string file;
    std::string axes;  // "X Y Z"; empty if the file has mistakes
};

/// The machines of these folders in the order of their names; the first folder wins a name.
std::vector<MachineSummary> list(const SearchPath& folders, const Files& files);

}  // namespace kadr::machine
