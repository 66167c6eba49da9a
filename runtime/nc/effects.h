// effects.h — what the functions of a block do to the state of a control, as a short list.
//
// It is taught here once. Whoever follows a program folds the list into a state of its own, by a
// switch over the kinds without `default`: the interpreter (what happens), the expander (what an
// author may compute with), the writer (what its text has written) and the reader (what a line
// means). They know different things: behind a change of tool the interpreter's position stands,
// that of the expander is unknown, and the writer still knows X and Y.
//
// It stands in this room, below `control`, because the reader folds it, too.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "base/assert.h"
#include "nc/block.h"
#include "nc/rules.h"
#include "nc/vocabulary.h"

namespace kadr::nc {

enum class EffectKind : std::uint8_t {
#define KADR_EFFECT(kind, meaning) kind,
#include "nc/effects.def"
#undef KADR_EFFECT
};

/// "ShiftAdd".
std::string_view effect_name(EffectKind kind);

/// When it comes true.
enum class When : std::uint8_t {
    AtOnce,        // the words of the block are read so already
    ToolChange,    // with the tool that comes into the spindle, before the others …
    BeforeMotion,  // … when all functions of the block are known
    Behind,        // where the motion of the block has ended
};

struct Effect {
    EffectKind kind;
    When when;
    Function function;        // that has it; Sets: the new member
    std::uint8_t invocation;  // its index in the block; kMotionCode: it is the block's motion

    static constexpr std::uint8_t kMotionCode = 0xff;

    /// Of the motion code of a block.
    static constexpr Effect of_motion(Function motion) {
        return {EffectKind::Sets, When::AtOnce, motion, kMotionCode};
    }

    Group group() const { return group_of(function); }
    const Invocation& invocation_in(const Block& block) const {
        KADR_ASSERT(invocation != kMotionCode, "a motion code has no arguments");
        return block.functions[invocation];
    }
};

/// The effects of one block, function after function.
class Effects {
  public:
    /// A function has three effects at most.
    static constexpr std::size_t kMost = 1 + 3 * kMaxInvocations;

    const Effect* begin() const { return list_.data(); }
    const Effect* end() const { return list_.data() + count_; }
    /// Whether one of them comes true then.
    bool has(When when) const { return (times_ >> static_cast<unsigned>(when) & 1u) != 0; }

    void add(const Effect& effect) {
        KADR_ASSERT(count_ < kMost, "a function has more effects than kMost counts");
        list_[count_++] = effect;
        times_ |= 1u << static_cast<unsigned>(effect.when);
    }

  private:
    std::array<Effect, kMost> list_;  // not filled beforehand: nearly all blocks have one or two
    std::size_t count_ = 0;
    unsigned times_ = 0;  // a bit for each When
};

/// Where the tools stand. A turret has nothing to prepare, turns in a moment, and leaves the
/// spindle, which is the part, as it is.
enum class Changer : std::uint8_t { Magazine, Turret };

/// What the functions of a block and its motion do under the rules of a control.
Effects effects_of(const Rules& rules, const Block& block, Changer changer);

/// A motion code ends the modal cycle: from here on the blocks move instead.
inline bool ends_modal_cycle(const Block& block) { return block.motion != Function::None; }

/// Whether a tool that is selected is in the spindle at once.
bool selects_at_once(const Rules& rules, Changer changer);
/// When a stop of the spindle or of the coolant comes true in a block that moves as well.
When time_of_stop(const Rules& rules);
/// Whether the spindle stands behind a change of tool.
bool stops_at_tool_change(const Rules& rules, Changer changer);

/// What a change of the programmable frame gives.
struct FrameChange {
    std::array<double, 3> values{};   // X Y Z: of a shift, or the centre; mm
    std::array<bool, 3> given{};      // which of them are named
    std::array<double, 3> factors{};  // Scale
    double angle_deg = 0;             // Rotate
};
FrameChange frame_change(const Block& block, const Effect& effect);

}  // namespace kadr::nc
