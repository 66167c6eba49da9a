// compressor.h — short lines that follow each other become cubic spans within a tolerance.
//
// Commands in, commands out: what comes out is planned as any other spline. Works while the
// commands come; a run of any length takes the memory of one window. A tolerance of corner blending
// is less by what a curve has used of it: both leave the programmed path.
#pragma once

#include <cstddef>
#include <vector>

#include "motion/standing.h"
#include "path/command.h"
#include "path/polyline_fit.h"

namespace kadr::motion {

class Compressor {
  public:
    /// Whether a command may be part of a run: a line at feed of X, Y and Z for which the program
    /// gives a tolerance, and no varying feed.
    static bool can_take(const path::Command& command) {
        if (!command.is_motion() || !(command.motion().compress > 0)) return false;
        const Boxed<path::Dynamics>& dynamics = command.motion().dynamics;
        return !dynamics || !dynamics->law.is_given();
    }
    /// No line waits and no command is ready.
    bool is_empty() const { return lines_.empty() && next_ == ready_.size(); }

    /// Takes a command when none is ready. A line joins the run; any other command, a corner of
    /// more than 30 degrees, another feed, an exact stop or a line of more than 20 mm ends it.
    /// `standing`: where all commands end that have come out.
    void take(const path::Command& command, const AxesPosition& standing);
    /// No more commands come.
    void finish();

    /// The next command; nullptr if none is ready. Valid until the next call of `take` or `finish`.
    const path::Command* next() { return next_ < ready_.size() ? &ready_[next_++] : nullptr; }

  private:
    bool joins(const path::Command& command, const path::Vec3& to) const;
    path::Vec3 point_of(const path::Motion& motion) const;
    void fit(bool is_whole);
    void put_line(std::size_t at) { ready_.push_back(lines_[at]); }
    void put(const path::PolylinePart& part);
    void end_run();

    std::vector<path::Command> lines_;  // of the run; the i-th leads to points_[i + 1]
    std::vector<path::Vec3> points_;
    path::Vec3 slope_ = path::Vec3::Zero();  // in the first point, if a span has led there
    bool has_slope_ = false;
    std::vector<path::Command> ready_;
    std::size_t next_ = 0;
};

}  // namespace kadr::motion
