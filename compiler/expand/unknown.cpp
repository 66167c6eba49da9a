// unknown.cpp — modal state that is not known: behind raw text, behind a block that the operator
// may leave out. What needs it is written again, by the output where it is programmed,
// else by the author.
#include "expand/unknown.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/cuts.h"
#include "expand/faults.h"
#include "expand/plane.h"
#include "expand/running.h"
#include "expand/scopes.h"
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

// ---------------------------------------------------------------- what needs it

void report_lost_position(const Running& run, DiagnosticBuilder& builder, std::size_t axis) {
    const LostBy& lost = run.modal.position.lost_by(axis);
    note_statement(run, builder, lost.statement, words_of(lost.how));
}

Done refuse_lost_state(Running& run, std::string_view what, std::string_view fix,
                       std::uint32_t at) {
    report_loss(run, fault(run, diag::StateLost, at), what, fix);
    return kFailed;
}

void report_loss(Running& run, DiagnosticBuilder builder, std::string_view what,
                 std::string_view fix) {
    builder.arg(what);
    note_statement(run, builder, run.modal.lost.by(), words_of(run.modal.lost.how()));
    builder.fix(std::string(fix));
    const std::string words = words_of_lost(run.modal.lost.what());
    if (run.modal.lost.how() == Loss::RawText && !words.empty())
        builder.fix("or say behind the raw text all at once what the part needs: " + words);
}

namespace {

Done require_state(Running& run, const Block& block, std::uint32_t at) {
    const auto lacks = [&](Group group) { return run.modal.lost.has(group); };
    const bool is_reference = block.find(Function::ReferenceReturn) != nullptr;
    const Function motion = run.modal[Group::Motion];
    // A control without words for it writes a single distance by the dimensions of its block,
    // too.
    const nc::DialectTables& tables = run.target.tables();
    const bool says_each = tables.notation.has_modes || tables.has_incremental_letters;
    const nc::SlotMask by_itself = says_each ? block.absolute | block.incremental : 0;
    const nc::SlotMask bare = block.given & nc::kTargetSlots & ~by_itself;
    if (bare != 0 && lacks(Group::Distance))
        return refuse_lost_state(run, "whether coordinates are absolute", kDistanceFix, at);
    if (moves(block) && lacks(Group::Motion) && !is_reference)
        return refuse_lost_state(run, "the motion", "say `G0`, `G1`, `G2` or `G3`", at);
    const bool needs_plane = (moves(block) && (nc::is_arc(motion) || run.recordings.is_open())) ||
                             block.find(nc::Fact::NeedsPlane) != nullptr;
    if (needs_plane && lacks(Group::Plane))
        return refuse_lost_state(run, "the plane", kPlaneFix, at);
    const bool needs_frame = block.find(nc::Fact::AddsToFrame) != nullptr;
    if (needs_frame && run.modal.lost.has(sema::kFrameBit))
        return refuse_lost_state(run, "the frame", kFrameFix, at);
    const bool needs_feed =
        moves(block) && nc::has_fact(motion, nc::Fact::Cut) && !run.recordings.is_open();
    if (needs_feed && !block.has(nc::Slot::Feed) && run.modal.lost.has(sema::kFeedBit))
        return refuse_lost_state(run, "the feed", "give the block an F", at);
    return kDone;
}

}  // namespace

Done require_state_for_cycle(Running& run, const sema::FunctionCode& cycle, std::uint32_t given,
                             std::uint32_t at) {
    if (run.modal.lost.has(Group::Distance))
        return refuse_lost_state(run, "whether coordinates are absolute", kDistanceFix, at);
    if (run.modal.lost.has(Group::Plane)) return refuse_lost_state(run, "the plane", kPlaneFix, at);
    const auto feed = std::ranges::find(cycle.parameters, sema::ParameterInfo::Kind::Feed,
                                        &sema::ParameterInfo::kind);
    const bool lacks_feed =
        feed != cycle.parameters.end() && (given >> (feed - cycle.parameters.begin()) & 1u) == 0;
    if (lacks_feed && run.modal.lost.has(sema::kFeedBit))
        return refuse_lost_state(run, "the feed", "say F before it", at);
    return kDone;
}

Done require_frame(Running& run, bool turns, std::uint32_t at) {
    if (run.modal.lost.has(sema::kFrameBit))
        return refuse_lost_state(run, "the frame", kFrameFix, at);
    if (turns && run.modal.lost.has(Group::Plane))
        return refuse_lost_state(run, "the plane", kPlaneFix, at);
    return kDone;
}

Done require_sure_compensation(Running& run, const Block& block, std::uint32_t at) {
    const PlaneIndices axes = indices_of(plane_of(run.modal[Group::Plane]));
    const nc::SlotMask plane = nc::SlotMask{1} << axes.first | nc::SlotMask{1} << axes.second;
    const bool needs = (block.given & (plane | nc::kCenterSlots)) != 0 ||
                       has_group(block, Group::Plane) ||  // an alarm beside a contour
                       (block.function_count != 0 && changes_tool(run, block));
    if (!needs || block.skip_level == run.modal.compensation.choice()) return kDone;
    compensation_chosen(run, fault(run, diag::CompensationInDoubt, at));
    return kFailed;
}

void compensation_chosen(Running& run, DiagnosticBuilder builder) {
    note_statement(run, builder, run.modal.compensation.by(), "this block may be left out");
    builder.fix("leave out all of the contour: the same `/` in each of its blocks");
}

Done require_feed_mode(Running& run, std::uint32_t at) {
    if (!run.modal.lost.has(Group::FeedMode)) return kDone;
    return refuse_lost_state(run, "what F means", "say `G94`, `G95` or `G93`", at);
}

