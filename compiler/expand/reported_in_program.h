// reported_in_program.h — what is reported once in a program. For the room expand only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/reported_once.h"

namespace kadr::expand {

/// What is reported once, or once more when it is renewed.
enum class ProgramNotice : std::uint8_t {
    AfterEnd,  // blocks behind M30; anew behind another one
    Diameter,  // a lathe's X is not programmed as one
    Feed,      // none was ever set
    NoTool,    // none was ever called
    Plane,     // the tool's length turns with it
    Rapid,     // into the work, while the spindle stands
    SpindleInDoubt,
    SpindleStopped,
};

class ReportedInProgram : public ReportedOnce<ProgramNotice> {
  public:
    /// The spindle was switched: what was reported of it is reported anew.
    void renew_spindle() {
        renew(ProgramNotice::SpindleStopped);
        renew(ProgramNotice::Rapid);
    }
};

/// What is reported once at a location of the program, until it is reported at another.
enum class NoticeAt : std::uint8_t {
    Spline,     // the control has none
    Tap,        // the control has cycles, but none that taps as the call wants
    Tolerance,  // the control's increments do not let a curve keep it
};

class ReportedAt {
  public:
    /// Whether it is to be reported there: from here on it counts as reported.
    [[nodiscard]] bool first_time(NoticeAt what, std::uint32_t at) {
        return std::exchange(places_[static_cast<std::size_t>(what)], at) != at;
    }

  private:
    std::array<std::uint32_t, 3> places_{};  // for each NoticeAt
};

}  // namespace kadr::expand
