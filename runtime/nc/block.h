// block.h — one NC block by its meaning.
//
// No letters, no spelling: those exist only in the writer and the reader. Lengths are mm and angles
// degrees whatever units the text uses. A Block never touches the heap unless it carries text; it
// is reset and filled again, so masks and counts tell which fields hold.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/axes.h"
#include "base/source.h"
#include "nc/vocabulary.h"

namespace kadr::nc {

inline constexpr std::size_t kMaxInvocations = 16;
inline constexpr std::size_t kMaxArguments = 40;

/// Scalar fields of a Block that a word can set.
enum class Slot : std::uint8_t {
    X,
    Y,
    Z,
    A,
    B,
    C,
    U,
    V,
    W,  // targets, in the order of Axis
    CenterX,
    CenterY,
    CenterZ,  // arc centre
    Radius,
    Turns,  // arc radius (negative: more than half a turn), additional full turns
    Feed,
    Speed,
    // Read, and never written: polar coordinates, the opening angle of an arc, a point on it.
    PolarAngle,
    PolarRadius,
    Opening,
    ThroughX,
    ThroughY,
    ThroughZ,
};
inline constexpr std::size_t kSlots = 22;
using SlotMask = std::uint32_t;
constexpr SlotMask bit(Slot slot) { return SlotMask{1} << static_cast<unsigned>(slot); }
/// As `describe` shows it: "X", "I", "TURN".
std::string_view slot_name(Slot slot);
constexpr Slot slot_of(Axis axis) { return static_cast<Slot>(index(axis)); }
inline constexpr SlotMask kTargetSlots = (SlotMask{1} << kAxes) - 1;
inline constexpr SlotMask kCenterSlots =
    bit(Slot::CenterX) | bit(Slot::CenterY) | bit(Slot::CenterZ);
inline constexpr SlotMask kArcSlots = kCenterSlots | bit(Slot::Radius) | bit(Slot::Turns);
inline constexpr SlotMask kPolarSlots = bit(Slot::PolarAngle) | bit(Slot::PolarRadius);
inline constexpr SlotMask kThroughSlots =
    bit(Slot::ThroughX) | bit(Slot::ThroughY) | bit(Slot::ThroughZ);
inline constexpr SlotMask kReadSlots = kPolarSlots | kThroughSlots | bit(Slot::Opening);
/// Slots whose words may be absolute or incremental by themselves.
inline constexpr SlotMask kModeSlots =
    kTargetSlots | kCenterSlots | kThroughSlots | bit(Slot::PolarAngle);

/// Whether a word for X has a dimension of its own.
enum class XMeasure : std::uint8_t { Modal, Diameter, Radius };
/// How a rotary axis approaches its target.
enum class RotaryApproach : std::uint8_t { AsProgrammed, Shortest, Positive, Negative };

/// A function of the vocabulary as it stands in a block, with its parameters.
struct Invocation {
    Function function = Function::None;
    std::uint8_t first =
        0;  // of its parameters in Block::arguments, in the order of the vocabulary
    std::uint32_t given = 0;  // bit i: parameter i was given

    bool has(std::size_t parameter) const { return (given >> parameter & 1u) != 0; }
};
static_assert(sizeof(Invocation) == 8, "batches of blocks are full of them");

/// Which cycle a block calls: index into the dialects' common list of cycles (Dialect::cycles).
using CycleId = std::uint16_t;

struct Block;

/// The cycle whose block one is: it travels with the block, through all copies of it.
struct BlockContext {
    const Block* caller = nullptr;  // the block of the text that called the cycle
    std::string_view cycle;         // its name
    std::uint16_t number = 0;       // its index in the dialect's list, from 1
    bool taps = false;
};

struct Block {
    enum class Kind : std::uint8_t {
        Nc,        // the normal case
        Comment,   // only a comment
        Raw,       // `text` is a line that goes through as it stands
        Label,     // `text` is a jump target
        Modal,     // nothing is written; informs the writer that the modal state below is unknown
        Position,  // nothing is written; informs the writer where the targets that are given stand
    };

