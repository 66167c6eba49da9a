#include "interp/work_area.h"

namespace kadr::interp {

namespace {

/// Rounding of the text and of frames: the tip may stand this far behind a limit.
constexpr double kSlack = 1e-6;  // mm

}  // namespace

void WorkArea::set(Axis axis, bool is_upper, double limit) {
    AxisMask& has = is_upper ? has_upper_ : has_lower_;
    has = static_cast<AxisMask>(has | bit(axis));
    (is_upper ? upper_ : lower_)[index(axis)] = limit;
}

std::optional<WorkArea::Excess> WorkArea::excess(const AxisValues& base, AxisMask moved) const {
    if (!is_on_) return std::nullopt;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto axis = static_cast<Axis>(i);
        if ((moved & bit(axis)) == 0) continue;
        if ((has_lower_ & bit(axis)) != 0 && base[i] < lower_[i] - kSlack)
            return Excess{axis, base[i], lower_[i]};
        if ((has_upper_ & bit(axis)) != 0 && base[i] > upper_[i] + kSlack)
            return Excess{axis, base[i], upper_[i]};
    }
    return std::nullopt;
}

}  // namespace kadr::interp
