// shapes.cpp — cycles along a shape: its blocks stand in the program, from one number to another,
// or in a program that the call names.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/cycles.h"
#include "interp/feed_words.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "macro/named_shape.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Command;
using path::Op;
using path::Vec2;

namespace {

/// Whether the function chooses the plane that acts already.
bool is_plane(Function function, path::Plane plane) {
    return (function == Function::PlaneXy && plane == path::Plane::Xy) ||
           (function == Function::PlaneYz && plane == path::Plane::Yz);
}

}  // namespace

CycleShapes::CycleShapes(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      frames_(channel.state.frame.frames),
      axes_(channel.state.axes),
      cycle_(channel.state.cycle.cycle),
      shape_(channel.state.cycle.shape) {}

void CycleShapes::begin_shape(const Block& block, const ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const auto given = [&](int parameter) { return (call.given >> parameter & 1u) != 0; };
    const bool is_named = macro::names_shape(info);
    if (!is_named && (!given(info.roles.first_block) || !given(info.roles.last_block))) {
        reporter_.report(diag::ShapeNotNamed, block, Function::Cycle);
        return;
    }
    if (!is_named && modal_.plane != path::Plane::Zx) {
        reporter_.report(diag::ShapePlane, block, Function::Cycle);
        return;
    }
    channel_.cycles.end_modal();
    shape_.emplace();
    shape_->block = block;
    shape_->call = call;
    shape_->is_named = is_named;
    if (!is_named) {
        shape_->last =
            std::llround(call.arguments[static_cast<std::size_t>(info.roles.last_block)]);
        shape_->is_followed = info.parameters.size() == 2;
    }
    shape_->modal = modal_;
    shape_->before = channel_.state.keep();
}

Done CycleShapes::require_shape_block(const Block& block) {
    if (block.kind != Block::Kind::Nc || is_behind_shape(block)) return kDone;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (!nc::has_fact(block.functions[i].function, nc::Fact::EndsShape)) continue;
        if (is_plane(block.functions[i].function, modal_.plane)) continue;
        reporter_.report(diag::ShapeBlockWrong, block, block.functions[i].function)
            .arg(reporter_.word_of(block, block.functions[i].function));
        return kFailed;
    }
    if (!nc::has_fact(block.motion, nc::Fact::ShapeElement)) {
        reporter_.report(diag::ShapeBlockWrong, block, block.motion)
            .arg(reporter_.word_of(block, block.motion));
        return kFailed;
    }
    if (shape_->is_named && !modal_.has_feed) {  // the cycle gives the feeds
        channel_.feed.assume(1);
    }
    if (shape_->has_begun) return kDone;
    // A program of its own begins with what it needs.
    if (shape_->is_named && (block.given & nc::kTargetSlots) == 0) return kDone;
    shape_->has_begun = true;
    const bool goes_on = shape_->is_named && block.motion == Function::None;
    const Function motion = goes_on ? modal_.motion : block.motion;
    if (nc::has_fact(motion, nc::Fact::Straight)) {
        shape_->approaches_at_rapid = motion == Function::Rapid;
        shape_->approach_axes = block.given & nc::kTargetSlots;
        return kDone;
    }
    reporter_.report(diag::ShapeFirstBlock, block);
    return kFailed;
}

/// Behind the blocks of a program that a call has named, the cycle is called.
bool CycleShapes::is_behind_shape(const Block& block) const {
    return shape_->is_named && block.find(Function::CycleCall) != nullptr;
}

void CycleShapes::end_shape_block(const Block& block) {
    if (shape_->is_named) {
        if (is_behind_shape(block)) finish_shape();
        return;
    }
    if (!shape_->has_begun || block.number < 0 || block.number != shape_->last) return;
    finish_shape();
}

void CycleShapes::finish_shape() {
    channel_.cornering.leave_corners(shape_->is_named ? diag::CornerWithoutMotion
                                                      : diag::ShapeLastBlock);
    if (reporter_.has_alarm()) return;
    if (shape_->is_followed) return return_from_shape();
    const ShapeRun run = std::move(*shape_);
    shape_.reset();
    modal_ = run.modal;
    channel_.state.take_back(run.before);
    const nc::CycleInfo& info = dialect_.cycles()[run.call.cycle];
    ModalCycle call = run.call;
    const auto set = [&](std::string_view name, bool value) {
        for (std::size_t i = 0; i < info.parameters.size(); ++i) {
            if (info.parameters[i].name != name) continue;
            call.arguments[i] = value ? 1 : 0;
            call.given |= 1u << i;
        }
    };
    set("rapid", run.approaches_at_rapid);
    set("both",
        (run.approach_axes & bit(nc::Slot::X)) != 0 && (run.approach_axes & bit(nc::Slot::Z)) != 0);
    const CycleShape shape = shape_of(run);
    channel_.cycles.make_modal(call);
    channel_.cycles.start_cycle(run.block, call, &shape);
}

/// Back to where the tool stood before the first block.
void CycleShapes::return_from_shape() {
    const Block from = std::move(shape_->block);
    const AxisValues start = shape_->before.position.here();
    shape_.reset();
    Target back{start, frames_.to_base(start), 0};
    for (const Axis axis : {Axis::X, Axis::Z}) back.moved |= bit(axis);
    channel_.motions.line(from, back, Op::Rapid, channel_.smoothing.stops_exactly());
}

CycleShape CycleShapes::shape_of(const ShapeRun& run) const {
    CycleShape shape;
    const path::Plane plane = run.modal.plane;
    // Where the words of a cycle are rotated into another plane, so is its shape.
    shape.plane = run.is_named && !cycle_.lies_flat ? path::Plane::Xy : plane;
    shape.is_diameter = cycle_.lies_flat || axes_.word_scale[index(Axis::X)] != 1;
    const path::PlaneAxes axes = path::axes_of(plane);
    const auto in_plane = [&](const AxisValues& base) -> Vec2 {
        const AxisValues here = frames_.from_base(base);
        return {here[index(axes.first)], here[index(axes.second)]};
    };
    const bool is_mirrored = frames_.is_mirrored(plane);
    Vec2 from = in_plane(run.before.position.base());
    bool is_first = true;
    for (const Command& command : run.commands) {
        if (!command.is_motion()) continue;
        const Vec2 to = in_plane(command.motion().to);
        const bool is_distance = (to - from).norm() > path::kSamePoint || command.op() == Op::Arc;
        if (!is_first && is_distance) {
            path::Element element = path::line_element(from, to);
            if (command.op() == Op::Arc) {
                const path::ArcShape& arc = command.motion().arc();
                const AxisValues center{arc.center.x(), arc.center.y(), arc.center.z()};
                element =
                    path::arc_element(from, to, in_plane(center), arc.is_clockwise != is_mirrored);
            }
            shape.elements.push_back(element);
        }
        is_first = false;
        from = to;
    }
    return shape;
}

}  // namespace kadr::interp
