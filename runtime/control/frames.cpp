#include "control/frames.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/assert.h"
#include "control/frame_steps.h"
#include "path/linear.h"

namespace kadr::control {

using path::Frame;
using path::Vec3;

namespace {

Vec3 vector_of(const FrameWords& words) {
    return {words.values[0], words.values[1], words.values[2]};
}

/// The same frame with `center` in the place of the origin.
Frame about(const Vec3& center, const Frame& frame) {
    return path::translation(center) * frame * path::translation(-center);
}

/// Two lengths or directions that frames have worked on count as the same.
constexpr double kSameShape = 1e-9;

}  // namespace

void Frames::select_work_offset(const ControlFrame& offset) {
    work_offset_ = offset;
    update();
}

void Frames::select_bases(const BaseFrames& bases) {
    bases_ = bases;
    base_ = bases.whole();
    update();
}

void Frames::select_inner(const ControlFrame& inner) {
    inner_ = inner;
    update();
}

ControlFrame Frames::programmable() const {
    ControlFrame frame;
    Frame steps;
    for (const Step& step : steps_) steps = steps * step.frame;
    frame.shift = shift_;
    frame.fine = fine_;
    for (std::size_t i = 0; i < 3; ++i) frame.fine[i] += steps.shift[static_cast<Eigen::Index>(i)];
    frame.linear = steps.linear;
    frame.mirrored = mirrored_by_steps();
    return frame;
}

void Frames::set_programmable(const ControlFrame& frame) {
    shift_ = frame.shift;
    fine_ = frame.fine;
    steps_.clear();
    const auto add = [this](Step::Kind kind, const path::Mat3& linear) {
        if (linear != path::Mat3::Identity()) steps_.push_back({kind, {linear, Vec3::Zero()}});
    };
    const path::Mat3 mirror = path::mirroring(frame.mirrored).linear;
    if (const std::optional<FrameParts> parts = parts_of(frame)) {
        add(Step::Kind::Rotation, parts->rotation);
        add(Step::Kind::Scale, parts->scale.asDiagonal());
    } else {
        add(Step::Kind::Rotation, frame.linear * mirror);
    }
    add(Step::Kind::Mirror, mirror);
    update();
}

void Frames::shift(const FrameWords& words) {
    if (!rules_->shift_keeps_unnamed || words.given == 0) shift_ = {};
    if (!rules_->shift_keeps_unnamed) {
        fine_ = {};
        steps_.clear();
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (words.has(i)) shift_[i] = words.values[i];
    }
    update();
}

void Frames::shift_add(const FrameWords& words) {
    const std::size_t added = steps_.empty() ? 0 : 3;  // rotations do not reach other axes
    for (std::size_t i = added; i < kAxes; ++i) fine_[i] += words.values[i];
    if (steps_.empty()) return update();
    append(Step::Kind::Shift, path::translation(vector_of(words)));
}

void Frames::set_coarse(const FrameWords& words) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.has(i)) shift_[i] = words.values[i];
    }
    update();
}

void Frames::set_fine(const FrameWords& words) {
    const AxisValues now = programmable().fine;
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.has(i)) fine_[i] += words.values[i] - now[i];
    }
    update();
}

Vec3 Frames::own_shift() const { return path::linear(shift_) + path::linear(fine_); }

void Frames::set_tables(const Frame& tables) {
    tables_ = tables;
    update();
}

void Frames::set_tilted_plane(const Frame& tilt) {
    tilted_plane_frame_ = tilt;
    update();
}

void Frames::set_tool_frame(const std::optional<Frame>& frame) {
    tool_frame_ = frame.value_or(Frame{});
    has_tool_frame_ = frame.has_value();
    update();
}

Frame Frames::outside_tool_frame() const {
    return path::translation(path::linear(set_shift_)) * base_.whole() * work_offset_.whole();
}

Frame Frames::inside_tool_frame() const {
    Frame frame = tilted_plane_frame_ * path::translation(own_shift());
    for (const Step& step : steps_) frame = frame * step.frame;
    return frame * inner_.whole();
}

void Frames::turn(const path::Mat3& rotation) {
    append(Step::Kind::Rotation, {rotation, Vec3::Zero()});
}

