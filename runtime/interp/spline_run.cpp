#include "interp/spline_run.h"

#include <utility>

namespace kadr::interp {

using path::NurbsFault;

namespace {

constexpr std::size_t kRotary = index(Axis::A);
constexpr std::size_t kParallel = index(Axis::U);

path::Vec3 three_of(const AxisValues& values, std::size_t from) {
    return {values[from], values[from + 1], values[from + 2]};
}

}  // namespace

SplineRun::SplineRun(int degree, bool by_knots)
    : degree_(degree),
      by_knots_(by_knots),
      spans_(degree),
      rotary_(degree),
      parallel_(degree),
      directions_(degree) {
    if (by_knots) return;
    for (int i = 0; i <= degree; ++i) (void)add_to_all(0);  // a clamped begin is never wrong
}

void SplineRun::add_control_point(const path::Vec3& pole, double weight,
                                  const ControlPointBlock& block) {
    if (spans_.control_points() == 0) first_ = block.to;
    for (std::size_t i = 3; i < kAxes; ++i) {
        if (block.to[i] != first_[i]) led_ = static_cast<AxisMask>(led_ | AxisMask{1} << i);
    }
    spans_.add_control_point(pole, weight);
    rotary_.add_control_point(three_of(block.to, kRotary), weight);
    parallel_.add_control_point(three_of(block.to, kParallel), weight);
    turns_ |= direction_ && block.direction && *direction_ != *block.direction;
    direction_ = block.direction;
    directions_.add_control_point(direction_.value_or(path::Vec3::Zero()), weight);
    blocks_.push_back(block);
}

std::optional<NurbsFault> SplineRun::add_to_all(double knot) {
    if (const auto fault = spans_.add_knot(knot)) return fault;
    // The same knots: a fault would have been one of the spans.
    (void)rotary_.add_knot(knot);
    (void)parallel_.add_knot(knot);
    (void)directions_.add_knot(knot);
    return std::nullopt;
}

std::optional<NurbsFault> SplineRun::add_knot(double knot) { return add_to_all(knot); }

std::optional<NurbsFault> SplineRun::add_interval(double interval) {
    if (!(interval >= 0)) return NurbsFault::Decreasing;
    knot_ += interval;
    waiting_.push_back(knot_);
    if (waiting_.size() < static_cast<std::size_t>(degree_)) return std::nullopt;
    known_knot_ = waiting_.front();
    waiting_.pop_front();
    return add_to_all(known_knot_);
}

std::optional<NurbsFault> SplineRun::finish() {
    is_finished_ = true;
    if (spans_.control_points() < static_cast<std::size_t>(degree_) + 1)
        return NurbsFault::ControlPoints;
    if (!by_knots_) {
        // The end is clamped, whatever intervals its last blocks brought.
        waiting_.clear();
        for (int i = 0; i < degree_; ++i) {
            if (const auto fault = add_to_all(known_knot_)) return fault;
        }
    }
    return spans_.end_fault();
}

std::optional<SplineStep> SplineRun::next() {
    while (const auto span = spans_.next()) {
        while (first_block_ < span->last_control_point) {
            blocks_.pop_front();
            ++first_block_;
        }
        SplineStep step{*span, blocks_.front()};
        const path::Vec3 rotary = rotary_.next()->end;  // they have the same spans
        const path::Vec3 parallel = parallel_.next()->end;
        const path::Vec3 direction = directions_.next()->end;
        if (step.block.direction && turns_) step.block.direction = direction;
        for (std::size_t i = 3; i < kAxes; ++i) {
            // An axis that stands must not move by what is rounded.
            const bool is_rotary = i < kParallel;
            const auto k = static_cast<Eigen::Index>(is_rotary ? i - kRotary : i - kParallel);
            const bool is_led = (led_ >> i & 1u) != 0;
            step.block.to[i] = is_led ? (is_rotary ? rotary[k] : parallel[k]) : first_[i];
        }
        auto ready = std::exchange(held_, std::move(step));
        if (ready) return ready;
    }
    if (!is_finished_) return std::nullopt;
    if (held_) {
        held_->is_last = true;
        held_->block.to = blocks_.front().to;  // the last control point, not rounded
        held_->block.direction = blocks_.front().direction;
    }
    return std::exchange(held_, std::nullopt);
}

}  // namespace kadr::interp
