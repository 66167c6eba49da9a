// cornering.cpp — what switches chamfers and roundings, and what passes through them.
#include "interp/cornering.h"

#include <cmath>

#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/diagnostics/orienting.h"
#include "interp/channel.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/tool_motion.h"
#include "interp/word_hints.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using nc::Slot;
using nc::SlotMask;

namespace {

Slot slot_across(Axis axis) {
    return static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + index(axis));
}

}  // namespace

Cornering::Cornering(Channel& channel)
    : channel_(channel),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      corners_(channel.state.stage.corners),
      comp_(channel.state.stage.comp),
      smooth_approach_(channel.state.stage.smooth_approach) {}

void Cornering::choose_corner(const Block& block, const Invocation& invocation, Actions& actions) {
    switch (invocation.function) {
        case Function::CornerRoundModal: {
            const double radius =
                block.argument(invocation, parameter_of<Function::CornerRoundModal>("radius"));
            if (radius < 0) {
                reporter_.report(diag::CornerNegative, block, invocation.function).arg(radius);
                return;
            }
            modal_rounding_ = radius;
            break;
        }
        case Function::CornerFeed:
        case Function::CornerFeedModal: {
            constexpr std::size_t kFeed =
                parameter_of_all<"feed", Function::CornerFeed, Function::CornerFeedModal>();
            const double feed = block.argument(invocation, kFeed);
            const bool is_off = invocation.function == Function::CornerFeedModal && feed == 0;
            if (!(feed > 0) && !is_off) {
                reporter_.report(diag::CornerFeedInvalid, block, invocation.function).arg(feed);
                return;
            }
            (invocation.function == Function::CornerFeed ? actions.corner_feed : corner_feed_) =
                feed;
            break;
        }
        case Function::CornerChamfer:
        case Function::CornerRound: {
            take_corner_feed(block, invocation, actions);
            const bool is_round = invocation.function == Function::CornerRound;
            const bool was_round =
                actions.corner != nullptr && actions.corner->function == Function::CornerRound;
            // Where a chamfer and a rounding stand together, the rounding is made.
            const bool is_twice =
                actions.corner != nullptr && (rules_.corner_strict || is_round == was_round);
            if (is_twice) {
                reporter_.report(diag::CornerTwice, block, invocation.function);
                return;
            }
            if (!was_round) actions.corner = &invocation;
            break;
        }
        default: break;  // no other is sent here
    }
}

/// The feed that stands in the same form as the chamfer or the rounding.
void Cornering::take_corner_feed(const Block& block, const Invocation& invocation,
                                 Actions& actions) {
    const std::size_t index = invocation.function == Function::CornerRound
                                  ? parameter_of<Function::CornerRound>("feed")
                                  : parameter_of<Function::CornerChamfer>("feed");
    if (!invocation.has(index)) return;
    const double feed = block.argument(invocation, index);
    if (feed > 0) actions.corner_feed = feed;
    else reporter_.report(diag::CornerFeedInvalid, block, invocation.function).arg(feed);
}

void Cornering::wish_corner(const Block& block, const Actions& actions) {
    if (block.is_of_cycle()) return;
    if (channel_.tool_motion.goes_straight(block, actions)) {
        if (actions.corner != nullptr)
            reporter_.report(diag::PointCorner, block, actions.corner->function);
        return;
    }
    // Where a smooth approach begins its contour, nothing stands before the corner.
    if (actions.smooth_approach != nullptr || smooth_approach_.needs_point()) {
        if (actions.corner != nullptr) reporter_.report(diag::CornerNotContour, block);
        return;
    }
    CornerWish wish;
    if (actions.corner != nullptr) {
        const Invocation& invocation = *actions.corner;
        const bool begins = actions.radius_comp && *actions.radius_comp != CompSide::Off;
        if (rules_.corner_strict && begins) {
            reporter_.report(diag::CornerAtCompStart, block, invocation.function);
            return;
        }
        const bool is_round = invocation.function == Function::CornerRound;
        constexpr std::size_t kLength = parameter_of<Function::CornerChamfer>("length");
        constexpr std::size_t kWidth = parameter_of<Function::CornerChamfer>("width");
        static_assert(kLength == parameter_of<Function::CornerRound>("radius"));
        const bool is_width = !is_round && invocation.has(kWidth);
        wish.kind = is_round   ? CornerWish::Kind::Round
                    : is_width ? CornerWish::Kind::Width
                               : CornerWish::Kind::Length;
        wish.size = block.argument(invocation, is_width ? kWidth : kLength);
        if (wish.size < 0) {
            reporter_.report(diag::CornerNegative, block, invocation.function).arg(wish.size);
            return;
        }
    } else {
        wish.is_open = modal_rounding_ == 0;
        wish.kind = wish.is_open ? CornerWish::Kind::None : CornerWish::Kind::Round;
        wish.size = modal_rounding_;
        wish.is_modal = true;
    }
    wish.feed = actions.corner_feed > 0 ? actions.corner_feed : corner_feed_;
    put_wish(block, wish);
}

