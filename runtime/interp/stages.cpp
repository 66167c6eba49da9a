#include "interp/stages.h"

#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/path_smoothing.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/smooth_approaches.h"
#include "interp/splines.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"

namespace kadr::interp {

using nc::Block;
using path::Command;
using path::Op;

Stages::Stages(Channel& channel)
    : channel_(channel),
      reporter_(channel.state.reporter),
      output_(channel.state.stage.output),
      block_count_(channel.state.motion.block_count),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      surface_(channel.state.stage.surface),
      corners_(channel.state.stage.corners),
      comp_(channel.state.stage.comp),
      smooth_approach_(channel.state.stage.smooth_approach),
      compensation_(channel.state.stage.compensation),
      comp_3d_(channel.state.stage.comp_3d),
      spline_commands_(channel.state.cycle.spline_commands),
      puts_span_(channel.state.cycle.puts_span),
      dynamics_(channel.state.motion.dynamics),
      dangers_(channel.state.stage.dangers),
      cycle_(channel.state.cycle.cycle),
      callers_(channel.state.cycle.callers),
      shape_(channel.state.cycle.shape),
      contour_(channel.state.cycle.contour) {}

void Stages::settle(const Block& block) {
    if (!corners_.is_active()) return settle_stages(block, position_.base(), true);
    std::optional<CornerMessage> message;
    if (reporter_.has_alarm()) {
        message = corners_.leave(diag::CornerWithoutMotion);
        message.reset();  // the block has reported what is wrong
    } else {
        message = corners_.end_block(position_.base(), {block.source, block.line});
        if (!message && reporter_.has_ended()) message = corners_.leave(diag::CornerWithoutMotion);
    }
    channel_.cornering.pass_corners();
    if (message) channel_.cornering.report_corner(*message);
    if (!reporter_.has_alarm() && reporter_.has_ended() && channel_.compensation.is_any_comp_on())
        channel_.compensation.flush_comp();
}

void Stages::settle_stages(const Block& block, const AxisValues& here, bool is_last) {
    if (smooth_approach_.is_active()) channel_.approaches.settle_approach(block);
    if (channel_.compensation.is_any_comp_on())
        channel_.compensation.settle_comp(block, here, is_last);
}

bool Stages::has_stages() const {
    return corners_.is_active() || channel_.compensation.is_any_comp_on() ||
           smooth_approach_.is_active();
}

Command& Stages::behind_corners() {
    if (channel_.shapes.keeps_shape()) return shape_->commands.emplace_back();
    if (contour_) return contour_->commands.emplace_back();
    if (smooth_approach_.is_active()) return smooth_approach_.next();
    if (comp_3d_.is_on()) return comp_3d_.next();
    return compensation_.is_on() ? compensation_.next() : output_.next();
}

namespace {

/// Neither does it orient the tool, nor is it given in other axes, nor touch with the flank.
void forget_extras(path::Motion& motion) {
    motion.contact.reset();
    motion.orient_plainly(path::OrientKind::None);
    motion.direction = path::Vec3::UnitZ();
    motion.virtual_system.reset();
}

}  // namespace

Command& Stages::put(Op op, const Block& block, const OrientPlan* orientation) {
    if (path::is_motion(op)) dangers_.begin_motion(op, position_.base());
    const bool waits = channel_.splines.is_in_spline() && op != Op::Spline && !puts_span_;
    Command& command = waits                  ? spline_commands_.next()
                       : corners_.is_active() ? corners_.next()
                                              : behind_corners();
    command.become(op);
    fill_in(command, block, orientation);
    return command;
}

path::Motion& Stages::put_straight_out(Op op, const Block& block) {
    dangers_.begin_motion(op, position_.base());
    Command& command = output_.next();
    command.become(op);
    fill_in_head(command, block);
    path::Motion& motion = command.motion();
    fill_in_modal(motion, block);
    forget_extras(motion);
    return motion;
}

void Stages::fill_in_head(Command& command, const Block& block) {
    command.source = block.source;
    command.line = block.line;
    command.cycle = block.is_of_cycle() ? block.context->number : 0;
    command.is_unshifted = channel_.frames.are_off();
}

/// What the modal state has for a motion.
void Stages::fill_in_modal(path::Motion& motion, const Block& block) {
    const Op op = motion.op();
    motion.feed_mode = modal_.feed_mode;
    motion.plane = modal_.plane;
    motion.exact_stop = false;
    motion.blending = channel_.smoothing.blending(op);
    motion.compress = block.is_of_cycle() ? 0 : channel_.smoothing.compressing(op);
    motion.machine_coordinates = false;
    dynamics_.put_panel(motion, block,
                        {modal_.taps, modal_.feed_mode, static_cast<std::uint32_t>(block_count_)});
    motion.moved = 0;
    motion.to = position_.base();
}

/// The slot may have held any other command.
void Stages::fill_in(Command& command, const Block& block, const OrientPlan* orientation) {
    fill_in_head(command, block);
    if (!command.is_motion()) return;
    path::Motion& motion = command.motion();
    fill_in_modal(motion, block);
    const bool is_turned = channel_.transformation.is_transformed();
    if (!is_turned) forget_extras(motion);
    const bool reaches_comp = comp_3d_.is_on() || corners_.is_active();
    if (comp_.is_face_milling_acting() && reaches_comp)
        motion.contact = path::ContactMotion{surface_, path::Vec3::Zero(), path::Vec3::Zero()};
    else motion.contact.reset();
    if (is_turned) channel_.tool_motion.put_orientation(motion, orientation);
}

Block Stages::block_at(SourceId source, std::uint32_t line) const {
    Block at{};
    locate(at, source, line);
    return at;
}

void Stages::locate(Block& at, SourceId source, std::uint32_t line) const {
    at.source = source;
    at.line = line;
    const bool is_call = callers_.runs(Callers::Kind::Cycle) && cycle_.caller.line == line;
    at.context = is_call ? &cycle_.context : nullptr;
}

}  // namespace kadr::interp