    Kind kind = Kind::Nc;
    XMeasure x_measure = XMeasure::Modal;
    Function motion = Function::None;  // None: the modal motion continues
    SlotMask given = 0;                // which of `values` hold
    SlotMask incremental = 0;  // of the given targets and centres: incremental by themselves
    SlotMask absolute = 0;     // … absolute by themselves; neither: as the modal state is
    std::uint8_t function_count = 0;
    std::uint8_t argument_count = 0;
    std::int8_t skip_level = -1;            // optional skip level 0…9; -1 none
    bool feed_along_arc : 1 = false;        // F of a helix is meant along its arc, not its path
    bool feed_of_all_axes : 1 = false;      // F of a straight block is meant over rotary axes, too
    bool has_inch_feed : 1 = false;         // of what was read: F is in inches
    bool length_waits : 1 = false;          // a tool length is travelled with the axis' next move
    std::uint16_t further_skip_levels = 0;  // bit n: the block is left out at level n as well
    std::uint8_t rotary_approaches = 0;     // of A, B, C: two bits each, a RotaryApproach
    CycleId cycle = 0;                      // holds if Function::Cycle is among the functions
    // Of its parameters, the first 16, bit i: no word gives it, the form of the cycle does.
    std::uint16_t cycle_by_form = 0;
    std::int32_t number = -1;           // N; -1 none
    std::uint32_t line = 0;             // line of the ISO-7bit text it came from or went to, from 1
    SourceId source;                    // statement of the Kadr program behind it
    std::array<double, kSlots> values;  // mm, deg; feed and speed in the unit of their modes
    std::array<Invocation, kMaxInvocations> functions;
    std::array<double, kMaxArguments> arguments;
    const BlockContext* context = nullptr;  // null: the block stands in the text itself
    std::string text;                       // of a message, a tool name, a raw line, a label
    std::string comment;                    // shown behind the block

    /// Empties the block; keeps the capacity of its strings.
    void reset() {
        kind = Kind::Nc;
        motion = Function::None;
        given = incremental = absolute = 0;
        function_count = argument_count = 0;
        skip_level = -1;
        further_skip_levels = 0;
        x_measure = XMeasure::Modal;
        feed_along_arc = feed_of_all_axes = has_inch_feed = length_waits = false;
        rotary_approaches = 0;
        cycle = 0;
        cycle_by_form = 0;
        number = -1;
        line = 0;
        source = {};
        context = nullptr;
        text.clear();
        comment.clear();
    }

    /// Whether a cycle gives it; then line and source are those of the call.
    bool is_of_cycle() const { return context != nullptr; }
    bool has(Slot slot) const { return (given & bit(slot)) != 0; }
    double at(Slot slot) const { return values[static_cast<std::size_t>(slot)]; }
    void set(Slot slot, double value) {
        values[static_cast<std::size_t>(slot)] = value;
        given |= bit(slot);
    }

    RotaryApproach rotary_approach(Axis axis) const {
        const auto shift = 2 * (index(axis) - index(Axis::A));
        return static_cast<RotaryApproach>(rotary_approaches >> shift & 3u);
    }
    void set_rotary_approach(Axis axis, RotaryApproach approach) {
        const auto shift = 2 * (index(axis) - index(Axis::A));
        rotary_approaches = static_cast<std::uint8_t>((rotary_approaches & ~(3u << shift)) |
                                                      static_cast<unsigned>(approach) << shift);
    }

    /// Adds a function without parameters given; false if the block is full.
    bool add(Function function);
    /// Adds a function and room for all its parameters (`parameter_count`), none given yet. For a
    /// cycle the count is the cycle's. Returns nullptr if the block is full.
    Invocation* add(Function function, std::size_t parameter_count);
    void set_argument(Invocation& invocation, std::size_t parameter, double value) {
        arguments[invocation.first + parameter] = value;
        invocation.given |= 1u << parameter;
    }
    const Invocation* find(Function function) const;
    /// The first function of which this is so.
    const Invocation* find(Fact fact) const;
    /// Argument of an invocation; `fallback` if it was not given.
    double argument(const Invocation& invocation, std::size_t parameter,
                    double fallback = 0) const {
        return invocation.has(parameter) ? arguments[invocation.first + parameter] : fallback;
    }
};
static_assert(sizeof(Block) <= 736, "blocks travel in batches of a thousand");

/// The function of the group that the block itself programs, the motion code among them; or None.
Function programmed_in(const Block& block, Group group);

/// Same meaning: what masks and counts do not name is not compared; nor are line and source.
bool operator==(const Block& a, const Block& b);

/// One line for messages and tests: `line X10 Y-2.5 F200 | spindle_cw | dwell(time=0.5)`.
std::string describe(const Block& block);

}  // namespace kadr::nc
