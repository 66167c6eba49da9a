// rules.h — how a control behaves where controls differ: the switches that its dialect sets.
//
// The table is rules.def; struct, names, defaults and documentation are made from it. All rooms ask
// the same typed values of a dialect, so none knows another default. Rules change what a function
// does, never how it is spelled (that is the rest of the dialect's XML).
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kadr::nc {

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
/// What joins two elements at a corner around which the cutter goes.
enum class CompCorner : std::uint8_t { Arc, Intersection, Square };
/// What F is of on a compensated arc; Inside: of the contour where the cutter is inside of the arc,
/// else of the cutter's centre.
enum class CompFeed : std::uint8_t { Contour, Center, Inside };

/// What becomes of a path through the centre of polar coordinate interpolation, where the rotary
/// axis would turn at once.
enum class PolePassage : std::uint8_t { Alarm, Turn };

struct Rules {
#define KADR_RULE(type, field, standard, values, meaning, source) type field = standard;
#include "nc/rules.def"
#undef KADR_RULE

    /// Those of the language's own blocks, as a source has them that names no dialect; a test holds
    /// them against dialects/iso.xml.
    static constexpr Rules of_language() {
        Rules rules;
        rules.arc_tolerance_factor = 0.001;
        rules.tool_change_stops_spindle = true;
        rules.tool_change_activates_length = true;
        return rules;
    }
    friend bool operator==(const Rules&, const Rules&) = default;
};

/// Each rule by its name.
enum class Rule : std::uint8_t {
#define KADR_RULE(type, field, standard, values, meaning, source) field,
#include "nc/rules.def"
#undef KADR_RULE
};

/// A row of the table, for documentation and for the check of dialect files.
struct RuleInfo {
    std::string_view name;
    std::string_view values;  // unit, or what may stand there
    std::string_view meaning;
    std::string_view source;
};
/// In the order of Rule.
std::span<const RuleInfo> all_rules();
std::optional<Rule> rule_named(std::string_view name);

/// Which rules the files of a dialect name; what they do not name has its default.
class NamedRules {
  public:
    void add(Rule rule) { named_.set(static_cast<std::size_t>(rule)); }
    bool has(Rule rule) const { return named_.test(static_cast<std::size_t>(rule)); }

  private:
    std::bitset<256> named_;
};

/// Sets one rule from its text. False: it cannot have that value.
bool set_rule(Rules& rules, Rule rule, std::string_view value);

}  // namespace kadr::nc
