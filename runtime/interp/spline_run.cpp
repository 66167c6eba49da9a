#include "interp/spline_run.h"

#include <utility>

namespace kadr::interp {

using path::NurbsFault;

SplineRun::SplineRun(int degree, bool by_knots)
    : degree_(degree), by_knots_(by_knots), spans_(degree) {
    if (by_knots) return;
    for (int i = 0; i <= degree; ++i) (void)spans_.add_knot(0);
}

void SplineRun::add_pole(const path::Vec3& pole, double weight, const PoleBlock& block) {
    spans_.add_pole(pole, weight);
    blocks_.push_back(block);
}

std::optional<NurbsFault> SplineRun::add_knot(double knot) { return spans_.add_knot(knot); }

std::optional<NurbsFault> SplineRun::add_interval(double interval) {
    if (!(interval >= 0)) return NurbsFault::Decreasing;
    knot_ += interval;
    waiting_.push_back(knot_);
    if (waiting_.size() < static_cast<std::size_t>(degree_)) return std::nullopt;
    known_knot_ = waiting_.front();
    waiting_.pop_front();
    return spans_.add_knot(known_knot_);
}

std::optional<NurbsFault> SplineRun::finish() {
    is_finished_ = true;
    if (spans_.poles() < static_cast<std::size_t>(degree_) + 1) return NurbsFault::Poles;
    if (!by_knots_) {
        // The end is clamped, whatever intervals its last blocks brought.
        waiting_.clear();
        for (int i = 0; i < degree_; ++i) {
            if (const auto fault = spans_.add_knot(known_knot_)) return fault;
        }
    }
    return spans_.end_fault();
}

std::optional<SplineStep> SplineRun::next() {
    while (const auto span = spans_.next()) {
        while (first_block_ < span->last_pole) {
            blocks_.pop_front();
            ++first_block_;
        }
        auto ready = std::exchange(held_, SplineStep{*span, blocks_.front()});
        if (ready) return ready;
    }
    if (!is_finished_) return std::nullopt;
    if (held_) held_->is_last = true;
    return std::exchange(held_, std::nullopt);
}

}  // namespace kadr::interp
