// spindle_angle.h — where the spindle stands in its revolution: threads begin at its mark.
#pragma once

#include "motion/segment.h"

namespace kadr::motion {

/// Counts the revolutions of the commanded speeds from the start of the program, in the sense in
/// which the spindle turns.
class SpindleAngle {
  public:
    /// The spindle turns while a segment runs. Under a constant cutting speed with the mean of the
    /// speeds at both ends.
    void pass(const Segment& segment);

    /// Time until the spindle stands at an angle.
    ///
    /// mark     of a revolution, any number
    /// speed    rev/s, > 0
    /// returns  s; 0: it is there, but for rounding
    double time_to(double mark, double speed) const;

  private:
    double turned_ = 0;  // of a revolution, 0 … 1
};

}  // namespace kadr::motion
