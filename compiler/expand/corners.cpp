#include "expand/corners.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/diagnostics/expand.h"
#include "expand/contour_recording.h"
#include "expand/contour_values.h"
#include "expand/cycles.h"
#include "expand/drawn_words.h"
#include "expand/faults.h"
#include "expand/input_words.h"
#include "expand/text_format.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::parameter_of;

using nc::SlotMask;
using path::CornerCut;
using path::CornerShape;
using path::Element;
using path::Vec2;

namespace {

/// Blocks that may stand between the two sides of a corner.
constexpr std::size_t kMostHeld = 64;

bool is_there(const Element& element) { return path::length(element) > path::kSamePoint; }

Wording wording_now(const Running& run) {
    return {plane_of(run.modal[Group::Plane]), run.modal.is_diameter};
}

SideState state_of(const Running& run) {
    return {plane_of(run.modal[Group::Plane]), run.modal.is_diameter, run.modal.frame.now(),
            run.modal.work_offset, run.modal.tool.in()};
}

bool is_incremental_now(const Running& run) {
    return run.modal[Group::Distance] == Function::Incremental;
}

SlotMask slots_in_plane(const PlaneIndices& axes) {
    return SlotMask{1} << axes.first | SlotMask{1} << axes.second;
}

/// Nothing that moves the tool, the part or the path.
bool is_harmless(const Block& block) {
    if (block.kind == Block::Kind::Comment) return true;
    constexpr SlotMask kHarmless = nc::bit(nc::Slot::Feed) | nc::bit(nc::Slot::Speed);
    if (block.kind != Block::Kind::Nc || block.skip_level >= 0) return false;
    if ((block.given & ~kHarmless) != 0 || block.motion != Function::None) return false;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Group group = nc::info(block.functions[i].function).group;
        if (group != Group::Spindle && group != Group::Coolant && group != Group::Distance)
            return false;
    }
    return true;
}

void erase_corner(Block& block) {
    for (std::size_t i = block.function_count; i-- > 0;) {
        const Function function = block.functions[i].function;
        if (function == Function::CornerRound || function == Function::CornerChamfer)
            erase(block, i);
    }
}

// ---------------------------------------------------------------- the target's own word

/// The function of a corner, and which of its parameters the size is.
std::pair<Function, std::size_t> word_of_shape(const CornerShape& shape) {
    switch (shape.kind) {
        case CornerShape::Kind::ChamferLength:
            return {Function::CornerChamfer, parameter_of<Function::CornerChamfer>("length")};
        case CornerShape::Kind::ChamferWidth:
            return {Function::CornerChamfer, parameter_of<Function::CornerChamfer>("width")};
        case CornerShape::Kind::Rounding: break;
    }
    return {Function::CornerRound, parameter_of<Function::CornerRound>("radius")};
}

bool has_word(const nc::Dialect& target, const CornerShape& shape) {
    const nc::DialectTables& tables = target.tables();
    const auto [function, parameter] = word_of_shape(shape);
    for (const nc::FormId id : tables.forms_of[static_cast<std::size_t>(function)]) {
        const nc::Form& form = tables.forms[id];
        for (const nc::FormWord& word : form.words)
            if (word.parameter == static_cast<int>(parameter)) return true;
    }
    return false;
}

/// Whether the target makes the same of its own word. It does between two lines that stand beside
/// each other: arcs may be written in parts, and a FANUC takes the feed of the block before.
bool is_native(const Running& run, const WaitingSide& waiting, const Element& next,
               std::size_t second) {
    const nc::Rules& rules = run.target.rules();
    const Block& block = run.batch.held(second);
    const bool stand_together = second == 1 && !waiting.element.is_arc() && !next.is_arc();
    if (!stand_together || !has_word(run.target, waiting.corner.shape)) return false;
    if (rules.corner_in_own_block || waiting.state.frame.has_scale()) return false;
    if (!rules.corner_feed_of_next && block.has(nc::Slot::Feed)) return false;
    if (rules.corner_strict && waiting.begins_compensation) return false;
    return !rules.angles_in_zx || waiting.state.plane == path::Plane::Zx;
}

void say_native(Block& block, const CornerShape& shape) {
    erase_corner(block);
    const auto [function, parameter] = word_of_shape(shape);
    nc::Invocation* invocation = block.add(function, nc::info(function).parameters.size());
    if (invocation != nullptr) block.set_argument(*invocation, parameter, shape.size);
}

// ---------------------------------------------------------------- resolved

