#include "interp/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/rotated_command.h"

namespace kadr::interp {

using path::Command;
using path::CornerCut;
using path::Element;
using path::is_straight;
using path::Op;
using path::Vec2;
using std::numbers::pi;

namespace {

/// Arcs at rapid are lines that touch them, one for each 10 degrees.
constexpr double kRapidPart = pi / 18;

/// Whether the tool is led under a transformation, which its block ends with whatever a corner cuts
/// off its path. Where it keeps to a surface or a line in space, the path decides its direction.
bool gives_direction(const path::Motion& motion) {
    return !motion.virtual_axes().is_on() && (motion.orient_kind == path::OrientKind::Axes ||
                                              motion.orient_kind == path::OrientKind::Cone);
}

bool can_be_cut(path::OrientKind orient_kind) {
    return orient_kind == path::OrientKind::None || orient_kind == path::OrientKind::Axes ||
           orient_kind == path::OrientKind::Cone;
}

void set_rotary(AxisValues& values, const AxisValues& from) {
    for (std::size_t i = 0; i < kAxes; ++i)
        if ((kRotaryABC >> i & 1u) != 0) values[i] = from[i];
}

bool rotary_differs(const AxisValues& a, const AxisValues& b) {
    constexpr double kSameAngle = 1e-9;  // deg
    for (std::size_t i = 0; i < kAxes; ++i)
        if ((kRotaryABC >> i & 1u) != 0 && std::fabs(a[i] - b[i]) > kSameAngle) return true;
    return false;
}

/// Under inverse time F belongs to the length of its block; of a part it is as much greater.
void keep_speed(path::Motion& motion, double share) {
    if (motion.feed_mode == path::FeedMode::InverseTime && share > 0) motion.feed /= share;
}

}  // namespace

void Corners::wish(const CornerWish& wish, const AxisValues& here, const CornerSource& source) {
    if (!is_active_) {
        lie_ = wish.lie;
        at_ = here;
        turn(lie_.transpose(), at_);
    }
    block_source_ = source;
    is_active_ = true;
    wish_ = wish;
}

const DiagnosticRow* Corners::wish_behind(const CornerWish& wish, const CornerSource& source) {
    if (!waits_ || !held_wish_.is_modal) return &diag::CornerWithoutMotion;
    const bool is_rapid = held_.front().command.op() == Op::Rapid;
    if (settings_.is_strict && is_rapid) return &diag::CornerNotContour;
    held_wish_ = wish;
    source_ = block_source_ = source;
    empty_blocks_ = 0;
    return nullptr;
}

Command& Corners::next() { return fresh_.emplace_back().command; }

void Corners::change(const CompChange& change) {
    Item& item = fresh_.emplace_back();
    item.kind = Item::Kind::Comp;
    item.change = change;
}

std::optional<CornerMessage> Corners::end_block(const AxisValues& here,
                                                const CornerSource& source) {
    block_source_ = source;
    const std::size_t motions = motions_;
    const bool waited = waits_;
    for (Item& item : fresh_) {
        turn_item(lie_.transpose(), item);
        if (const Fault fault = take(item)) return end_with(*fault);
    }
    fresh_.clear();
    Item end;
    end.kind = Item::Kind::EndOfBlock;
    end.here = here;
    end.source = source;
    turn_item(lie_.transpose(), end);
    pass(std::move(end));
    // A wish that found no motion in its own block.
    const bool is_lost = wish_.kind != CornerWish::Kind::None && !wish_.is_modal;
    if (is_lost) {
        source_ = source;
        return end_with(diag::CornerWithoutMotion);
    }
    wish_ = {};
    const bool is_empty = waited && waits_ && motions == motions_;
    if (is_empty && ++empty_blocks_ > settings_.empty_blocks)
        return leave(settings_.is_strict ? diag::CornerWithoutMotion : diag::CornerEmptyBlocks);
    is_active_ = waits_;
    return std::nullopt;
}

std::optional<CornerMessage> Corners::leave(const DiagnosticRow& why) {
    const bool is_own = wish_.kind != CornerWish::Kind::None && !wish_.is_modal;
    const bool is_given = (waits_ && !held_wish_.is_modal) || is_own;
    if (!waits_) source_ = block_source_;
    const CornerMessage message = end_with(why);
    if (!is_given) return std::nullopt;
    return message;
}

/// What waits goes on as it was programmed.
CornerMessage Corners::end_with(const DiagnosticRow& row) {
    // Of CornerSign: 1 of a corner R, 0 of a chamfer, and what was programmed.
    const double is_round = held_wish_.kind == CornerWish::Kind::Round ? 1 : 0;
    const CornerMessage message{&row, source_, is_round, held_wish_.size * held_wish_.sign};
    fresh_.clear();
    wish_ = {};
    waits_ = false;
    release();
    is_active_ = false;
    return message;
}

std::vector<Corners::Item> Corners::take_settled() {
    std::vector<Item> items;
    items.swap(settled_);
    for (Item& item : items) turn_item(lie_, item);
    return items;
}

Corners::Item Corners::in_base(Item item) const {
    turn_item(lie_, item);
    return item;
}

void Corners::turn_item(const path::Mat3& by, Item& item) const {
    if (lie_ == path::Mat3::Identity()) return;
    switch (item.kind) {
        case Item::Kind::Comp: turn(by, item.change.here); return;
        case Item::Kind::EndOfBlock: turn(by, item.here); return;
        case Item::Kind::Command:
            if (!item.command.is_motion() || item.command.motion().machine_coordinates) return;
            turn(by, item.command.motion());
            item.command.motion().moved |= kLinearXYZ;
    }
}

void Corners::release() {
    for (Item& item : held_) settled_.push_back(std::move(item));
    held_.clear();
}

void Corners::pass(Item item) { (waits_ ? held_ : settled_).push_back(std::move(item)); }

// ------------------------------------------------------------------------------ commands in

Corners::Fault Corners::take(Item& item) {
    const Command& command = item.command;
    if (item.kind != Item::Kind::Command || !command.is_motion()) {
        pass(std::move(item));
        return nullptr;
    }
    const path::Motion& motion = command.motion();
    if (waits_ && motion.plane != plane_) {  // no corner between two planes
        if (settings_.is_strict && !held_wish_.is_modal) return &diag::CornerNotContour;
        waits_ = false;
        release();
    }
    plane_ = motion.plane;
    axes_ = path::axes_of(plane_);
    const bool is_arc = motion.op() == Op::Arc;
    const bool is_contour = (is_straight(motion.op()) || (is_arc && motion.arc().turns == 0)) &&
                            can_be_cut(motion.orient_kind) && !motion.machine_coordinates;
    if (!is_contour || (is_arc && !is_in_plane(motion))) return take_other_motion(item);
    if (is_in_plane(motion)) return take_motion(item);
    at_ = motion.to;
    tool_ = motion.direction;
    pass(std::move(item));
    return nullptr;
}

Corners::Fault Corners::take_other_motion(Item& item) {
    const bool is_thread = item.command.op() == Op::Thread;
    const bool is_own = wish_.kind != CornerWish::Kind::None && !wish_.is_modal;
    const bool is_given = (waits_ && !held_wish_.is_modal) || is_own;
    if (!waits_) source_ = block_source_;
    if (is_given) return is_thread ? &diag::CornerInThread : &diag::CornerNotContour;
    at_ = item.command.motion().to;
    tool_ = item.command.motion().direction;
    waits_ = false;
    wish_ = {};
    release();
    settled_.push_back(std::move(item));
    return nullptr;
}

Corners::Fault Corners::take_motion(Item& item) {
    if (waits_) {
        if (const Fault fault = join(item.command)) return fault;
    }
    waits_ = false;
    release();
    ++motions_;
    const AxisValues from = at_;
    const path::Motion& motion = item.command.motion();
    at_ = motion.to;
    tool_ = motion.direction;
    if (is_taken(motion, from)) {
        // The orientation changes all the same.
        if (gives_direction(motion) && rotary_differs(from, at_)) {
            item.command.become(Op::Line);
            settled_.push_back(std::move(item));
        }
        return nullptr;
    }
    if (wish_.kind == CornerWish::Kind::None && !wish_.is_open) {
        settled_.push_back(std::move(item));
        return nullptr;
    }
    source_ = block_source_;
    if (settings_.is_strict && motion.op() == Op::Rapid && !wish_.is_open)
        return &diag::CornerNotContour;
    wait(std::move(item), from);
    return nullptr;
}

void Corners::wait(Item item, const AxisValues& from) {
    waits_ = true;
    held_wish_ = wish_;
    wish_ = {};
    held_from_ = from;
    empty_blocks_ = 0;
    held_.push_back(std::move(item));
}

// ------------------------------------------------------------------------------ the corner

Corners::Fault Corners::join(Command& next) {
    if (held_wish_.kind == CornerWish::Kind::None) return nullptr;  // nobody wished for one
    const Command first = held_.front().command;
    if (settings_.is_strict && next.op() == Op::Rapid) return &diag::CornerNotContour;
    const Element a = element_of(first.motion(), held_from_);
    Element b = element_of(next.motion(), at_);
    b.from = a.to;
    if (const Fault fault = check_sides(next.motion(), a, b)) return fault;
    if (std::fabs(path::turn_between(a, b)) < path::kNoTurn) return nullptr;
    Fault fault = nullptr;
    const std::optional<CornerCut> found = cut(a, b, fault);
    if (fault != nullptr || !found) return fault;
    shorten(*found);
    // A change of the compensation is for the motion behind the corner.
    const auto changes = std::stable_partition(
        held_.begin(), held_.end(), [](const Item& item) { return item.kind != Item::Kind::Comp; });
    for (auto item = held_.begin(); item != changes; ++item) settled_.push_back(std::move(*item));
    held_.erase(held_.begin(), changes);
    for (Item& item : held_) set_in_plane(item.change.here, found->piece.to);
    insert(*found, first, next);
    release();
    return nullptr;
}

/// A form that gives where the contour goes on has a square corner there.
Corners::Fault Corners::check_sides(const path::Motion& next, const Element& a,
                                    const Element& b) const {
    if (!held_wish_.is_square) return nullptr;
    if (a.is_arc() || b.is_arc() || !is_straight(next.op())) return &diag::CornerNotContour;
    const Vec2 delta = b.to - b.from;
    const double along = held_wish_.next == axes_.first ? delta.x() : delta.y();
    const double across = held_wish_.next == axes_.first ? delta.y() : delta.x();
    if (std::fabs(across) > path::kSamePoint) return &diag::CornerNotSquare;
    return along * held_wish_.sign > 0 ? nullptr : &diag::CornerSign;
}

std::optional<CornerCut> Corners::cut(const Element& a, const Element& b, Fault& fault) {
    using Kind = path::CornerShape::Kind;
    path::CornerShape shape{Kind::Rounding, held_wish_.size};
    if (held_wish_.kind == CornerWish::Kind::Length) shape.kind = Kind::ChamferLength;
    if (held_wish_.kind == CornerWish::Kind::Width) shape.kind = Kind::ChamferWidth;
    const auto made = path::made_corner(a, b, shape, !settings_.is_strict);
    if (!made) {
        if (!held_wish_.is_modal) fault = &diag::CornerTooLarge;
        return std::nullopt;
    }
    if (made->size < shape.size && !held_wish_.is_modal)
        warnings_.push_back(
            {&diag::CornerReduced, source_, round_to(made->size, 4), round_to(shape.size, 4)});
    return made->cut;
}

/// The motion before the corner ends earlier, and what stands behind it happens there.
void Corners::shorten(const CornerCut& cut) {
    path::Motion& first = held_.front().command.motion();
    const Vec2 end = cut.piece.from;
    const AxisValues whole = first.to;
    first.to = between(held_from_, whole, cut.leaves, end);
    if (gives_direction(first)) set_rotary(first.to, whole);
    if (first.op() == Op::Arc) first.arc().sweep *= cut.leaves;
    keep_speed(first, cut.leaves);
    for (auto item = held_.begin() + 1; item != held_.end(); ++item) {
        const bool is_motion = item->kind == Item::Kind::Command && item->command.is_motion();
        if (is_motion) set_in_plane(item->command.motion().to, end);
        if (item->kind == Item::Kind::EndOfBlock) set_in_plane(item->here, end);
    }
    if (is_taken(first, held_from_)) held_.erase(held_.begin());
}

/// The chamfer or rounding, and what is left of the motion behind it.
void Corners::insert(const CornerCut& cut, const Command& first, Command& next) {
    const Element& piece = cut.piece;
    const Command& own = settings_.feed_of_next ? next : first;
    const Command& other = settings_.feed_of_next ? first : next;
    Command inserted = own.op() == Op::Rapid ? other : own;
    inserted.line = first.line;
    inserted.cycle = first.cycle;
    inserted.source = first.source;
    path::Motion& motion = inserted.motion();
    const bool is_rapid = motion.op() == Op::Rapid;
    if (!is_rapid) motion.become(Op::Line);
    if (!is_rapid && held_wish_.feed > 0) motion.feed = held_wish_.feed;
    path::Motion& behind = next.motion();
    motion.exact_stop = first.motion().exact_stop;
    motion.moved = static_cast<AxisMask>(behind.moved | bit(axes_.first) | bit(axes_.second));
    motion.to = between(at_, behind.to, cut.joins, piece.to);
    if (gives_direction(behind)) set_rotary(motion.to, at_);
    stand_tool(motion);
    at_ = motion.to;
    if (behind.op() == Op::Arc) behind.arc().sweep *= 1 - cut.joins;
    keep_speed(behind, 1 - cut.joins);
    if (piece.is_arc()) return insert_arc(std::move(inserted), piece);
    settled_.emplace_back().command = std::move(inserted);
}

/// What a corner inserts the tool passes as it stands.
void Corners::stand_tool(path::Motion& motion) const {
    if (!gives_direction(motion)) return;
    motion.orient_plainly(path::OrientKind::Axes);
    motion.direction = tool_;
}

void Corners::insert_arc(Command inserted, const Element& piece) {
    path::Motion& motion = inserted.motion();
    if (motion.op() == Op::Rapid) {
        insert_rapid_arc(inserted, piece);
    } else {
        path::ArcShape arc;
        arc.center = {motion.to[0], motion.to[1], motion.to[2]};
        arc.center[static_cast<Eigen::Index>(index(axes_.first))] = piece.center.x();
        arc.center[static_cast<Eigen::Index>(index(axes_.second))] = piece.center.y();
        arc.normal = path::unit(axes_.normal) * (piece.sweep > 0 ? 1 : -1);
        arc.sweep = std::fabs(piece.sweep);
        arc.is_clockwise = piece.sweep < 0;
        motion.shape = arc;
    }
    settled_.emplace_back().command = std::move(inserted);
}

/// At rapid there are no arcs: lines outside of it that touch it. The last one, to its end, comes
/// behind them.
void Corners::insert_rapid_arc(Command part, const Element& arc) {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::fabs(arc.sweep) / kRapidPart)));
    const double half = arc.sweep / parts / 2;
    part.motion().exact_stop = false;
    Vec2 arm = arc.from - arc.center;
    for (int i = 0; i < parts; ++i) {
        set_in_plane(part.motion().to, arc.center + Eigen::Rotation2D(half) * arm / std::cos(half));
        settled_.emplace_back().command = part;
        arm = Eigen::Rotation2D(2 * half) * arm;
    }
}

