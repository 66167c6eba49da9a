// unknown.cpp — modal state that is not known: behind raw text, behind a block that the operator
// may leave out. What needs it is written again, by the output where it is programmed,
// else by the author.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/diagnostics/expand.h"
#include "expand/plane.h"
#include "expand/state.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using sema::group_bit;

namespace {

constexpr const char* kDistanceFix = "say `G90` or `G91`";
constexpr const char* kPlaneFix = "say `G17`, `G18` or `G19`";
constexpr const char* kFrameFix = "`shift();` ends all frames";

/// A center nearer to the start than this is the start, mm.
constexpr double kNoRadius = 1e-9;

bool moves(const Block& block) {
    return (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0;
}

/// What a part needs of the modal state, as a program has it.
struct StateWord {
    Group group;
    std::string_view word;
};
constexpr std::array kStateWords = {
    StateWord{Group::Distance, "G90"},   StateWord{Group::Plane, "G17"},
    StateWord{Group::RadiusComp, "G40"}, StateWord{Group::Diameter, "DIAMOF"},
    StateWord{Group::FeedMode, "G94"},   StateWord{Group::SpeedMode, "G97"},
};

/// All that raw text has lost, for one block behind it.
std::string words_of_lost(sema::ModalMask lost) {
    std::string words;
    for (const auto& [group, word] : kStateWords) {
        if ((lost & group_bit(group)) == 0) continue;
        if (!words.empty()) words += ' ';
        words += word;
    }
    if (!words.empty()) words = '`' + words + '`';
    const auto add = [&](sema::ModalMask bit, std::string_view word) {
        if ((lost & bit) == 0) return;
        if (!words.empty()) words += ", ";
        words += word;
    };
    add(sema::kFeedBit, "F");
    add(sema::kSpeedBit, "S");
    add(sema::kFrameBit, "`shift();` for the frames");
    return words;
}

std::string words_of(Loss how) {
    switch (how) {
        case Loss::RawText: return "nobody knows what this text changes";
        case Loss::SkippedBlock: return "nobody knows whether this block is executed";
        case Loss::EndOfWith: return "what was set for the block of `with` ends here";
        case Loss::Control: return "behind this block the control alone knows it";
    }
    return {};
}

bool has_group(const Block& block, Group group) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (nc::info(block.functions[i].function).group == group) return true;
    }
    return false;
}

}  // namespace

// ---------------------------------------------------------------- what becomes unknown

void ModalState::forget(SourceId source) {
    const AxisMask before = std::exchange(known, AxisMask{0});
    note_lost_positions(before, source, Loss::RawText);
    // What X of the program is does not change by that: the text writes it again.
    const Function diameter = (*this)[Group::Diameter];
    active.fill(Function::None);
    has_feed = has_speed = has_tool = has_tool_in = false;
    length.offset.reset();
    master_spindle = 0;
    lacks_tool = lacks_speed = false;
    lose_all_drift();
    restate_motion = false;
    has_ended = spindle_in_doubt = is_feed_lost = false;
    restate = 0;
    comp_choice = kNoChoice;
    lost = sema::kFrameBit | sema::kFeedBit | sema::kSpeedBit;
    for (std::size_t i = 0; i < nc::kGroups; ++i) lost |= group_bit(static_cast<Group>(i));
    if (diameter != Function::None) {
        active[static_cast<std::size_t>(Group::Diameter)] = diameter_due = diameter;
        lost &= ~group_bit(Group::Diameter);
    }
    lost_by = source;
    lost_in = Loss::RawText;
}

void ModalState::forget_feed(SourceId source) {
    has_feed = false;
    lost |= sema::kFeedBit;
    lost_by = source;
    lost_in = Loss::EndOfWith;
}

void ModalState::join(const ModalState& without, SourceId block) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        const bool is_same = (without.known >> i & 1u) != 0 && position[i] == without.position[i];
        if (!is_same) known &= static_cast<AxisMask>(~(1u << i));
    }
    note_lost_positions(without.known, block, Loss::SkippedBlock);
    // The tool may stand as it did; what was unknown of the drift stays so (take_words).
    is_turned |= without.is_turned;
    is_inclined |= without.is_inclined;
    has_tool &= without.has_tool && tool == without.tool;
    has_tool_in &= without.has_tool_in && tool_in == without.tool_in;
    if (master_spindle != without.master_spindle) master_spindle = 0;
    if (length.offset != without.length.offset) length.offset.reset();
    if (has_feed != without.has_feed || feed != without.feed) restate |= sema::kFeedBit;
    if (has_speed != without.has_speed || speed != without.speed) restate |= sema::kSpeedBit;
    for (std::size_t i = 0; i < nc::kGroups; ++i)
        if (active[i] != without.active[i]) join_group(static_cast<Group>(i), block);
}