/// The block travels this element. Words of its end: those that it had, and those that differ from
/// where it begins.
void say_element(const Running& run, Block& block, const Element& element, bool is_incremental) {
    const Wording wording = wording_now(run);
    const PlaneIndices axes = wording.axes();
    const std::size_t plane_axes[2] = {axes.first, axes.second};
    const Vec2 words = wording.words(element.to);
    block.motion = !element.is_arc()   ? Function::Line
                   : element.sweep > 0 ? Function::ArcCcw
                                       : Function::ArcCw;
    block.given &= ~(nc::kCenterSlots | nc::bit(nc::Slot::Radius));
    for (std::size_t i = 0; i < 2; ++i) {
        const auto component = static_cast<Eigen::Index>(i);
        const auto word = static_cast<nc::Slot>(plane_axes[i]);
        const bool goes =
            std::abs(element.to[component] - element.from[component]) > path::kSamePoint;
        if (block.has(word) || goes) {
            block.set(word, words[component]);
            block.incremental &= ~nc::bit(word);
            if (is_incremental) block.absolute |= nc::bit(word);
        }
        if (!element.is_arc()) continue;
        const auto center =
            static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + plane_axes[i]);
        block.set(center, element.center[component] - element.from[component]);
        block.absolute &= ~nc::bit(center);
        block.incremental &= ~nc::bit(center);
    }
}

/// A motion of which the corner has taken all.
void say_nothing(const Running& run, Block& block) {
    const SlotMask in_plane = slots_in_plane(wording_now(run).axes());
    block.given &= ~(in_plane | nc::kCenterSlots | nc::bit(nc::Slot::Radius));
}

/// The motion before ends earlier, the piece is a block of its own, the motion behind begins later.
///
/// second       the place of its block among those that are held
/// Returns the place that it has then.
std::size_t resolve(Running& run, const WaitingSide& waiting, const CornerCut& cut,
                    const Element& rest, std::size_t second) {
    const bool is_incremental = is_incremental_now(run);
    Block piece{};
    piece.source = run.batch.held(0).source;
    say_element(run, piece, cut.piece, is_incremental);
    Block& first = run.batch.held(0);
    if (first.find(Function::ExactStopOnce) != nullptr) piece.add(Function::ExactStopOnce);
    Block& behind = run.batch.held(second);
    if (behind.has(nc::Slot::Feed)) {
        piece.set(nc::Slot::Feed, behind.at(nc::Slot::Feed));
        piece.feed_of_all_axes = behind.feed_of_all_axes;
        behind.given &= ~nc::bit(nc::Slot::Feed);
    }
    if (is_there(rest)) say_element(run, behind, rest, is_incremental);
    else say_nothing(run, behind);
    erase_corner(first);
    const Element left = path::part(waiting.element, 0, cut.leaves);
    if (is_there(left)) {
        say_element(run, first, left, waiting.is_incremental);
    } else {
        say_nothing(run, first);
        first.motion = Function::None;
        if (first.given == 0 && first.function_count == 0) {
            run.batch.drop_held(0);
            --second;
        }
    }
    run.batch.insert_held(second, std::move(piece));
    return second + 1;
}

/// The corner between the motion that waits and the next one, which begins behind it then.
///
/// second       the place of the next one's block; that which it has then
Done join(Running& run, Element& next, std::size_t& second) {
    const WaitingSide waiting = *std::exchange(run.corners.waiting, std::nullopt);
    const WantedCorner& corner = waiting.corner;
    for (std::size_t i = 1; i < second; ++i)
        if (!is_harmless(run.batch.held(i)))
            return refuse_open_corner(
                run, corner,
                "`" + nc::describe(run.batch.held(i)) + "` stands before its second side");
    if (!(waiting.state == state_of(run)))
        return refuse_open_corner(
            run, corner,
            "the plane, a frame, the zero point or the tool changes before its "
            "second side");
    if ((waiting.element.to - next.from).norm() > path::kSamePoint)
        return refuse_open_corner(run, corner, "the tool is moved before its second side");
    std::optional<CornerCut> cut;
    if (!cut_corner(run, corner, waiting.element, next, cut)) return kFailed;
    if (!cut) {
        erase_corner(run.batch.held(0));
        return kDone;
    }
    const Element whole = next;
    next = path::part(whole, cut->joins, 1);
    next.from = cut->piece.to;
    if (is_native(run, waiting, whole, second)) say_native(run.batch.held(0), corner.shape);
    else second = resolve(run, waiting, *cut, next, second);
    return kDone;
}

