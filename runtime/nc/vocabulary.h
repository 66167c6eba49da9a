// vocabulary.h — the closed vocabulary of NC functions and its modal groups.
//
// The table is vocabulary.def; enum, names, parameters and documentation are made from it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kadr::nc {

enum class Function : std::uint16_t {
#define KADR_FUNCTION(id, name, group, parameters, meaning) id,
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
};

inline constexpr std::size_t kFunctions = 0
#define KADR_FUNCTION(id, name, group, parameters, meaning) +1
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
    ;

/// Modal groups of the neutral vocabulary; a dialect maps its own groups onto them.
enum class Group : std::uint8_t {
    Once,
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
    Turning,
    OrientAngles,
    OrientSystem,
    Spinning,
    CompSystem,
    CompTurning,
    DataInput,
};
inline constexpr std::size_t kGroups = 28;

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
std::optional<Function> find_function(std::string_view name);
std::string_view group_name(Group group);
std::optional<Group> find_group(std::string_view name);
std::string_view dimension_name(Dimension dimension);
std::optional<Dimension> find_dimension(std::string_view name);

constexpr bool is_tapping(Function f) { return f == Function::TapIn || f == Function::TapOut; }
/// Threads whose pitch changes along them.
constexpr bool is_varying_thread(Function f) {
    return f == Function::ThreadIncreasing || f == Function::ThreadDecreasing;
}
/// Motions whose centre word is a pitch.
constexpr bool takes_pitch(Function f) {
    return is_tapping(f) || f == Function::Thread || is_varying_thread(f);
}
constexpr bool is_arc_thread(Function f) {
    return f == Function::ThreadArcCw || f == Function::ThreadArcCcw;
}
constexpr bool is_arc(Function f) { return f == Function::ArcCw || f == Function::ArcCcw; }
/// Functions that are read and executed, and neither written nor said in a source.
constexpr bool is_read_only(Function f) { return f >= Function::ArcThrough; }

}  // namespace kadr::nc
