// code.h — a checked program, ready to be evaluated.
//
// Instructions over typed registers of eight bytes: names are resolved, dimensions gone, every
// unit converted. A function's registers are its parameters, its variables and intermediate
// values; texts and arrays are handles. Nothing here is looked up by name while it runs.
// `print` shows it, one instruction a line.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "nc/block.h"
#include "nc/dialect.h"
#include "nc/rules.h"
#include "sema/code_names.h"
#include "sema/quantity.h"
#include "sema/slot.h"
#include "sema/test_code.h"

namespace kadr::sema {

enum class OpCode : std::uint16_t {
#define KADR_OP(name, operands) name,
#include "sema/opcodes.def"
#undef KADR_OP
};

/// Registers of one function at most; calls and points need some room above a function's own.
inline constexpr std::uint32_t kMostRegisters = 60000;
/// Of the variables of all files together.
inline constexpr std::uint32_t kMostGlobals = 1'000'000;
/// Functions of all files together: an instruction names one by a number of 16 bits, 0 sets the
/// globals.
inline constexpr std::uint32_t kMostFunctions = 65'000;

struct Instruction {
    struct Pair {
        std::int32_t first;  // a jump target, a table index
        std::int32_t second;
    };
    OpCode op = OpCode::Finish;
    std::uint16_t a = 0;
    std::uint16_t b = 0;
    std::uint16_t c = 0;
    union {
        std::int64_t integer = 0;
        double number;
        Pair pair;
    } immediate;
};
static_assert(sizeof(Instruction) == 16);

enum class Rounding : std::uint8_t { Trunc, Floor, Ceil, Round };

enum class Math : std::uint8_t {
    Abs,
    Sign,
    TanDeg,
    AsinDeg,
    AcosDeg,
    AtanDeg,
    Exp,
    Ln,
    Log10,
    Cbrt,  // of one number
    Pow,
    Atan2Deg,
    Hypot,
    Min,
    Max,  // of two
};

/// What `state.…` reads.
enum class StateValue : std::uint8_t {
    Feed,
    Speed,
    Tool,
    Spindle,
    Mirrored,
    Turned,
    Scaled,
    Diameter
};

/// Registers of a contour's element, in the order of its members.
enum class ElementSlot : std::uint8_t {
    From,        // three; the coordinate across the plane is not given
    To = 3,      // three
    Center = 6,  // three, of an arc
    Radius = 9,  // of an arc
    Sweep = 10,  // degrees, counter-clockwise positive; 0 of a line
    Length = 11,
    IsArc = 12,
    IsDiameter = 13,  // X of the points is a diameter
};
inline constexpr std::uint32_t kElementSlots = 14;

/// What can be asked of a contour and made of it. Arguments stand in the registers from b, the
/// contour first; the layout is that of the result's elements.
enum class ContourFunction : std::uint8_t {
    Length,
    Area,
    IsClosed,
    IsClockwise,
    IsDiameter,
    Start,
    End,
    Min,
    Max,
    Reverse,
    Offset,         // distance
    Shift,          // x, y, z
    Rotate,         // angle, about
    Mirror,         // x, y, z: truth values
    IsInside,       // point
    Nearest,        // point
    Intersections,  // another contour
    Crossings,      // x, y, z: one of them is given
    OffsetAll,      // distance; an array of contours is in the place of the contour
    BegunNear,      // point
};

/// Arguments of `follow` in their registers.
enum class FollowSlot : std::uint8_t {
    Contour,
    Feed,  // as a feed, second form included; may be not given, as all that follow
    Left,
    Right,
    LeadIn,
    LeadOut,
    ArcIn,
    ArcOut,
};
inline constexpr std::uint32_t kFollowSlots = 8;

/// How far a curve may be from the blocks that follow it if nothing is given, mm: half of what a
/// finishing cut is usually allowed.
inline constexpr double kCurveTolerance = 0.005;

/// Arguments of `follow` of a curve; behind them those of the curve itself, its parameter last.
enum class CurveSlot : std::uint8_t {
    Feed,       // as in FollowSlot
    Tolerance,  // mm
    Arcs,       // truth value: arcs where they are possible
    Nurbs,      // truth value: one spline, if the control has them
    From,
    To,  // of the parameter
    Arguments,
};

/// What a `with` adds to the frame; its values stand in the order of the vocabulary's parameters.
enum class WithFrame : std::uint8_t { Shift, Rotate, Scale, Mirror };

/// Which modal state a `with` or `preserves` concerns: bit i is nc::Group i, then:
using ModalMask = std::uint32_t;
inline constexpr ModalMask kFrameBit = 1u << nc::kGroups;
inline constexpr ModalMask kFeedBit = kFrameBit << 1;
inline constexpr ModalMask kSpeedBit = kFrameBit << 2;
static_assert(kSpeedBit != 0, "a group for which the mask has no bit");
constexpr ModalMask group_bit(nc::Group group) { return 1u << static_cast<unsigned>(group); }

/// One value of a block that is known only when the program runs, in the order of the registers.
struct Filling {
    enum class Form : std::uint8_t {
        Plain,     // in the unit of the block
        Diameter,  // of X: halved where X is a radius
        Count,     // a whole number in an integer register
        Text,
        FeedBare,      // F200: in the unit of the feed mode, lengths in the file's unit
        Feed,          // mm/s, or mm/rev in the second form
        FeedPerTime,   // mm/s
        FeedPerTurn,   // mm/rev
        FeedInverse,   // 1/s
        SpeedBare,     // S2400
        Speed,         // rev/s, or mm/s in the second form
        SpeedPerTime,  // rev/s
        SpeedCutting,  // mm/s
    };
    Form form = Form::Plain;
    bool is_argument = false;  // `index`: index into Block::arguments; else a Slot
    std::uint8_t index = 0;
    std::uint8_t invocation = 0;
    std::uint8_t parameter = 0;
    double factor = 1;  // FeedBare: mm per length unit of the file