// ---------------------------------------------------------------- sides

/// Why a motion is no side of a corner; empty: it is one.
std::string why_no_side(const Running& run, const Block& block) {
    const PlaneIndices axes = wording_now(run).axes();
    const Function motion = run.modal[Group::Motion];
    if (motion == Function::Rapid) return "stands beside a rapid move";
    if (motion != Function::Line && !nc::is_arc(motion))
        return "stands beside `" + std::string(nc::info(motion).name) + '`';
    const SlotMask others = block.given & nc::kTargetSlots & ~slots_in_plane(axes);
    for (std::size_t i = 0; i < kAxes; ++i)
        if ((others >> i & 1u) != 0) return "stands beside a move of " + std::string(kAxisNames[i]);
    if (block.has(nc::Slot::Turns)) return "stands beside a helix";
    if (block.skip_level >= 0) return "stands beside a block that the operator may leave out";
    if (run.modal[Group::FeedMode] == Function::FeedInverseTime)
        return "stands under inverse time feed";
    if (run.modal.tcp.acts()) return "stands under tool centre point control";
    if (is_between_positions(run)) return "stands where a cycle is called at every position";
    if (run.modal.frame.now().is_stretched(run.modal[Group::Plane]))
        return "stands in a scale that makes ellipses of circles";
    return {};
}

Done refuse_side(Running& run, const WantedCorner& corner, const std::string& why) {
    auto builder = fault(run, diag::CornerBeside, corner.at);
    builder.arg(corner.name()).arg(why);
    if (corner.is_modal)
        builder.fix("say `RNDM=0` in the block of the last side, and `RNDM=` again behind it");
    return kFailed;
}

Done take_side(Running& run, Element element, const std::optional<WantedCorner>& corner,
               std::size_t place, bool begins_compensation) {
    if (run.corners.waiting && !join(run, element, place)) return kFailed;
    if (corner && !is_there(element)) {
        fault(run, diag::CornerRoom, corner->at)
            .arg(corner->name())
            .arg(quantity_text(run, corner->shape.size, sema::kLength))
            .arg(": the corner before it takes its whole side");
        return kFailed;
    }
    if (corner) {
        if (run.batch.is_holding()) run.batch.settle_first(place);
        else run.batch.hold_last();
        run.corners.waiting = WaitingSide{*corner, element, state_of(run), begins_compensation,
                                          is_incremental_now(run)};
    } else if (run.batch.is_holding()) {
        run.batch.settle_first(place + 1);
    }
    return kDone;
}

/// The line at an angle whose end is known now; its block stands before the last one.
Done take_first_line(Running& run) {
    const Element line = *std::exchange(run.corners.closed, std::nullopt);
    const auto corner = std::exchange(run.corners.of_closed, std::nullopt);
    const std::size_t place = run.batch.held() - 2;
    Block& block = run.batch.held(place);
    say_element(run, block, line, is_incremental_now(run));
    if (run.corners.waiting || corner) {
        const std::string why = why_no_side(run, block);
        if (!why.empty())
            return refuse_side(run, corner ? *corner : run.corners.waiting->corner, why);
    }
    return take_side(run, line, corner, place, false);
}

}  // namespace

std::optional<OpenLine>& open_line(Running& run) {
    return run.recordings.is_open() ? run.recordings.innermost().open : run.corners.open;
}

Done take_closed_line(Running& run, const Element& line, const std::optional<WantedCorner>& corner,
                      std::uint32_t at) {
    std::optional<WantedCorner> wanted = corner;
    if (!wanted && run.modal.drawing.rounding > 0)
        wanted = WantedCorner{{CornerShape::Kind::Rounding, run.modal.drawing.rounding}, true, at};
    if (run.recordings.is_open()) return add_element(run, line, wanted);
    run.corners.closed = line;
    run.corners.of_closed = wanted;
    return kDone;
}

std::optional<WantedCorner> take_wanted(Running& run, std::uint32_t at) {
    std::optional<WantedCorner> wanted = std::exchange(run.corners.wanted, std::nullopt);
    const double all = run.modal.drawing.rounding;
    if (!wanted && all > 0) wanted = WantedCorner{{CornerShape::Kind::Rounding, all}, true, at};
    return wanted;
}

