// control_access.h — what a program asks the control while it runs, and sets in it: positions,
// offsets, feeds, frames.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "control/control_frame.h"
#include "macro/contour_table.h"
#include "nc/language.h"

namespace kadr::macro {

class ControlAccess {
  public:
    virtual ~ControlAccess() = default;
    /// A system variable as it is behind the blocks that were pulled so far; mm, deg, mm/min, rpm.
    /// An axis is counted from 1 as the machine has them, or named: −1 for X, −2 for Y … Nothing:
    /// the variable does not exist for these indices.
    virtual std::optional<double> quantity(nc::SystemQuantity quantity, std::int64_t first,
                                           std::int64_t second) = 0;
    /// What became of a system variable that was to be set.
    enum class Write : std::uint8_t {
        Done,
        NoSuchEntry,  // there is no such offset or axis
        TooLarge,     // the control does not take this value
        Refused,      // nobody can set this system variable
    };
    /// How long the program has run, s, as far as it is known now; an open spline stays open.
    virtual double elapsed() = 0;
    /// Sets a system variable, in the units of `quantity`. A work offset acts from the next block
    /// on if it `acts_at_once`, else when it is called next.
    virtual Write set_quantity(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                               double value, bool acts_at_once) = 0;
    /// A frame as it is behind them; nothing: there is none with this number.
    virtual std::optional<control::ControlFrame> frame(nc::SystemQuantity quantity,
                                                       std::int64_t number) = 0;
    /// Sets it. A settable frame acts at once, if `acts_at_once` and it is the one that acts, or
    /// when it is called next; the others act from the next block on.
    virtual Write set_frame(nc::SystemQuantity quantity, std::int64_t number,
                            const control::ControlFrame& frame, bool acts_at_once) = 0;
    /// A system variable that is a text; nothing: as above.
    virtual std::optional<std::string> text(nc::SystemQuantity quantity, std::int64_t index) = 0;
    /// Sets it.
    virtual Write set_text(nc::SystemQuantity quantity, std::int64_t index,
                           std::string_view text) = 0;
    /// Which of the machine's axes it is, counted from 1; nothing: the machine has none such.
    virtual std::optional<std::int64_t> axis_number(Axis axis) const = 0;
    /// Whether the machine has a spindle with this number; 0 is the master.
    virtual bool has_spindle(std::int64_t number) const = 0;
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
    /// From here on blocks are read as a contour, and no axis moves. Empty; else what acts, under
    /// which there is no contour.
    virtual std::string_view begin_contour() = 0;
    /// Ends that: the control is where it was. Nothing: what is wrong was reported.
    virtual std::optional<ContourElements> end_contour() = 0;
    /// Whether the tool stands at a position of a pattern, where a program is to be called.
    virtual bool is_at_pattern_position() const = 0;
    /// Behind the block that is next the tool goes on to the next position.
    virtual void leave_pattern_position() = 0;
    /// … to none: the program goes elsewhere.
    virtual void leave_pattern() = 0;
};

}  // namespace kadr::macro
