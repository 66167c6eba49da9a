// text_state.h — what the writer remembers between blocks.
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
    SlotMask told = 0;      // … and of these the ones that no word of the text has named yet
    SlotMask reframed = 0;  // axes that no word has named since the frame changed …
    // … and the coordinates that words named last, in the frame before: meant, and in the text.
    std::array<std::array<double, 2>, kAxes> named{};

    /// A word of the text names the axis.
    void name(SlotMask axis) {
        told &= ~axis;
        reframed &= ~axis;
    }
    void forget() { known = told = reframed = 0; }
};

/// Whether something additive (a rotation, a mirroring) acts.
enum class Activity : std::uint8_t { No, Yes, Unknown };

/// A number that stays in force and need not be repeated.
struct Standing {
    bool is_known = false;
    double value = 0;
};

/// A set of modal groups, a bit each.
using GroupMask = std::uint32_t;
constexpr GroupMask bit(Group group) { return GroupMask{1} << index_of(group); }

/// Groups that are said again where nobody knows whether the operator has left out the block that
/// says one of them. The spindle and the coolant are his choice; the motion, the dimensions and the
/// feed mode are said wherever the text does not have them; the others cannot stand in such a
/// block.
inline constexpr GroupMask kSaidAgain =
    bit(Group::Plane) | bit(Group::RadiusComp) | bit(Group::PathMode) | bit(Group::CompStart) |
    bit(Group::CompCorner) | bit(Group::CompCheck) | bit(Group::Compressor) | bit(Group::Turning) |
    bit(Group::OrientAngles) | bit(Group::OrientSystem) | bit(Group::Spinning) |
    bit(Group::CompSystem) | bit(Group::CompTurning);

/// Additional turns of a helix, as the interpreter takes them.
inline constexpr double kMostTurns = 999;

/// How much the angle of a frame in the text misses the one that is meant, at most.
struct TurnMiss {
    double miss = 0;  // rad
    std::array<double, 3> center{};
    SourceId source;  // the statement that says it
};

struct WriterModal {
    ModalFunctions meant{};  // as the blocks say; None: not known
    ModalFunctions text{};   // as the control has it
    GroupMask doubtful = 0;  // of kSaidAgain, where a block that may be left out says otherwise
    TextUnits units;
    Standing feed;  // in the text's units
    Standing speed;
    double meant_feed = 0;  // of the blocks; holds if has_meant_feed
    bool has_meant_feed = false;
    bool feed_is_other = false;  // F in the text is not meant_feed: a pitch, a helix by its arc
    double meant_speed = 0;      // holds if has_meant_speed
    bool has_meant_speed = false;
    Standing tool;               // the last one that was called
    Standing edge;               // the cutting edge that the text has selected
    bool is_edge_lost = false;   // one acted, and nobody knows which one does now
    bool is_length_due = false;  // it acts again; its axis has not moved since
    double waiting_edge = 0;     // the one that a block without tool length has put aside; 0: none
    WrittenPosition position;
    Activity rotation = Activity::No;
    Activity mirror = Activity::No;
    Activity scale = Activity::No;
    Activity tilted = Activity::No;             // whether the working plane is
    TurnMiss turn;                              // of the rotation
    TurnMiss tilt;                              // of the tilted plane
    std::array<double, 3> factors = {1, 1, 1};  // of the scale, X Y Z
    SlotMask turned = 0;                        // axes on which a rotation or mirroring acts
    std::array<Standing, 3> shift{};            // arguments of a function that remembers them
    std::array<Standing, 3> origin{};           // programmable shift as the program means it, mm

    Function& text_of(Group group) { return text[static_cast<std::size_t>(group)]; }
    Function text_of(Group group) const { return text[static_cast<std::size_t>(group)]; }
    Function& meant_of(Group group) { return meant[static_cast<std::size_t>(group)]; }

    /// Keeps what is so in both: behind a block that the operator may leave out.
    void join(const WriterModal& other) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == other.text[i]) continue;
            text[i] = Function::None;
            doubtful |= bit(static_cast<Group>(i)) & kSaidAgain;
        }
        doubtful |= other.doubtful;
        const auto keep = [](Standing& mine, const Standing& theirs) {
            mine.is_known = mine.is_known && theirs.is_known && mine.value == theirs.value;
        };
        keep(feed, other.feed);
        keep(speed, other.speed);
        feed_is_other |= other.feed_is_other;
        for (std::size_t i = 0; i < shift.size(); ++i) {
            keep(shift[i], other.shift[i]);
            keep(origin[i], other.origin[i]);
        }
        keep(tool, other.tool);
        keep(edge, other.edge);
        turned |= other.turned;
        if (rotation != other.rotation) rotation = Activity::Unknown;
        if (mirror != other.mirror) mirror = Activity::Unknown;
        if (scale != other.scale) scale = Activity::Unknown;
        if (tilted != other.tilted) tilted = Activity::Unknown;
        if (factors != other.factors) factors = {1, 1, 1};
        // `turn` and `tilt` are misses of the text's own words; edges and units stand in no block
        // that may be left out, and an edge that such a block puts aside is said again either way.
        position.told |= other.position.told;
        position.reframed |= other.position.reframed;
        position.known &= other.position.known;
        for (std::size_t i = 0; i < kAxes; ++i) {
            const bool is_same = position.text[i] == other.position.text[i] &&
                                 position.meant[i] == other.position.meant[i];
            if (!is_same) position.known &= static_cast<SlotMask>(~(SlotMask{1} << i));
        }
    }

    /// After raw text nothing is known.
    void forget() {
        meant.fill(Function::None);
        text.fill(Function::None);
        doubtful = 0;
        feed.is_known = speed.is_known = has_meant_feed = has_meant_speed = false;
        is_edge_lost = is_edge_lost || (edge.is_known && edge.value != 0);
        tool.is_known = edge.is_known = false;
        waiting_edge = 0;
        position.forget();
        rotation = mirror = scale = tilted = Activity::Unknown;
        factors = {1, 1, 1};
        turned = kTargetSlots;
        for (Standing& s : shift) s.is_known = false;
        for (Standing& s : origin) s.is_known = false;
    }
};

}  // namespace kadr::write