/// A group whose member is the operator's choice.
void ModalState::join_group(Group group, SourceId block) {
    switch (group) {
        case Group::FeedMode:
            restate |= group_bit(group);
            if (!has_feed) lose_to_choice(sema::kFeedBit, block);
            break;
        case Group::SpeedMode:
            restate |= group_bit(group);
            if (!has_speed) lose_to_choice(sema::kSpeedBit, block);
            break;
        case Group::Spindle:
        case Group::Coolant:
            // To write it again would take the choice away.
            active[static_cast<std::size_t>(group)] = Function::None;
            lose_to_choice(group_bit(group), block);
            if (group != Group::Spindle) break;
            spindle_in_doubt = true;
            reported.renew(ProgramNotice::SpindleInDoubt);
            break;
        case Group::Diameter: diameter_due = (*this)[group]; break;
        default: break;  // written again by the writer
    }
}

void ModalState::lose_to_choice(sema::ModalMask what, SourceId block) {
    lost |= what;
    lost_by = block;
    lost_in = Loss::SkippedBlock;
}

// ---------------------------------------------------------------- what needs it

/// Which statement has made the position of an axis unknown, if one did.
void Expander::State::report_lost_position(DiagnosticBuilder& builder, std::size_t axis) const {
    const LostBy& lost = modal.position_lost_by[axis];
    if (lost.statement.is_valid() && lost.statement.index < code.statements.size())
        builder.note(code.statements[lost.statement.index], words_of(lost.how));
}

Done Expander::State::refuse_lost_state(std::string_view what, std::string_view fix,
                                        std::uint32_t at) {
    report_loss(fault(diag::StateLost, at), what, fix);
    return kFailed;
}

void Expander::State::report_loss(DiagnosticBuilder builder, std::string_view what,
                                  std::string_view fix) {
    builder.arg(what);
    if (modal.lost_by.is_valid() && modal.lost_by.index < code.statements.size()) {
        builder.note(code.statements[modal.lost_by.index], words_of(modal.lost_in));
    }
    builder.fix(std::string(fix));
    const std::string words = words_of_lost(modal.lost);
    if (modal.lost_in == Loss::RawText && !words.empty())
        builder.fix("or say behind the raw text all at once what the part needs: " + words);
}

Done Expander::State::require_state(const Block& block, std::uint32_t at) {
    const auto lacks = [&](Group group) { return (modal.lost & group_bit(group)) != 0; };
    const bool is_reference = block.find(Function::ReferenceReturn) != nullptr;
    const Function motion = modal[Group::Motion];
    // A control without words for it writes a single distance by the dimensions of its block, too.
    const nc::DialectTables& tables = target.tables();
    const bool says_each = tables.notation.has_modes || tables.has_incremental_letters;
    const nc::SlotMask by_itself = says_each ? block.absolute | block.incremental : 0;
    const nc::SlotMask bare = block.given & nc::kTargetSlots & ~by_itself;
    if (bare != 0 && lacks(Group::Distance))
        return refuse_lost_state("whether coordinates are absolute", kDistanceFix, at);
    if (moves(block) && lacks(Group::Motion) && !is_reference)
        return refuse_lost_state("the motion", "say `G0`, `G1`, `G2` or `G3`", at);
    const bool needs_plane = (moves(block) && (nc::is_arc(motion) || !recordings.empty())) ||
                             block.find(nc::Fact::NeedsPlane) != nullptr;
    if (needs_plane && lacks(Group::Plane)) return refuse_lost_state("the plane", kPlaneFix, at);
    const bool needs_frame = block.find(nc::Fact::AddsToFrame) != nullptr;
    if (needs_frame && (modal.lost & sema::kFrameBit) != 0)
        return refuse_lost_state("the frame", kFrameFix, at);
    const bool needs_feed =
        moves(block) && nc::has_fact(motion, nc::Fact::Cut) && recordings.empty();
    if (needs_feed && !block.has(nc::Slot::Feed) && (modal.lost & sema::kFeedBit) != 0)
        return refuse_lost_state("the feed", "give the block an F", at);
    return kDone;
}

