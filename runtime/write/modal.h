// modal.h — what a text has written so far, and what its program means: what the writer remembers
// between blocks.
//
// Values alone; who changes them is text_state.h, and what follows from them text_view.h.
#pragma once

#include <array>
#include <vector>

#include "write/names.h"

namespace kadr::write {

/// mm or deg; far below any increment, above rounding noise.
inline constexpr double kSame = 1e-9;

inline constexpr std::size_t kX = 0;

constexpr Slot center_slot(std::size_t axis) {
    return static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + axis);
}

constexpr std::size_t index_of(Group group) { return static_cast<std::size_t>(group); }

/// Position of the axes, twice: as the program means it, and as the rounded words of the text add
/// up to it, so that incremental words cannot drift. mm and degrees.
struct WrittenPosition {
    std::array<double, kAxes> meant{};
    std::array<double, kAxes> text{};
    SlotMask known = 0;     // the axes whose coordinates are known, not only their changes
    SlotMask written = 0;   // … and of these the ones that no word of the text has named yet
    SlotMask reframed = 0;  // axes that no word has named since the frame changed …
    // … and the coordinates that words named last, in the frame before: meant, and in the text.
    std::array<std::array<double, 2>, kAxes> named{};

    /// A word of the text names the axis.
    void name(SlotMask axis) {
        written &= ~axis;
        reframed &= ~axis;
    }
    void forget() { known = written = reframed = 0; }
    /// Keeps what is so in both.
    void join(const WrittenPosition& other);
};

/// Whether something additive (a rotation, a mirroring) acts.
enum class Activity : std::uint8_t { No, Yes, Unknown };

/// A number that stays in force and need not be repeated.
struct NumberInForce {
    bool is_known = false;
    double value = 0;
};

/// A set of modal groups, a bit each.
using GroupMask = std::uint32_t;
constexpr GroupMask bit(Group group) { return GroupMask{1} << index_of(group); }

/// Groups that are written again where nobody knows whether the operator has left out the block
/// that programs one of them. The spindle and the coolant are his choice; the motion, the
/// dimensions and the feed mode are written wherever the text does not have them; the others cannot
/// stand in such a block.
inline constexpr GroupMask kRestated =
    bit(Group::Plane) | bit(Group::RadiusComp) | bit(Group::PathMode) | bit(Group::CompStart) |
    bit(Group::CompCorner) | bit(Group::CompCheck) | bit(Group::Compressor) |
    bit(Group::OrientInterpolation) | bit(Group::OrientAngles) | bit(Group::OrientSystem) |
    bit(Group::Spinning) | bit(Group::CompKind) | bit(Group::CompOrientation);

/// Additional turns of a helix, as the interpreter takes them.
inline constexpr double kMostTurns = 999;

/// How much the angle of a frame in the text misses the one that is meant, at most.
struct TurnMiss {
    double miss = 0;  // rad
    std::array<double, 3> center{};
    SourceId source;  // the statement that programs it
};

/// The programmable frame as the text has it.
struct TextFrame {
    Activity rotation = Activity::No;
    Activity mirror = Activity::No;
    Activity scale = Activity::No;
    Activity tilted = Activity::No;  // whether the working plane is
    bool is_refused = false;  // a change of it has its message, and what follows meets another one
    TurnMiss turn;            // of the rotation
    TurnMiss tilt;            // of the tilted plane
    std::array<double, 3> factors = {1, 1, 1};  // of the scale, X Y Z
    SlotMask turned = 0;                        // axes on which a rotation or mirroring acts
    std::array<NumberInForce, 3> shift{};       // arguments of a function that remembers them
    std::array<NumberInForce, 3> origin{};      // programmable shift as the program means it, mm

    /// Whether anything acts, or may, that a shift does not bring back.
    bool is_more_than_shift() const {
        return rotation != Activity::No || mirror != Activity::No || scale != Activity::No ||
               tilted != Activity::No;
    }
    void join(const TextFrame& other);
    void forget();
};

/// The cutting edge, and with it the tool's length.
struct TextEdge {
    NumberInForce number;        // of the one that the text has selected
    bool is_lost = false;        // one acted, and nobody knows which one does now
    bool is_length_due = false;  // it acts again; its axis has not moved since
    double waiting = 0;          // the one that a block without tool length has put aside; 0: none
    bool is_end_due = false;     // the length ends with the next move of its axis
    double length = 0;           // number of the offset that the program has as length; 0: none
};

/// What is so of the letter F beside its number.
struct FeedWord {
    bool every_block = false;    // not modal in this feed mode
    bool arc_by_radius = false;  // of arcs it is feed/radius in this feed mode
    bool is_pitch = false;       // of the block that is being written it is the pitch of a thread
};

/// Words that a tool change holds back until their axis moves or their function comes.
struct Pending {
    const Deferred* deferred = nullptr;
    double tool = 0;  // and number of its offsets, until the program names another
};

struct WriterModal {
    ModalFunctions meant{};  // as the blocks have them; None: not known
    ModalFunctions text{};   // as the control has it
    GroupMask doubtful = 0;  // of kRestated, where a block that may be left out programs otherwise
    TextUnits units;
    NumberInForce feed;  // in the text's units
    NumberInForce speed;
    double meant_feed = 0;  // of the blocks; holds if has_meant_feed
    bool has_meant_feed = false;
    bool feed_is_other = false;  // F in the text is not meant_feed: a pitch, a helix by its arc
    double meant_speed = 0;      // holds if has_meant_speed
    bool has_meant_speed = false;
    bool has_cutting_speed = false;  // the text has it, or had it before the section
    NumberInForce tool;              // the last one that was called
    NumberInForce work_offset;
    TextEdge edge;
    WrittenPosition position;
    TextFrame frame;

    Function text_of(Group group) const { return text[index_of(group)]; }
    Function meant_of(Group group) const { return meant[index_of(group)]; }

    /// Keeps what is so in both: behind a block that the operator may leave out.
    void join(const WriterModal& other);
    /// After raw text nothing is known.
    void forget();
};

}  // namespace kadr::write
