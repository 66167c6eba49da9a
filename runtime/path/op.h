// op.h — the kinds of commands, by which lists of commands and machine files name them.
#pragma once

#include <cstdint>

namespace kadr::path {

enum class Op : std::uint8_t {
    Rapid,
    Line,
    Arc,
    Spline,
    Involute,
    Parametric,  // a curve of a registered kind
    Thread,      // a line geared to the spindle
    Probe,       // a line that ends where the probe triggers
    Dwell,
    Spindle,       // the master spindle, which paths follow
    OtherSpindle,  // one that they do not
    SpeedLimit,
    Tool,
    ToolLength,
    Coolant,
    Function,  // an M function that takes the machine time
    Stop,
    OptionalStop,
    Message,
    End,
    ScannerOn,   // motions from here on are the scanner's; the axes stand
    ScannerOff,  // … and the axes' again
    External,    // the axes stand while a module beside them works
};

/// Whether the tool moves along a path.
constexpr bool is_motion(Op op) { return op <= Op::Probe; }
constexpr bool is_straight(Op op) { return op == Op::Line || op == Op::Rapid; }

}  // namespace kadr::path
