// control_state.h — what a program asks the interpreter while it runs: positions, offsets, feeds.
#pragma once

#include <cstdint>
#include <optional>

#include "nc/language.h"

namespace kadr::interp {

class ControlState {
  public:
    virtual ~ControlState() = default;
    /// A quantity as it is behind the blocks that were pulled so far; mm, deg, mm/min, rpm. An axis
    /// is counted from 1 as the machine has them, or named: −1 for X, −2 for Y … Nothing: the
    /// quantity does not exist for these indices.
    virtual std::optional<double> quantity(nc::Quantity quantity, std::int64_t first,
                                           std::int64_t second) = 0;
    /// Sets the shift of a work offset. False: there is no such offset or axis.
    virtual bool set_work_offset(std::int64_t number, std::int64_t axis, double value,
                                 bool acts_at_once) = 0;
    /// Whether the axis of an index is a length, and how many times the programmed value it is (2
    /// where X is a diameter).
    virtual bool is_length(std::int64_t axis) const = 0;
    virtual double word_factor(std::int64_t axis) const = 0;
    /// Whether the tool stands beside the programmed contour.
    virtual bool is_compensated() const = 0;
    /// Keeps the frames that act, for a program that leaves them as they were.
    virtual void keep_frames() = 0;
    /// Goes back to those that were kept last; `is_wanted` false: only forgets them.
    virtual void restore_frames(bool is_wanted) = 0;
};

}  // namespace kadr::interp