void Frames::rotate(path::Plane plane, double angle, const FrameWords& center) {
    if (rules_->rotate_replaces) erase(Step::Kind::Rotation);
    const Frame rotation = path::rotation_in_plane(plane, angle);
    const auto scale = std::ranges::find(steps_, Step::Kind::Scale, &Step::kind);
    if (!rules_->rotate_outside_scale || scale == steps_.end()) {
        append(Step::Kind::Rotation, about(vector_of(center), rotation));
        return;
    }
    // Points are scaled first, and so is the centre.
    Frame scaled;
    for (auto step = scale; step != steps_.end(); ++step) scaled = scaled * step->frame;
    steps_.insert(scale, {Step::Kind::Rotation, about(scaled(vector_of(center)), rotation)});
    update();
}

void Frames::rotate_off() {
    erase(Step::Kind::Rotation);
    update();
}

void Frames::scale(const Vec3& factors, const FrameWords& center) {
    if (rules_->scale_replaces) erase(Step::Kind::Scale);
    append(Step::Kind::Scale, about(vector_of(center), path::scaling(factors)));
}

void Frames::scale_off() {
    erase(Step::Kind::Scale);
    update();
}

void Frames::mirror(const FrameWords& words) {
    const auto axes = static_cast<AxisMask>(words.given);
    if (rules_->mirror_replaces && axes != 0) erase_mirrors(axes);
    append(Step::Kind::Mirror, about(vector_of(words), path::mirroring(axes)));
}

void Frames::mirror_off(AxisMask axes) {
    erase_mirrors(axes);
    update();
}

void Frames::erase_mirrors(AxisMask axes) {
    for (Step& step : steps_) {
        if (step.kind != Step::Kind::Mirror) continue;
        for (Eigen::Index i = 0; i < 3; ++i) {
            if (axes != 0 && (axes >> i & 1u) == 0) continue;
            step.frame.linear(i, i) = 1;
            step.frame.shift[i] = 0;
        }
    }
    std::erase_if(steps_, [](const Step& step) {
        return step.kind == Step::Kind::Mirror && step.frame.linear == path::Mat3::Identity() &&
               step.frame.shift == Vec3::Zero();
    });
}

void Frames::set_position(const FrameWords& words, const AxisValues& here, const AxisValues& base) {
    AxisValues wanted = here;
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (!words.has(i)) continue;
        wanted[i] = words.values[i];
        // Setting the position of an axis ends its local shift.
        if (rules_->shift_keeps_unnamed) shift_[i] = 0;
    }
    set_shift_ = {};
    update();
    const AxisValues reached = to_base(wanted);
    for (std::size_t i = 0; i < kAxes; ++i) set_shift_[i] = base[i] - reached[i];
    update();
}

void Frames::preset(Axis axis, double by) {
    set_shift_[index(axis)] += by;
    update();
}

void Frames::reset_position(AxisMask axes) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) != 0) set_shift_[i] = shift_[i] = 0;
    }
    update();
}

Frames Frames::machine_frames(std::int64_t keeps) const {
    Frames left(*rules_);
    if (keeps == 0) return left;
    left.set_shift_ = set_shift_;
    left.select_bases(keeps == 1 ? bases_.without_numbered() : bases_);
    return left;
}

void Frames::append(Step::Kind kind, const Frame& frame) {
    if (!steps_.empty() && steps_.back().kind == kind) {
        steps_.back().frame = steps_.back().frame * frame;
    } else {
        steps_.push_back({kind, frame});
    }
    if (steps_.size() > kMaxSteps) {
        steps_[1].frame = steps_[0].frame * steps_[1].frame;
        steps_.erase(steps_.begin());
    }
    update();
}

bool Frames::is_scaled() const {
    return std::ranges::any_of(steps_,
                               [](const Step& step) { return step.kind == Step::Kind::Scale; });
}

double Frames::larger_factor(path::Plane plane) const {
    const path::PlaneAxes axes = path::axes_of(plane);
    return std::max(total_.direction(path::unit(axes.first)).norm(),
                    total_.direction(path::unit(axes.second)).norm());
}

bool Frames::is_rotated() const {
    return std::ranges::any_of(steps_,
                               [](const Step& step) { return step.kind == Step::Kind::Rotation; });
}

AxisMask Frames::mirrored() const {
    return static_cast<AxisMask>(base_.mirrored ^ work_offset_.mirrored ^ mirrored_by_steps() ^
                                 inner_.mirrored);
}