    friend bool operator==(const Filling&, const Filling&) = default;
};

/// What the control of the input dialect does with a block where controls differ. The evaluator
/// gives it so that every target does the same.
namespace custom {
inline constexpr std::uint32_t kShiftKeeps = 1;      // a shift keeps the axes that it does not name
inline constexpr std::uint32_t kRotateReplaces = 2;  // a rotation replaces the one before
inline constexpr std::uint32_t kMachineRapid = 4;    // machine coordinates are reached at rapid
inline constexpr std::uint32_t kMachineLength = 8;   // … with the tool length
inline constexpr std::uint32_t kOffsetsByTool = 16;  // `D3`, `H3` are offsets of tool 3
inline constexpr std::uint32_t kEdges = 32;          // `D1` is an edge; M6 activates the length
inline constexpr std::uint32_t kFeedCounts = 64;     // F has no point: increments per revolution
inline constexpr std::uint32_t kCycleWords = 128;    // G80, G98, G99: only beside its own cycles
inline constexpr std::uint32_t kFrameOrder = 256;    // mirror, scale, rotation in this order only
inline constexpr std::uint32_t kReference = 512;     // G28 goes over the programmed position
inline constexpr std::uint32_t kCenterAtTool = 1024;  // a centre not named is where the tool stands
inline constexpr std::uint32_t kFeedDeleted = 2048;   // another kind of feed deletes F
// An increment counts from the coordinate that was programmed last, and so travels a change of the
// frame as well.
inline constexpr std::uint32_t kIncrementTravels = 4096;
inline constexpr std::uint32_t kLengthMoves = 8192;     // a tool length is travelled at once
inline constexpr std::uint32_t kCyclePosition = 16384;  // its cycle begins at its position
inline constexpr std::uint32_t kPlaces = 32768;         // while a cycle is modal, a position of it
inline constexpr std::uint32_t kCoreOffsets = 65536;    // `G43 H1` and `D1` of the common core
inline constexpr std::uint32_t kRepeats = 131072;       // `K5`: the cycle that is modal, so often
inline constexpr std::uint32_t kFrameDiameter =
    262144;                                            // X of a frame is a diameter where X is one
inline constexpr std::uint32_t kFeedOfArc = 524288;    // F of a helix is meant along its arc
inline constexpr std::uint32_t kStation = 1048576;     // `T0102` selects an offset as well
inline constexpr std::uint32_t kDirection = 2097152;   // the direction of the tool is programmed
inline constexpr std::uint32_t kFeedOfAxes = 4194304;  // F is meant over rotary axes, too
inline constexpr std::uint32_t kMirrorReplaces = 16777216;  // a further mirror goes on mirroring
inline constexpr std::uint32_t kFrameOfSource = 8388608;    // a frame in the words of its control
inline constexpr std::uint32_t kDrawn = 33554432;  // corners, angles, poles, polar coordinates
}  // namespace custom

/// A block without its values: what the words mean before the program runs.
struct Plan {
    nc::Function motion = nc::Function::None;
    nc::SlotMask given = 0;
    nc::SlotMask incremental = 0;
    nc::SlotMask absolute = 0;
    std::uint8_t argument_count = 0;
    std::int8_t skip_level = -1;  // level of a block that may be left out;
                                  // syntax::kDefaultSkipLevel: the target's own default
    nc::CycleId cycle = 0;
    std::int32_t number = -1;
    std::uint32_t customs = 0;              // bits of `custom`
    nc::PlaneMask planes = nc::kAllPlanes;  // in which the words of the source mean this
    std::vector<nc::Invocation> functions;
    std::vector<std::pair<std::uint8_t, double>> arguments;  // fixed by the dialect's words
    std::vector<std::pair<std::uint8_t, double>> values;     // likewise
    std::vector<Filling> fillings;
};

/// A cycle of the input dialect's control as a block of a source, and which arguments of the
/// library's cycle it gives.
struct SourceCycle {
    enum class Kind : std::uint8_t {
        Once,    // `CYCLE81(…)`
        Modal,   // `G81 …`: at every position, each block a positioning at rapid, until G80 or a
                 // motion
        Called,  // `MCALL CYCLE81(…)`: behind every motion, until `MCALL`
    };
    struct Argument {
        std::uint8_t parameter = 0;
        bool is_count = false;  // a whole number in its register
    };
    Kind kind = Kind::Once;
    std::uint32_t function = 0;         // of the library, index into Code::functions
    nc::Rules rules;                    // of the control of its file
    bool has_other_in_strokes = false;  // beside a stroke its code is another cycle
    std::string word;                   // `G83`, `CYCLE81`
    std::vector<Argument> arguments;    // of the registers, in their order; not given: NaN
    std::vector<std::pair<std::uint8_t, double>> fixed;  // parameters that the word itself has
};

/// A text with holes: `"{x:.3} mm"`.
struct FormatPiece {
    enum class Kind : std::uint8_t { Literal, Integer, Number, Feed, Speed, Text, Bool, Enum };
    struct Scale {
        double factor = 1;        // a number is multiplied by it: mm → the file's units
        std::string unit;         // stands behind the value; empty: none
        std::string second_unit;  // … of a Feed or Speed of the second form
    };
    Kind kind = Kind::Literal;
    std::string text;  // of a Literal
    Scale scale;
    Scale inch_scale;            // … of the library in a program in inches
    bool serves_inches = false;  // it has that
    std::int16_t decimals = -1;
    std::int16_t width = 0;
    bool zeros = false;  // filled with zeros instead of blanks
    bool plus = false;
    std::uint32_t enumeration = 0;
};
using FormatPattern = std::vector<FormatPiece>;

/// How the prompt shows a value of any type: a plain one by its piece, others by their parts.
struct ShownForm {
    enum class Kind : std::uint8_t { Plain, Members, List, Contour };
    struct Part {
        std::string name;        // of a member
        std::uint16_t slot = 0;  // its first register, from the first of the whole
        std::uint32_t form = 0;
    };
    Kind kind = Kind::Plain;
    SlotKind slot = SlotKind::Number;  // of its first register
    std::string type;                  // as a person writes it
    FormatPiece piece;                 // of a Plain one
    std::vector<Part> parts;           // of a List its element
};

/// What each register of an array's element holds; `nested` the layout of a register that is an
/// array itself.
struct ElementLayout {
    std::vector<SlotKind> slots;
    std::vector<std::uint32_t> nested;
    friend bool operator==(const ElementLayout&, const ElementLayout&) = default;
};

/// One column that a CSV file must have.
struct TableColumn {
    enum class Kind : std::uint8_t { Bool, Integer, Number, Feed, Speed, Text, Enum };
    std::string name;  // "d", "at.x"
    Kind kind = Kind::Number;
    Quantity quantity;
    bool is_optional = false;  // an empty cell is "not given"; the column may be missing
    std::uint32_t enumeration = 0;
    std::uint16_t slot = 0;
    std::optional<Slot> initial;  // without a column: the member's default; of a text nothing …
    std::string initial_text;     // … but this
};
struct TableSchema {
    std::string type_name;
    std::vector<TableColumn> columns;
    std::uint32_t layout = 0;
    std::uint16_t slots = 0;
    std::string folder;  // of the file that names the table
    Units units = Units::Metric;
};
/// Rows of a CSV file; texts are indices into `texts`.
struct TableRows {
    std::vector<Slot> slots;
    std::vector<std::string> texts;
};
struct LoadedTable {
    std::uint32_t schema = 0;
    TableRows rows;
};

/// Grey values from a file, row by row from the top down: 0 black to 1 white.
struct Picture {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<double> brightness;  // row by row, shape (height, width)
};
/// A call of `image`, and where the members of its struct stand.
struct PictureSource {
    std::string folder;        // of the file that names it
    std::uint32_t layout = 0;  // of the array `dots`
    std::uint16_t width = 0;   // registers behind the first one of the struct
    std::uint16_t height = 0;
    std::uint16_t dots = 0;
    Picture picture;  // if it was read when the program was checked
};

struct EnumNames {
    std::string name;
    std::vector<std::pair<std::string, std::int64_t>> members;
};

/// A parameter as the outside needs it: -D on the command line, a cycle called by the interpreter.
struct ParameterInfo {
    std::string name;
    std::string type_name;
    enum class Kind : std::uint8_t {
        Bool,
        Integer,
        Number,
        Feed,
        Speed,
        Text,
        Enum,
        Contour,
        Other
    };
    Kind kind = Kind::Other;
    Quantity quantity;
    bool is_optional = false;
    bool has_default = false;
    std::uint16_t slot = 0;  // its first register
    std::uint16_t slots = 1;
    std::uint32_t enumeration = 0;  // index into Code::enums
    std::uint32_t layout = 0;       // of the elements of a Contour
    SourceRange range;
};

enum class FunctionKind : std::uint8_t { Plain, Cycle, Program, Startup, Test, Property };

struct FunctionCode {
    std::string name;
    FunctionKind kind = FunctionKind::Plain;
    std::uint32_t entry = 0;  // evaluates the defaults of what was not given
    std::uint32_t body = 0;   // everything was given
    std::uint32_t end = 0;
    std::uint32_t registers = 0;
    std::uint16_t result_slots = 0;
    std::vector<ParameterInfo> parameters;
    std::vector<PropertyRange> ranges;  // of the parameters of a property
    /// Members of modal groups that `preserves` names: they must be active when the call begins.
    std::vector<nc::Function> needs;
    Units units = Units::Metric;
    nc::Function motion = nc::Function::Rapid;  // that is modal where a program begins
    int work_offset = 0;                        // that acts there; 0: what the target has
    bool has_diameters = false;  // X is a diameter there: it, or what it calls, turns
    SourceRange range;           // of the name
    bool is_main_file = false;   // a program of the file that was asked for
};

struct Code {
    std::vector<Instruction> instructions;
    std::vector<SourceRange> locations;   // of the instructions, for messages
    std::vector<FunctionCode> functions;  // 0 sets the globals
    std::uint32_t globals = 0;            // registers of file-level variables
    std::vector<std::string> texts;
    std::vector<FormatPattern> formats;
    std::vector<ShownForm> shown_forms;
    std::vector<ElementLayout> layouts;
    std::vector<Plan> plans;
    std::vector<SourceCycle> cycles;
    std::vector<SourceRange> statements;  // by SourceId
    std::vector<TableSchema> schemas;
    std::vector<LoadedTable> tables;
    std::vector<PictureSource> pictures;
    std::vector<EnumNames> enums;
    std::vector<TestCall> test_calls;
    FileId main_file;                // the file that was asked for
    std::string true_word = "true";  // in its keyword language
    std::string false_word = "false";
    CodeNames names;  // empty unless the check was asked for them
};

/// The instructions of one function or of all, one a line, for tests and for the curious.
std::string print(const Code& code);
std::string print(const Code& code, const FunctionCode& function);
/// Variables with their registers and where they live, and where statements begin, one a line.
std::string print_names(const Code& code, const Sources& sources);

}  // namespace kadr::sema