Done cut_corner(Running& run, const WantedCorner& corner, const Element& a, const Element& b,
                std::optional<CornerCut>& cut) {
    cut.reset();
    if (std::fabs(path::turn_between(a, b)) < path::kNoTurn) return kDone;
    if (const auto made = path::made_corner(a, b, corner.shape, false)) {
        cut = made->cut;
        return kDone;
    }
    const auto greatest = path::made_corner(a, b, corner.shape, true);
    auto builder = fault(run, diag::CornerRoom, corner.at);
    builder.arg(corner.name()).arg(quantity_text(run, corner.shape.size, sema::kLength));
    if (!greatest) {
        builder.arg("");
        return kFailed;
    }
    const std::string most = quantity_text(run, greatest->size, sema::kLength);
    builder.arg(": at most " + most).fix("make it " + most + " at most, or its sides longer");
    return kFailed;
}

Done refuse_open_corner(Running& run, const WantedCorner& corner, std::string_view why) {
    auto builder = fault(run, diag::CornerOpen, corner.at);
    builder.arg(corner.name()).arg(why);
    builder.fix(corner.is_modal ? "say `RNDM=0` in the block of the last side"
                                : "let the second side follow: a line or an arc in the plane");
    return kFailed;
}

Done finish_side(Running& run, const KnownPosition& before, std::uint32_t at) {
    if (std::exchange(run.corners.opens, false)) {
        if (!run.batch.is_holding()) run.batch.hold_last();
        run.corners.open->held = run.batch.held();
        return kDone;
    }
    if (!require_no_open_line(run)) return kFailed;
    if (run.corners.closed && !take_first_line(run)) return kFailed;
    const Block& block = run.batch.last();
    const Wording wording = wording_now(run);
    const PlaneIndices axes = wording.axes();
    const bool has_center = (block.given & nc::kCenterSlots) != 0;
    const bool moves = (block.given & slots_in_plane(axes)) != 0 ||
                       (has_center && nc::is_arc(run.modal[Group::Motion]));
    if (!moves) {
        const auto lost = std::exchange(run.corners.wanted, std::nullopt);
        if (lost) return refuse_side(run, *lost, "stands in a block without motion in the plane");
        return kDone;
    }
    const std::optional<WantedCorner> corner = take_wanted(run, at);
    if (!corner && !run.corners.waiting) {
        if (run.batch.is_holding()) run.batch.settle_first(run.batch.held());
        return kDone;
    }
    const WantedCorner& about = run.corners.waiting ? run.corners.waiting->corner : *corner;
    const std::string why = why_no_side(run, block);
    if (!why.empty()) return refuse_side(run, about, why);
    const KnownPosition& behind = run.modal.position;
    for (const std::size_t axis : {axes.first, axes.second}) {
        if (before.knows(axis) && behind.knows(axis)) continue;
        fault(run, diag::DrawnFromWhere, about.at)
            .arg(kAxisNames[axis])
            .arg(about.name())
            .fix("name a coordinate of " + std::string(kAxisNames[axis]) + " before it");
        return kFailed;
    }
    const Vec2 from = wording.point({before[axes.first], before[axes.second]});
    const Vec2 to = wording.point({behind[axes.first], behind[axes.second]});
    const std::optional<Element> element = element_of(run, block, from, to, at);
    if (!element) return kFailed;
    if (!is_there(*element)) {
        if (corner && !corner->is_modal)
            return refuse_side(run, *corner, "stands in a block without motion in the plane");
        return kDone;
    }
    const bool begins = run.modal.compensation.moved_under() != Function::RadiusCompOff &&
                        nc::programmed_in(block, Group::RadiusComp) != Function::None;
    const std::size_t place = run.batch.is_holding() ? run.batch.held() - 1 : 0;
    return take_side(run, *element, corner, place, begins);
}

Done require_room_to_wait(Running& run) {
    if (run.corners.open && run.batch.held() > run.corners.open->held)
        return require_no_open_line(run);
    if (run.batch.held() < kMostHeld || !run.corners.waiting) return kDone;
    return refuse_open_corner(run, run.corners.waiting->corner, "no second side follows");
}

void finish_corners(Running& run) {
    if (!require_no_open_line(run)) return;
    const std::optional<WaitingSide> waiting = std::exchange(run.corners.waiting, std::nullopt);
    if (waiting && !waiting->corner.is_modal) {
        (void)refuse_open_corner(run, waiting->corner, "no second side follows");
        return;
    }
    if (run.batch.is_holding()) run.batch.settle_first(run.batch.held());
}

}  // namespace kadr::expand
