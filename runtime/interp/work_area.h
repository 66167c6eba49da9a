// work_area.h — the limits of the working area, as a program sets them.
#pragma once

#include <optional>

#include "base/axes.h"

namespace kadr::interp {

/// Limits of positions in the base system, where the tool's tip is; S 3.6. Only axes of which a
/// limit was programmed have one.
class WorkArea {
  public:
    /// A position beyond a limit.
    struct Excess {
        Axis axis = Axis::X;
        double at = 0;  // mm
        double limit = 0;
    };

    void set(Axis axis, bool is_upper, double limit);
    void switch_on(bool is_on) { is_on_ = is_on; }
    bool acts() const { return is_on_ && (has_lower_ | has_upper_) != 0; }
    /// The first axis of `moved` that stands beyond a limit; nothing while they do not act.
    std::optional<Excess> excess(const AxisValues& base, AxisMask moved) const;

  private:
    AxisValues lower_{};
    AxisValues upper_{};
    AxisMask has_lower_ = 0;
    AxisMask has_upper_ = 0;
    bool is_on_ = true;
};

}  // namespace kadr::interp
