// writer_state.h — what the writer remembers between blocks.
#pragma once

#include <array>
#include <vector>

#include "nc/match.h"
#include "nc/number_text.h"

namespace kadr::nc {

/// Position of the axes, twice: as the program means it, and as the rounded words of the text add
/// up to it, so that incremental words cannot drift. mm and degrees.
struct WrittenPosition {
    std::array<double, kAxes> meant{};
    std::array<double, kAxes> text{};
    SlotMask known = 0;  // the axes whose coordinates are known, not only their changes

    void forget() { known = 0; }
};

/// Whether something additive (a rotation, a mirroring) acts.
enum class Activity : std::uint8_t { No, Yes, Unknown };

/// A number that stays in force and need not be repeated.
struct Standing {
    bool is_known = false;
    double value = 0;
};

/// Additional turns of a helix, as the interpreter takes them.
inline constexpr double kMostTurns = 999;

struct WriterModal {
    ModalFunctions meant{};  // as the blocks say; None: not known
    ModalFunctions text{};   // as the control has it
    TextUnits units;
    Standing feed;  // in the text's units
    Standing speed;
    double meant_feed = 0;  // of the blocks; holds if has_meant_feed
    bool has_meant_feed = false;
    double meant_speed = 0;  // holds if has_meant_speed
    bool has_meant_speed = false;
    Standing tool;            // the last one that was called
    Standing edge;            // the cutting edge that the text has selected
    double waiting_edge = 0;  // the one that a block without tool length has put aside; 0: none
    WrittenPosition position;
    Activity rotation = Activity::No;
    Activity mirror = Activity::No;
    Activity scale = Activity::No;
    SlotMask turned = 0;               // axes on which a rotation or mirroring acts
    std::array<Standing, 3> shift{};   // arguments of a function that remembers them
    std::array<Standing, 3> origin{};  // programmable shift as the program means it, mm

    Function& text_of(Group group) { return text[static_cast<std::size_t>(group)]; }
    Function& meant_of(Group group) { return meant[static_cast<std::size_t>(group)]; }

    /// After a block that may be skipped, only what it left as it was is known.
    void forget_differences(const WriterModal& before) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] != before.text[i]) text[i] = Function::None;
        }
        const auto forget_number = [](Standing& now, const Standing& then) {
            now.is_known &= then.is_known && now.value == then.value;
        };
        forget_number(feed, before.feed);
        forget_number(speed, before.speed);
        for (std::size_t i = 0; i < shift.size(); ++i) {
            forget_number(shift[i], before.shift[i]);
            forget_number(origin[i], before.origin[i]);
        }
        turned |= before.turned;
        position.known &= before.position.known;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (position.text[axis] != before.position.text[axis])
                position.known &= ~(SlotMask{1} << axis);
        }
        if (rotation != before.rotation) rotation = Activity::Unknown;
        if (mirror != before.mirror) mirror = Activity::Unknown;
    }

    /// After raw text nothing is known.
    void forget() {
        meant.fill(Function::None);
        text.fill(Function::None);
        feed.is_known = speed.is_known = has_meant_feed = has_meant_speed = false;
        tool.is_known = edge.is_known = false;
        waiting_edge = 0;
        position.forget();
        rotation = mirror = scale = Activity::Unknown;
        turned = kTargetSlots;
        for (Standing& s : shift) s.is_known = false;
        for (Standing& s : origin) s.is_known = false;
    }
};

}  // namespace kadr::nc
