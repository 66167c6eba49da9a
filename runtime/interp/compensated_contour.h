// compensated_contour.h — the elements of a contour that wait until the corners at their ends are
// known, with the commands that stand between them.
//
// What a corner becomes is path/radius_comp.h; how a piece becomes a command, cutter_path.h.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "interp/cutter_path.h"
#include "path/command.h"
#include "path/radius_comp.h"

namespace kadr::interp {

/// How the contour ends: on its normal, but …
struct ContourEnd {
    std::optional<path::Vec2> direction;  // where the contour meets the path beside a line into it
    bool is_open = false;  // its last element may be left out, by the rules of the corners
    /// How far the contour is led beside what is programmed; without an element the approach goes
    /// where it is programmed.
    path::Vec2 aside = path::Vec2::Zero();
};

/// Commands and elements are in the system of the plane of the cutter's path.
class CompensatedContour {
  public:
    struct Last {
        path::Element element;
        double distance = 0;  // how far the cutter's centre goes beside its end, mm
    };

    /// The contour begins anew behind what waits.
    void restart(const path::CompRules& rules);
    void set_rules(const path::CompRules& rules) { corners_.set_rules(rules); }
    /// The corner in front of the next element gets an arc about it.
    void round_next_corner() { corners_.round_next_corner(); }

    /// The last element; none before the first one.
    const std::optional<Last>& last() const { return last_; }
    /// Its command, if it waits still.
    const path::Command* command_of_last() const;
    /// The command of the last element, which waits, ends there and not beside the contour.
    void end_last_at(const AxisValues& programmed);

    /// The path to the contour waits for its first element.
    void wait_for_first(path::Command approach);
    /// It is no element: the caller leads it to the contour.
    CutterMotion take_approach();
    /// It is treated as an element that goes so.
    std::optional<path::CompFault> push_approach(const path::Element& way, double distance);
    /// It ends where the first piece will begin, by the rules' open end.
    void open_approach();

    /// A command without motion in the plane.
    void wait(path::Command command);
    /// The next element.
    ///
    /// distance  of the cutter's centre at its end, mm, positive left of the contour
    std::optional<path::CompFault> push(const path::Element& element, double distance,
                                        CutterMotion motion);
    /// What is settled goes to the cutter's path.
    void release(CutterPath& cutter);
    /// All that waits goes there: no further element comes. `restart` follows, if there is no
    /// fault.
    std::optional<path::CompFault> finish(const ContourEnd& end, CutterPath& cutter);

    /// The command of the element that the last fault is about; null: it does not wait.
    const path::Command* at_fault() const { return command_of(corners_.fault_at()); }
    /// The last command that waits; null: none does.
    const path::Command* newest() const;
    /// Calls `see` for every command that waits, in order.
    template <typename See>
    void look_at_waiting(See see) const {
        for (const Waiting& waiting : waiting_) see(waiting.motion.command);
    }

  private:
    struct Waiting {
        CutterMotion motion;
        std::size_t element = 0;  // its number; 0: no motion in the plane
    };
    const path::Command* command_of(std::size_t element) const;
    void put_piece(const path::CompPiece& piece, CutterPath& cutter);
    void put_open_approach(const path::Vec2& to, CutterPath& cutter);

    path::RadiusComp corners_{{}};
    std::size_t elements_ = 0;  // so many have come, approaches included
    std::optional<Last> last_;
    std::optional<CutterMotion> open_approach_;
    std::deque<Waiting> waiting_;
};

}  // namespace kadr::interp
