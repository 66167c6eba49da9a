// vocabulary.h — the closed vocabulary of NC functions and its modal groups.
//
// The table is vocabulary.def; enum, names, parameters and documentation are made from it.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kadr::nc {

enum class Function : std::uint16_t {
#define KADR_FUNCTION(id, name, group, facts, parameters, meaning) id,
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
};

inline constexpr std::size_t kFunctions = 0
#define KADR_FUNCTION(id, name, group, facts, parameters, meaning) +1
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
    ;

/// Modal groups of the neutral vocabulary; a dialect maps its own groups onto them.
enum class Group : std::uint8_t {
    NonModal,
    Motion,
    Plane,
    Units,
    Distance,
    FeedMode,
    SpeedMode,
    RadiusComp,
    LengthComp,
    PathMode,
    WorkOffsets,
    Spindle,
    Coolant,
    CycleMode,
    CycleReturn,
    CompStart,
    CompCorner,
    CompCheck,
    Diameter,
    Compressor,
    Transformation,
    OrientInterpolation,
    OrientAngles,
    OrientSystem,
    Spinning,
    CompKind,
    CompOrientation,
    DataInput,
};
inline constexpr std::size_t kGroups = 28;

/// What is so of a function whatever is programmed: the columns of the table.
enum class Fact : std::uint8_t {
#define KADR_FACT(name, meaning) name,
#include "nc/facts.def"
#undef KADR_FACT
};

/// Some facts: `Fact::Straight | Fact::Cut`.
class Facts {
  public:
    constexpr Facts() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): one fact is some facts
    constexpr Facts(Fact fact) : bits_(std::uint64_t{1} << static_cast<unsigned>(fact)) {}
    constexpr bool has(Fact fact) const { return (bits_ >> static_cast<unsigned>(fact) & 1u) != 0; }
    constexpr Facts with(Facts other) const {
        Facts both;
        both.bits_ = bits_ | other.bits_;
        return both;
    }

  private:
    std::uint64_t bits_ = 0;
};
constexpr Facts operator|(Fact a, Fact b) { return Facts(a).with(b); }
constexpr Facts operator|(Facts a, Fact b) { return a.with(b); }

inline constexpr std::array<Facts, kFunctions> kFacts = [] {
    using enum Fact;
    constexpr Facts Plain;  // NOLINT(readability-identifier-naming): a word of the table
    return std::array<Facts, kFunctions>{{
#define KADR_FUNCTION(id, name, group, facts, parameters, meaning) facts,
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
    }};
}();

constexpr bool has_fact(Function function, Fact fact) {
    return kFacts[static_cast<std::size_t>(function)].has(fact);
}
/// Whether no statement of a source calls it as a command: `corner_round(5mm);`.
constexpr bool is_no_command(Function function) {
    return has_fact(function, Fact::ReadOnly) || has_fact(function, Fact::Resolved);
}

inline constexpr std::array<Group, kFunctions> kGroupOf = {{
#define KADR_FUNCTION(id, name, group, facts, parameters, meaning) Group::group,
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
}};

constexpr Group group_of(Function function) { return kGroupOf[static_cast<std::size_t>(function)]; }

/// The spindle's function by the number of its M word: 3, 4; else it stands.
constexpr Function spindle_of_code(double code) {
    constexpr double kCw = 3;
    constexpr double kCcw = 4;
    if (code == kCw) return Function::SpindleCw;
    return code == kCcw ? Function::SpindleCcw : Function::SpindleStop;
}
/// … and its number: 5 where it stands.
constexpr int code_of_spindle(Function spindle) {
    if (spindle == Function::SpindleCw) return 3;
    return spindle == Function::SpindleCcw ? 4 : 5;
}

/// What the table has of the parameters of each function: `offset?:count to:length`.
inline constexpr std::array<std::string_view, kFunctions> kParameterTexts = {{
#define KADR_FUNCTION(id, name, group, facts, parameters, meaning) parameters,
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
}};

/// Which parameter of a function has this name: `parameter_of<Function::ProbeCheck>("to")`. A name
/// that the table does not have does not compile.
template <Function function>
consteval std::size_t parameter_of(std::string_view name) {
    std::string_view rest = kParameterTexts[static_cast<std::size_t>(function)];
    for (std::size_t i = 0; !rest.empty(); ++i) {
        std::string_view own = rest.substr(0, rest.find(' '));
        rest.remove_prefix(own.size() < rest.size() ? own.size() + 1 : own.size());
        own = own.substr(0, own.find(':'));
        if (own.substr(0, own.find('?')) == name) return i;
    }
    throw "this function has no parameter of this name";  // only ever seen by the compiler
}

/// Name and meaning of a fact, for documentation and tests.
struct FactInfo {
    std::string_view name;
    std::string_view meaning;
};
/// In the order of Fact.
std::span<const FactInfo> all_facts();

/// What a number in a block measures; decides unit, number format and conversion.
enum class Dimension : std::uint8_t {
    Number,
    Count,
    Length,
    Angle,
    Time,
    Feed,
    Speed,
    Factor,
    Text,
};

struct Parameter {
    std::string_view name;
    Dimension dimension = Dimension::Number;
    bool is_optional = false;
};

struct FunctionInfo {
    Function function;
    std::string_view name;
    Group group;
    std::span<const Parameter> parameters;
    std::string_view meaning;
};

const FunctionInfo& info(Function function);
std::span<const FunctionInfo> all_functions();
/// By the name that XML and the language use: "rapid", "plane_xy".
/// A bit each.
using FunctionSet = std::bitset<kFunctions>;

std::optional<Function> find_function(std::string_view name);
std::string_view group_name(Group group);
std::optional<Group> find_group(std::string_view name);
std::string_view dimension_name(Dimension dimension);
std::optional<Dimension> find_dimension(std::string_view name);

constexpr bool is_tapping(Function f) { return has_fact(f, Fact::Tapping); }
constexpr bool is_arc(Function f) { return has_fact(f, Fact::Arc); }

}  // namespace kadr::nc