Done Expander::State::require_state_for_cycle(const sema::FunctionCode& cycle, std::uint32_t given,
                                              std::uint32_t at) {
    if ((modal.lost & group_bit(Group::Distance)) != 0)
        return refuse_lost_state("whether coordinates are absolute", kDistanceFix, at);
    if ((modal.lost & group_bit(Group::Plane)) != 0)
        return refuse_lost_state("the plane", kPlaneFix, at);
    const auto feed = std::ranges::find(cycle.parameters, sema::ParameterInfo::Kind::Feed,
                                        &sema::ParameterInfo::kind);
    const bool lacks_feed =
        feed != cycle.parameters.end() && (given >> (feed - cycle.parameters.begin()) & 1u) == 0;
    if (lacks_feed && (modal.lost & sema::kFeedBit) != 0)
        return refuse_lost_state("the feed", "say F before it", at);
    return kDone;
}

Done Expander::State::require_frame(bool turns, std::uint32_t at) {
    if ((modal.lost & sema::kFrameBit) != 0) return refuse_lost_state("the frame", kFrameFix, at);
    if (turns && (modal.lost & group_bit(Group::Plane)) != 0)
        return refuse_lost_state("the plane", kPlaneFix, at);
    return kDone;
}

/// Reports a block that needs to know whether the cutter's radius is compensated, where that is the
/// operator's choice and the block is not part of it.
Done Expander::State::require_sure_compensation(const Block& block, std::uint32_t at) {
    const PlaneIndices axes = indices_of(plane_of(modal[Group::Plane]));
    const nc::SlotMask plane = nc::SlotMask{1} << axes.first | nc::SlotMask{1} << axes.second;
    const bool needs = (block.given & (plane | nc::kCenterSlots)) != 0 ||
                       has_group(block, Group::Plane) ||  // an alarm beside a contour
                       (block.function_count != 0 && changes_tool(block));
    if (!needs || block.skip_level == modal.comp_choice) return kDone;
    compensation_chosen(fault(diag::CompensationInDoubt, at));
    return kFailed;
}

void Expander::State::compensation_chosen(DiagnosticBuilder builder) {
    if (modal.comp_by.is_valid() && modal.comp_by.index < code.statements.size())
        builder.note(code.statements[modal.comp_by.index], "this block may be left out");
    builder.fix("leave out all of the contour: the same `/` in each of its blocks");
}

Done Expander::State::require_feed_mode(std::uint32_t at) {
    if ((modal.lost & group_bit(Group::FeedMode)) == 0) return kDone;
    return refuse_lost_state("what F means", "say `G94`, `G95` or `G93`", at);
}

Done Expander::State::require_speed_mode(std::uint32_t at) {
    if ((modal.lost & group_bit(Group::SpeedMode)) == 0) return kDone;
    // A control without constant cutting speed knows one meaning of S.
    const auto on = static_cast<std::size_t>(Function::CuttingSpeedOn);
    if (target.tables().forms_of[on].empty()) return kDone;
    return refuse_lost_state("what S means", "say `G96` or `G97`", at);
}

// ---------------------------------------------------------------- what is written again

void Expander::State::put_again(Block& block) {
    const auto say_mode = [&](Group group) {
        if ((modal.restate & group_bit(group)) == 0 || has_group(block, group)) return;
        if (modal[group] != Function::None) block.add(modal[group]);
    };
    say_mode(Group::FeedMode);
    say_mode(Group::SpeedMode);
    constexpr sema::ModalMask kFeed = sema::kFeedBit | group_bit(Group::FeedMode);
    constexpr sema::ModalMask kSpeed = sema::kSpeedBit | group_bit(Group::SpeedMode);
    if ((modal.restate & kFeed) != 0 && modal.has_feed && !block.has(nc::Slot::Feed))
        block.set(nc::Slot::Feed, modal.feed);
    if ((modal.restate & kSpeed) != 0 && modal.has_speed && !block.has(nc::Slot::Speed))
        block.set(nc::Slot::Speed, modal.speed);
    if (block.skip_level < 0) modal.restate = 0;
}

