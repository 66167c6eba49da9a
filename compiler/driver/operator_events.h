// operator_events.h — what a person lets the operator do while a program runs.
//
//   5s feed hold                 a line of the file of `--events`
//   N120 + 2s cycle start        … 2 s after the block N120 begins
//   0s feed override 80%
//   5s set $A_IN[3]=1            … a value that the machine gives then
//   N120 touch X25.3             … where the probe triggers in a block
//   5s..7s, N120..2s             what `--hold` takes: from when to when, or from a block on so long
//   100%,5s:50%,9s:120%          what `--feed-override` takes: at the start, and from when on
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/session.h"
#include "interp/interpreter.h"
#include "macro/program.h"
#include "motion/operator_panel.h"

namespace kadr::driver {

/// Parts to which the switches of a control go; the axes have no more than their rapid traverse.
inline constexpr double kMostFeedOverride = 2;
inline constexpr double kMostRapidOverride = 1;

/// A line of the file of `--events` without its remark; nothing: it is none.
std::optional<motion::OperatorEvent> operator_event(std::string_view text);

/// Feed hold and cycle start of `--hold`; without an end the hold lasts. Nothing: it is none.
std::optional<std::vector<motion::OperatorEvent>> hold_events(std::string_view text);

/// A switch as it stands from the start on, and how it is set.
struct OverrideSequence {
    double at_start = 1;  // a part, as in motion::Overrides
    std::vector<motion::OperatorEvent> events;
};
/// Of `--feed-override` and `--rapid-override`. Nothing: it is none, or above `most` (a part).
std::optional<OverrideSequence> override_sequence(std::string_view text, motion::OperatorAct act,
                                                  double most);

/// What a file of `--events` holds.
struct RunEvents {
    std::vector<motion::OperatorEvent> panel;
    std::vector<macro::InputEvent> inputs;
    std::vector<interp::ProbeTouch> touches;
};

/// `N120 touch X25.3`, `:34 touch none`; nothing: it is none.
std::optional<interp::ProbeTouch> probe_touch(std::string_view text);

/// `5s set $A_IN[3]=1`, without the location in its file; nothing: it is none.
std::optional<macro::InputEvent> input_event(std::string_view text);

/// Reads the file of `--events`. Nothing: reported.
std::optional<RunEvents> read_events(Session& session, const std::string& file);

/// The block of an event, as a person names it: `N120`, `:34`.
std::string block_name(std::int64_t number, std::uint32_t line);

}  // namespace kadr::driver
