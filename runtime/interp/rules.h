// rules.h — how a control behaves where controls differ: the switches that its dialect sets.
//
// The table is rules.def; struct, names and documentation are made from it. Rules change what a
// function does, never how it is spelled (that is the rest of the dialect's XML).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostic.h"
#include "nc/dialect.h"
#include "path/radius_comp.h"

namespace kadr::interp {

enum class ArcError : std::uint8_t { Spread, ShiftCenter };
enum class ArcWithoutChord : std::uint8_t { Alarm, NoMotion };
enum class ArcWithoutCenter : std::uint8_t { Alarm, Line };
enum class IncrementalFrame : std::uint8_t { Traversed, Distance };
enum class LengthAxis : std::uint8_t { Plane, Z };
/// Whether a tool that is selected is in the spindle at once.
enum class ToolSelectChanges : std::uint8_t { No, Yes, Lathe };
enum class MissingEnd : std::uint8_t { Warning, Alarm };
/// How the cutter goes to the first point beside the contour, and from the last.
enum class CompStart : std::uint8_t {
    Normal,    // straight to the normal of the contour there, even through it
    Extended,  // at a corner that opens, as if the approach belonged to the contour
    Around,    // around the contour's end if the cutter is behind it
    Tangent,   // on a curve that has the contour's direction there
    Smooth,    // … and its curvature
};
/// What F is of on a compensated arc; Inside: of the contour where the cutter is inside of the arc,
/// else of the cutter's centre.
enum class CompFeed : std::uint8_t { Contour, Center, Inside };

/// What becomes of a path through the centre of a face, where the rotary axis would turn at once.
enum class PolePassage : std::uint8_t { Alarm, Turn };

struct Rules {
#define KADR_RULE(type, field, standard, values, meaning, source) type field = standard;
#include "interp/rules.def"
#undef KADR_RULE
};

/// A row of the table, for documentation and for the check of dialect files.
struct RuleInfo {
    std::string_view name;
    std::string_view values;  // unit, or what may stand there
    std::string_view meaning;
    std::string_view source;
};
std::span<const RuleInfo> all_rules();

/// Sets one rule from its text. False: there is no such rule, or it cannot have that value.
bool set_rule(Rules& rules, std::string_view name, std::string_view value);

/// The rules that the dialect names, defaults for the others. A name that no rule has and a value
/// that a rule cannot have are reported, and the default stays.
Rules rules_of(const nc::Dialect& dialect, DiagnosticSink& sink);

}  // namespace kadr::interp