/// … in a block of its own, before a cycle that the control has itself.
void Expander::State::say_again_alone(SourceId source, std::uint32_t at, std::size_t depth) {
    Block& block = next_block(source);
    put_again(block);
    if (block.function_count == 0 && block.given == 0) return drop_block(block);
    if (options.trace) keep_trace(at, static_cast<unsigned>(depth), source);
}

/// What X is, with the first block that moves or that sets another state.
void Expander::State::say_diameter(Block& block) {
    bool acts = block.motion != Function::None || (block.given & nc::kTargetSlots) != 0;
    for (std::size_t i = 0; i < block.function_count; ++i)
        acts = acts || nc::info(block.functions[i].function).group != Group::NonModal;
    if (!acts || block.skip_level >= 0 || !block.add(modal.diameter_due)) return;
    modal.diameter_due = Function::None;
}

/// … or in a block of its own.
void Expander::State::say_diameter_alone(SourceId source, std::uint32_t at, std::size_t depth) {
    next_block(source).add(modal.diameter_due);
    modal.diameter_due = Function::None;
    if (options.trace) keep_trace(at, static_cast<unsigned>(depth), source);
}

void Expander::State::warn_of_radius(const Block& block, std::uint32_t at) {
    const bool turns =
        block.find(Function::CuttingSpeedOn) != nullptr || block.motion == Function::Thread;
    const auto on = static_cast<std::size_t>(Function::DiameterOn);
    if (!turns || target.tables().forms_of[on].empty()) return;
    if (reported.first_time(ProgramNotice::Diameter)) fault(diag::DiameterNotSaid, at);
}

Done Expander::State::settle_unknown(Block& block, std::uint32_t at) {
    if (modal.lost != 0 && !require_state(block, at)) return kFailed;
    if (!recordings.empty() || !moves(block) || !nc::has_fact(modal[Group::Motion], nc::Fact::Cut))
        return kDone;
    if (modal.restate != 0) put_again(block);
    if (modal.spindle_in_doubt && modal.reported.first_time(ProgramNotice::SpindleInDoubt))
        warn_of_choice(fault(diag::SpindleInDoubt, at));
    return kDone;
}

void Expander::State::warn_of_choice(DiagnosticBuilder builder) {
    if (modal.lost_by.is_valid() && modal.lost_by.index < code.statements.size())
        builder.note(code.statements[modal.lost_by.index], "this block may be left out");
}

// ---------------------------------------------------------------- promises, the end, arcs

/// What raw text in a cycle may have changed is set back where the cycle ends.
Done Expander::State::keep_promise(const OpenWith& promise, std::uint32_t at) {
    const ModalState& before = promise.before;
    const sema::ModalMask lost = promise.mask & modal.lost & ~before.lost;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if ((lost & group_bit(group)) == 0 || before[group] != Function::None) continue;
        fault(diag::StateUnknown, at).arg(nc::group_name(group));
        return kFailed;
    }
    return lost == 0 ? kDone : set_back({lost, before}, modal.lost_by, at, 0);
}

void Expander::State::warn_after_end(std::uint32_t at) {
    if (!modal.reported.first_time(ProgramNotice::AfterEnd)) return;
    DiagnosticBuilder builder = fault(diag::BlockAfterEnd, at);
    if (modal.ended_by.is_valid() && modal.ended_by.index < code.statements.size())
        builder.note(code.statements[modal.ended_by.index], "the program ends here");
}

Done Expander::State::require_radius(const Block& block, std::uint32_t at) {
    if (!moves(block)) return kDone;
    bool is_point = block.has(nc::Slot::Radius) && block.at(nc::Slot::Radius) == 0;
    if ((block.given & nc::kCenterSlots) != 0) {
        const PlaneIndices axes = indices_of(plane_of(modal[Group::Plane]));
        is_point = true;
        for (const std::size_t axis : {axes.first, axes.second}) {
            const auto slot =
                static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + axis);
            if (!block.has(slot)) continue;
            double distance = block.at(slot);
            if ((block.absolute & nc::bit(slot)) != 0) {
                if ((modal.known >> axis & 1u) == 0) return kDone;
                distance -= modal.position[axis];
            }
            is_point = is_point && std::fabs(distance) < kNoRadius;
        }
    }
    if (!is_point) return kDone;
    fault(diag::ArcWithoutRadius, at);
    return kFailed;
}

}  // namespace kadr::expand
