// active_cycle.h — the cycle of the input dialect's control that was programmed last. For the room
// expand only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "control/cycle_levels.h"
#include "control/program_frame.h"
#include "nc/block.h"
#include "sema/code.h"

namespace kadr::expand {

/// A word of a cycle's mode that the next cycle need not give again, and the parameter that it
/// gives.
struct HeldWord {
    std::string_view parameter;
    char letter;  // of the control
};
inline constexpr std::array<HeldWord, 4> kHeldWords = {
    {{"to", 'Z'}, {"retract", 'R'}, {"peck", 'Q'}, {"dwell", 'P'}}};

/// See sema::SourceCycle. cycles.cpp works on its members; others say what their blocks did to it.
struct ActiveCycle {
    const sema::SourceCycle* source = nullptr;
    bool is_active = false;   // further blocks are positions of it
    bool is_due = false;      // RunCycle calls it
    bool is_running = false;  // its blocks are being made
    std::array<double, nc::kMaxArguments> arguments{};
    std::uint32_t given = 0;  // bit i: argument i
    /// Words of the mode that further cycles need not give again, by the parameters of the library.
    std::array<std::optional<double>, kHeldWords.size()> held;
    control::CycleLevels levels;
    bool returns_low = false;   // G99: to the retract level, not to where the mode began
    bool taps_rigidly = false;  // M29
    // Where the mode began, along the tool axis.
    double initial = 0;
    bool is_initial_known = false;
    control::ProgramFrame frame;
    double work_offset = 0;
    // What its block found and holds again behind it.
    nc::Function motion = nc::Function::None;
    bool was_incremental = false;

    /// The mode ends.
    void end() { is_active = false; }
    /// A block begins that may be one of its positions, while this motion acts.
    void begin_block(nc::Function acting) { motion = acting; }
    void return_low(bool is_low) { returns_low = is_low; }
    void tap_rigidly() { taps_rigidly = true; }
};

}  // namespace kadr::expand