Done require_speed_mode(Running& run, std::uint32_t at) {
    if (!run.modal.lost.has(Group::SpeedMode)) return kDone;
    // A control without constant cutting speed knows one meaning of S.
    const auto on = static_cast<std::size_t>(Function::CuttingSpeedOn);
    if (run.target.tables().forms_of[on].empty()) return kDone;
    return refuse_lost_state(run, "what S means", "say `G96` or `G97`", at);
}

// ---------------------------------------------------------------- what is written again

namespace {

void put_again(Running& run, Block& block) {
    const auto say_mode = [&](Group group) {
        if ((run.modal.lost.restate() & group_bit(group)) == 0 || has_group(block, group)) return;
        if (run.modal[group] != Function::None) block.add(run.modal[group]);
    };
    say_mode(Group::FeedMode);
    say_mode(Group::SpeedMode);
    constexpr sema::ModalMask kFeed = sema::kFeedBit | group_bit(Group::FeedMode);
    constexpr sema::ModalMask kSpeed = sema::kSpeedBit | group_bit(Group::SpeedMode);
    if ((run.modal.lost.restate() & kFeed) != 0 && run.modal.feed.is_known() &&
        !block.has(nc::Slot::Feed))
        block.set(nc::Slot::Feed, run.modal.feed.value());
    if ((run.modal.lost.restate() & kSpeed) != 0 && run.modal.speed.is_known() &&
        !block.has(nc::Slot::Speed))
        block.set(nc::Slot::Speed, run.modal.speed.value());
    if (block.skip_level < 0) run.modal.lost.settle(run.modal.lost.restate());
}

}  // namespace

void say_again_alone(Running& run, SourceId source, std::uint32_t at, std::size_t depth) {
    Block& block = next_block(run, source);
    put_again(run, block);
    if (block.function_count == 0 && block.given == 0) return drop_block(run, block);
    if (run.options.trace) keep_trace(run, at, static_cast<unsigned>(depth), source);
}

void say_diameter(Running& run, Block& block) {
    bool acts = block.motion != Function::None || (block.given & nc::kTargetSlots) != 0;
    for (std::size_t i = 0; i < block.function_count; ++i)
        acts = acts || nc::info(block.functions[i].function).group != Group::NonModal;
    if (!acts || block.skip_level >= 0 || !block.add(run.modal.owed.diameter())) return;
    run.modal.owed.owe_diameter(Function::None);
}

void say_diameter_alone(Running& run, SourceId source, std::uint32_t at, std::size_t depth) {
    next_block(run, source).add(run.modal.owed.diameter());
    run.modal.owed.owe_diameter(Function::None);
    if (run.options.trace) keep_trace(run, at, static_cast<unsigned>(depth), source);
}

void warn_of_radius(Running& run, const Block& block, std::uint32_t at) {
    const bool turns =
        block.find(Function::CuttingSpeedOn) != nullptr || block.motion == Function::Thread;
    const auto on = static_cast<std::size_t>(Function::DiameterOn);
    if (!turns || run.target.tables().forms_of[on].empty()) return;
    if (run.reported.first_time(ProgramNotice::Diameter)) fault(run, diag::DiameterNotSaid, at);
}

Done settle_unknown(Running& run, Block& block, std::uint32_t at) {
    if (run.modal.lost.what() != 0 && !require_state(run, block, at)) return kFailed;
    if (run.recordings.is_open() || !moves(block) ||
        !nc::has_fact(run.modal[Group::Motion], nc::Fact::Cut))
        return kDone;
    if (run.modal.lost.restate() != 0) put_again(run, block);
    if (run.modal.speed.is_turning_in_doubt() &&
        run.modal.reported.first_time(ProgramNotice::SpindleInDoubt))
        warn_of_choice(run, fault(run, diag::SpindleInDoubt, at));
    return kDone;
}

void warn_of_choice(Running& run, DiagnosticBuilder builder) {
    note_statement(run, builder, run.modal.lost.by(), "this block may be left out");
}

// ---------------------------------------------------------------- promises, the end, arcs

Done keep_promise(Running& run, const OpenWith& promise, std::uint32_t at) {
    const ModalState& before = promise.before;
    const sema::ModalMask lost = promise.mask & run.modal.lost.what() & ~before.lost.what();
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if ((lost & group_bit(group)) == 0 || before[group] != Function::None) continue;
        fault(run, diag::StateUnknown, at).arg(nc::group_name(group));
        return kFailed;
    }
    return lost == 0 ? kDone : set_back(run, {lost, before}, run.modal.lost.by(), at, 0);
}

void warn_after_end(Running& run, std::uint32_t at) {
    if (!run.modal.reported.first_time(ProgramNotice::AfterEnd)) return;
    DiagnosticBuilder builder = fault(run, diag::BlockAfterEnd, at);
    note_statement(run, builder, run.modal.ended_by, "the program ends here");
}

Done require_radius(Running& run, const Block& block, std::uint32_t at) {
    if (!moves(block)) return kDone;
    bool is_point = block.has(nc::Slot::Radius) && block.at(nc::Slot::Radius) == 0;
    if ((block.given & nc::kCenterSlots) != 0) {
        const PlaneIndices axes = indices_of(plane_of(run.modal[Group::Plane]));
        is_point = true;
        for (const std::size_t axis : {axes.first, axes.second}) {
            const auto slot =
                static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + axis);
            if (!block.has(slot)) continue;
            double distance = block.at(slot);
            if ((block.absolute & nc::bit(slot)) != 0) {
                if (!run.modal.position.knows(axis)) return kDone;
                distance -= run.modal.position[axis];
            }
            is_point = is_point && std::fabs(distance) < kNoRadius;
        }
    }
    if (!is_point) return kDone;
    fault(run, diag::ArcWithoutRadius, at);
    return kFailed;
}

}  // namespace kadr::expand
