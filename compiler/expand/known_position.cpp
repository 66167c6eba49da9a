#include "expand/known_position.h"

#include <cmath>

namespace kadr::expand {

void KnownPosition::restate(std::size_t axis, double value, bool is_known) {
    value_[axis] = value;
    const auto bit = static_cast<AxisMask>(1u << axis);
    known_ = static_cast<AxisMask>(is_known ? known_ | bit : known_ & ~bit);
}

void KnownPosition::note_loss(AxisMask before, SourceId by, Loss how) {
    if ((before & ~known_) == 0) return;
    for (std::size_t i = 0; i < kAxes; ++i)
        if (((before & ~known_) >> i & 1u) != 0) lost_by_[i] = {by, how};
}

void KnownPosition::join(const KnownPosition& other) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        const bool is_same = other.knows(i) && value_[i] == other.value_[i];
        if (!is_same) lose(static_cast<AxisMask>(1u << i));
    }
    is_turned_ |= other.is_turned_;
}

void Drift::add(std::size_t axis, double distance) {
    constexpr double kRounding = 1e-9;  // mm: what a frame and its end leave of a coordinate
    const auto bit = static_cast<AxisMask>(1u << axis);
    by[axis] += distance;
    if (std::fabs(by[axis]) < kRounding) by[axis] = 0;
    has = static_cast<AxisMask>(by[axis] != 0 ? has | bit : has & ~bit);
}

void Drift::forget(AxisMask axes) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) != 0) by[i] = 0;
    }
    has &= static_cast<AxisMask>(~axes);
    lost &= static_cast<AxisMask>(~axes);
}

void Drifts::add(std::size_t axis, double distance) {
    of_program_.add(axis, distance);
    of_text_.add(axis, distance);
}

void Drifts::forget(AxisMask axes) {
    of_program_.forget(axes);
    of_text_.forget(axes);
    unplaced_ &= static_cast<AxisMask>(~axes);
}

void Drifts::lose(AxisMask axes) {
    of_program_.lose(axes);
    of_text_.lose(axes);
}

void Drifts::lose_some(AxisMask axes) {
    of_program_.lose_some(axes);
    of_text_.lose_some(axes);
}

void Drifts::take_named(AxisMask named, AxisMask programmed, bool may_be_left_out) {
    if (may_be_left_out) {
        of_program_.lose_some(programmed);
        of_text_.lose_some(named);
        return;
    }
    of_program_.forget(programmed);
    of_text_.forget(named);
    unplaced_ &= static_cast<AxisMask>(~named);
}

}  // namespace kadr::expand
