// channel_state.h — what more than one part of a channel reads. Internal to interp.
//
// A part that may change something of it has a reference that is not const, and tests/house holds
// that no member is written in more than two files.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/done.h"
#include "control/frames.h"
#include "interp/axis_data.h"
#include "interp/block_actions.h"
#include "interp/callers.h"
#include "interp/compensation.h"
#include "interp/contour_run.h"
#include "interp/corners.h"
#include "interp/cycle_run.h"
#include "interp/dangers.h"
#include "interp/interpreter.h"
#include "interp/motion_words.h"
#include "interp/output.h"
#include "interp/position_words.h"
#include "interp/probe.h"
#include "interp/program_clocks.h"
#include "interp/programmed_dynamics.h"
#include "interp/reported_in_run.h"
#include "interp/reporter.h"
#include "interp/shape_run.h"
#include "interp/smooth_approach.h"
#include "interp/snapshot.h"
#include "interp/spline_commands.h"
#include "interp/state.h"
#include "interp/through_run.h"
#include "interp/tool_carrier.h"
#include "interp/tool_names.h"
#include "interp/tool_offsets.h"
#include "interp/work_area.h"
#include "machine/orientation.h"
#include "machine/path_choice.h"
#include "nc/effects.h"
#include "nc/rules.h"
#include "path/arc.h"
#include "path/curve.h"
#include "path/involute.h"
#include "path/orient_law.h"

namespace kadr::interp {

/// Where the latest smooth approach has met the contour, in the base system.
struct Approached {
    AxisValues start{};  // P3
    AxisValues end{};    // P4
};

struct ChannelState {
    /// All references outlive it; see Interpreter.
    ChannelState(const nc::Dialect& dialect, const machine::Machine& machine,
                 Stream<nc::Block>& blocks, const nc::BlockLocations* locations,
                 CycleExpander* cycles, const InterpreterOptions& options, DiagnosticSink& sink);
    ChannelState(const ChannelState&) = delete;
    ChannelState& operator=(const ChannelState&) = delete;

    /// What blocks find whose motions are not executed …
    KeptState keep() const;
    /// … and what acts again behind them.
    void take_back(const KeptState& kept);

    const nc::Dialect& dialect;
    const machine::Machine& machine;
    nc::Rules rules;      // a program may write some of them: parameters of the control
    const bool is_lathe;  // the machine is one, or the control is a lathe's
    const InterpreterOptions options;
    AxisData axes;
    Reporter reporter;
    ReportedInRun reported;
    ProgramClocks clocks;

    struct Motion {
        Modal modal{};
        Position position{};
        AxisValues length_shift{};  // machine position − base position: the tool length in force
        AxisValues preset{};        // real position − the one that the program has set
        AxisMask unplaced = 0;      // axes that want a position behind the end of a rotation
        ProgrammedUnits units = ProgrammedUnits::Unsaid;  // that was programmed last
        bool diameter_is_absolute = false;                // X is a diameter as a coordinate only
        bool is_scanning = false;                         // motions are a scanner's
        std::uint64_t block_count = 0;
        PositionWords position_words{};
        ProgrammedDynamics dynamics;
        Probe probe;
    };
    Motion motion;

    struct Frame {
        control::Frames frames;
        std::vector<control::ControlFrame>
            work_offsets{};            // as the machine has them, until the program sets one
        std::int64_t work_offset = 0;  // that acts
    };
    Frame frame;

    struct ToolGroup {
        Tool tool{};
        ExtraTool extra{};
        ToolOffsets tool_offsets;
        ToolNames tool_names;
        ToolCarriers carriers;
        ActiveCarrier carrier{};
        Orienting orienting{};
        Tilting tilted_plane{};
        Virtual virtual_axes{};
    };
    ToolGroup tool;

    struct SpindleGroup {
        ProgrammedSpindle spindle{};                      // the master
        std::vector<ProgrammedSpindle> other_spindles{};  // of machines with several
        bool owes_speed = false;  // the motion side has not been given a new speed
        path::CoolantMode coolant = path::CoolantMode::Off;
    };
    SpindleGroup spindle;

    struct StageGroup {
        CommandOutput output{};
        Corners corners;
        RadiusCompState comp{};
        Compensation compensation{};
        Compensation3d comp_3d{};  // in place of it under CompPeripheral
        path::Contact surface{};   // normals of the surface along the block, of face milling
        ApproachChoice approach_choice{};
        SmoothApproach smooth_approach{};
        std::optional<Approached> approached{};
        WorkArea area{};
        Dangers dangers{};
    };
    StageGroup stage;

    struct CycleGroup {
        CycleExpander* cycles;
        Callers callers;
        ModalCycles modal_cycles{};
        CycleRun cycle{};
        std::vector<PatternRun> patterns{};   // a program called at positions may hold another one
        std::optional<ShapeRun> shape{};      // whose blocks are coming
        std::optional<ContourRun> contour{};  // likewise, for a table of the program
        std::optional<SplineRun> spline{};    // that is being read
        std::optional<ThroughRun> through{};  // … through points
        SplineCommands spline_commands{};     // beside the points of the one that is being read
        bool puts_span = false;               // what is put stands in front of it
        bool taps_rigidly = false;            // of the tapping cycles that follow
    };
    CycleGroup cycle;
};

}  // namespace kadr::interp