/// The size counts in the programmed system, the commands are of the base system.
void Cornering::put_wish(const Block& block, CornerWish wish) {
    if (!(wish.size > 0) && !wish.is_open) return;
    if (comp_.is_face_milling_acting()) {
        if (!wish.is_open)
            reporter_.report(diag::IsoNotSupported, block)
                .arg("a chamfer or a rounding on a surface");
        return;
    }
    if (frames_.is_stretched(modal_.plane)) {
        if (!wish.is_modal) reporter_.report(diag::ArcStretched, block);
        return;
    }
    wish.lie = channel_.compensation.plane_lie();
    if (corners_.waits_elsewhere(wish.lie)) leave_corners(diag::CornerNotContour);
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    wish.size *= frames_.total().direction(path::unit(plane.first)).norm();
    const CornerSource source{block.source, block.line};
    if (!rules_.corner_in_own_block || wish.is_modal)
        return corners_.wish(wish, position_.base(), source);
    if (const DiagnosticRow* why = corners_.wish_behind(wish, source))
        reporter_.report(*why, block);
}

bool Cornering::has_square_corner(const Block& block) const {
    return rules_.corner_by_arc_words && !block.is_of_cycle() && modal_.motion == Function::Line;
}

void Cornering::wish_square_corner(const Block& block, const Target& target) {
    const SlotMask words = block.given & nc::kArcSlots;
    const path::PlaneAxes plane = path::axes_of(modal_.plane);
    const auto moves = [&](Axis axis) {
        return std::abs(target.here[index(axis)] - position_.here()[index(axis)]) >
               path::kSamePoint;
    };
    const bool along_first = moves(plane.first);
    const bool has_other = block.find(Function::CornerChamfer) != nullptr ||
                           block.find(Function::CornerRound) != nullptr;
    if ((words & (words - 1)) != 0 || has_other) {
        reporter_.report(diag::CornerTwice, block);
        return;
    }
    if (along_first == moves(plane.second)) {
        reporter_.report(diag::CornerNotSquare, block);
        return;
    }
    CornerWish wish;
    wish.is_square = true;
    wish.next = along_first ? plane.second : plane.first;
    const bool is_round = words == bit(Slot::Radius);
    if (!is_round && words != bit(slot_across(wish.next))) {
        reporter_.report(diag::CornerNotSquare, block);
        return;
    }
    wish.kind = is_round ? CornerWish::Kind::Round : CornerWish::Kind::Width;
    const double size = block.at(is_round ? Slot::Radius : slot_across(wish.next));
    wish.sign = size < 0 ? -1 : 1;
    wish.size = std::abs(size);
    put_wish(block, wish);
}

// ------------------------------------------------------------------------------ out

void Cornering::leave_corners(const DiagnosticRow& why) {
    if (!corners_.is_active()) return;
    const std::optional<CornerMessage> message = corners_.leave(why);
    pass_corners();
    if (message) report_corner(*message);
}

void Cornering::pass_corners() {
    std::vector<Corners::Item> items = corners_.take_settled();
    Block at{};
    bool has_put = false;  // since the last end of a block
    for (Corners::Item& item : items) {
        const bool is_command = item.kind == Corners::Item::Kind::Command;
        const bool is_change = item.kind == Corners::Item::Kind::Comp;
        if (is_command) {
            has_put = true;
            channel_.stages.locate(at, item.command.source, item.command.line);
            channel_.stages.behind_corners() = std::move(item.command);
            continue;
        }
        if (!is_change) {
            channel_.stages.locate(at, item.source.source, item.source.line);
        }
        // A change acts on what comes behind it.
        if (!is_change || has_put)
            channel_.stages.settle_stages(at, is_change ? item.change.here : item.here, false);
        has_put = false;
        if (is_change) channel_.compensation.change_comp(item.change);
    }
    std::vector<CornerMessage> warnings;
    warnings.swap(corners_.warnings());
    for (const CornerMessage& warning : warnings) report_corner(warning);
}

void Cornering::report_corner(const CornerMessage& message) {
    const Block at = channel_.stages.block_at(message.source.source, message.source.line);
    DiagnosticBuilder builder = reporter_.report(*message.row, at);
    if (message.row == &diag::CornerReduced) builder.arg(message.made).arg(message.wanted);
    if (message.row != &diag::CornerSign) return;
    const std::string size = with_point(std::abs(message.wanted));
    const std::string other =
        message.made > 0 ? "`R" + with_point(-message.wanted) + '`' : "the other sign";
    builder.fix(other + " goes on the other way, `," + (message.made > 0 ? "R" : "C") + size +
                "` whichever way the next block goes");
}

}  // namespace kadr::interp