AxisMask Frames::mirrored_by_steps() const {
    AxisMask axes = 0;
    for (const Step& step : steps_) {
        if (step.kind != Step::Kind::Mirror) continue;
        for (unsigned i = 0; i < 3; ++i)
            if (step.frame.linear(i, i) < 0) axes = static_cast<AxisMask>(axes ^ (1u << i));
    }
    return axes;
}

void Frames::erase(Step::Kind kind) {
    std::erase_if(steps_, [kind](const Step& step) { return step.kind == kind; });
}

void Frames::set_table(const Frame& table) {
    table_ = table;
    update();
}

void Frames::release_table() {
    table_.reset();
    update();
}

void Frames::update() {
    const Vec3 own = own_shift();
    is_swivelled_ = !(path::is_nothing(tables_) && path::is_nothing(tilted_plane_frame_) &&
                      path::is_nothing(tool_frame_));
    if (is_swivelled_) {
        total_ = tables_ * outside_tool_frame() * tool_frame_ * tilted_plane_frame_ *
                 path::translation(own);
    } else if (work_offset_.is_shift() && base_.is_shift()) {
        const Vec3 outer =
            work_offset_.whole().shift + path::linear(set_shift_) + base_.whole().shift;
        total_ = path::translation(outer + own);
    } else {
        total_ = path::translation(path::linear(set_shift_)) * base_.whole() *
                 work_offset_.whole() * path::translation(own);
    }
    for (const Step& step : steps_) total_ = total_ * step.frame;
    total_ = total_ * inner_.whole();
    if (table_) total_ = *table_ * total_;
    is_shift_ = total_.linear == path::Mat3::Identity();
    for (std::size_t i = 0; i < 3; ++i)
        shift_values_[i] = total_.shift[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 3; i < kAxes; ++i) {
        shift_values_[i] = work_offset_.shift[i] + work_offset_.fine[i] + set_shift_[i] +
                           base_.shift[i] + base_.fine[i] + shift_[i] + fine_[i] + inner_.shift[i] +
                           inner_.fine[i];
    }
    const Result<Frame, path::FrameFault> back = path::inverse(total_);
    KADR_ASSERT(back, "rotations, mirrors, shifts and scales other than 0 can be undone");
    back_ = *back;
}

bool Frames::is_stretched(path::Plane plane) const {
    if (is_shift_) return false;
    const path::PlaneAxes axes = path::axes_of(plane);
    const Vec3 first = total_.direction(path::unit(axes.first));
    const Vec3 second = total_.direction(path::unit(axes.second));
    const double size = first.squaredNorm();
    return std::abs(size - second.squaredNorm()) > kSameShape * size ||
           std::abs(first.dot(second)) > kSameShape * size;
}

bool Frames::is_mirrored(path::Plane plane) const {
    if (is_shift_) return false;
    const path::PlaneAxes axes = path::axes_of(plane);
    return total_.direction(path::unit(axes.first))
               .cross(total_.direction(path::unit(axes.second)))
               .dot(path::unit(axes.normal)) < 0;
}

bool Frames::is_plane_tilted(path::Plane plane) const {
    if (is_shift_) return false;
    const path::PlaneAxes axes = path::axes_of(plane);
    const Vec3 normal = path::unit(axes.normal);
    const Vec3 first = total_.direction(path::unit(axes.first));
    const Vec3 second = total_.direction(path::unit(axes.second));
    return std::abs(first.dot(normal)) > kSameShape * first.norm() ||
           std::abs(second.dot(normal)) > kSameShape * second.norm();
}

AxisValues Frames::to_base(const AxisValues& programmed) const {
    AxisValues base;
    const Vec3 point = total_(path::linear(programmed));
    for (std::size_t i = 0; i < 3; ++i) base[i] = point[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 3; i < kAxes; ++i) base[i] = programmed[i] + shift_values_[i];
    return base;
}

AxisValues Frames::from_base(const AxisValues& base) const {
    AxisValues programmed;
    const Vec3 point = back_(path::linear(base));
    for (std::size_t i = 0; i < 3; ++i) programmed[i] = point[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 3; i < kAxes; ++i) programmed[i] = base[i] - shift_values_[i];
    return programmed;
}

}  // namespace kadr::control