// ------------------------------------------------------------------------------ the plane

bool Corners::is_in_plane(const path::Motion& motion) const {
    if (motion.op() == Op::Arc)
        return std::fabs(motion.arc().normal.dot(path::unit(axes_.normal))) > 1 - 1e-9;
    return (in_plane(motion.to) - in_plane(at_)).norm() > path::kSamePoint;
}

Element Corners::element_of(const path::Motion& motion, const AxisValues& from) const {
    if (motion.op() != Op::Arc) return path::line_element(in_plane(from), in_plane(motion.to));
    const path::ArcShape& arc = motion.arc();
    Element element{in_plane(from), in_plane(motion.to), {}, 0};
    element.center = {arc.center[static_cast<Eigen::Index>(index(axes_.first))],
                      arc.center[static_cast<Eigen::Index>(index(axes_.second))]};
    const bool is_left = arc.normal.dot(path::unit(axes_.normal)) > 0;
    element.sweep = arc.sweep * (is_left ? 1 : -1);
    return element;
}

/// Whether the corner at one of its ends has taken all of a motion. A whole circle ends where it
/// began, too.
bool Corners::is_taken(const path::Motion& motion, const AxisValues& from) const {
    const double left = motion.op() == Op::Arc ? path::length(element_of(motion, from))
                                               : (in_plane(motion.to) - in_plane(from)).norm();
    return left <= path::kSamePoint;
}

/// A position on a motion: the other axes go evenly along it.
AxisValues Corners::between(const AxisValues& from, const AxisValues& to, double share,
                            const Vec2& at) const {
    AxisValues values = to;
    for (std::size_t i = 0; i < kAxes; ++i) values[i] = from[i] + (to[i] - from[i]) * share;
    if (share >= 1) values = to;
    set_in_plane(values, at);
    return values;
}

Vec2 Corners::in_plane(const AxisValues& values) const {
    return {values[index(axes_.first)], values[index(axes_.second)]};
}

void Corners::set_in_plane(AxisValues& values, const Vec2& at) const {
    values[index(axes_.first)] = at.x();
    values[index(axes_.second)] = at.y();
}

}  // namespace kadr::interp
