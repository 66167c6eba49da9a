// reported_in_run.h — what a run reports once and not again. Internal to interp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/reported_once.h"

namespace kadr::interp {

/// What is reported once, or once more when it is renewed.
enum class RunNotice : std::uint8_t {
    ArcIsLine,
    DiameterOnMill,  // a program that turns runs on a mill
    LifeData,
    Measure,
    NoTool,
    Preset,
    Rapid,       // into the work, while the spindle stands
    SpeedLimit,  // none holds the spindle
    Spin,        // rotation about the tool axis means nothing
    SpindleStopped,
    ThreadSpeed,
    TiltTurned,
    ToolShape,  // that face milling compensation does not know
    Touch,
    TurnedEdge,  // the spindle stops in a cycle whose plane is turned
    Units,
    WorkOffset,  // none is programmed behind a transformation
};

/// What is reported once of each number.
enum class NoticeEach : std::uint8_t {
    Tool,    // that nobody knows
    Edge,    // … of their edges
    Radius,  // offset without one
    OtherToolsRadius,
    MachineFunction,  // that means nothing here
    Parameter,        // … of the control
};

class ReportedInRun : public ReportedOnce<RunNotice> {
  public:
    using ReportedOnce::count_as_reported;
    using ReportedOnce::first_time;
    using ReportedOnce::has_reported;

    bool has_reported(NoticeEach what, std::int64_t number) const;
    void count_as_reported(NoticeEach what, std::int64_t number);
    /// Whether it is to be reported for this number: from here on it counts as reported.
    [[nodiscard]] bool first_time(NoticeEach what, std::int64_t number);
    /// … of a name that several tools have.
    [[nodiscard]] bool first_time_of_name(const std::string& name);
    /// … of a feed. What a program repeats is reported, not all that it may have.
    [[nodiscard]] bool first_time_of_feed(double feed);
    /// … of a speed that is beyond a bound of the spindle, if the latest one was another.
    [[nodiscard]] bool first_time_of_bound(double speed) { return exchange_bound(speed) != speed; }

    /// What was reported for a standing spindle is reported anew when it stands again.
    void renew_spindle() {
        renew(RunNotice::SpindleStopped);
        renew(RunNotice::Rapid);
    }
    /// The speed counts as the latest one that was commanded; returns the one before.
    double exchange_bound(double speed) {
        const double before = bound_;
        bound_ = speed;
        return before;
    }

  private:
    std::array<std::vector<std::int64_t>, 6> numbers_;  // a list for each NoticeEach
    std::vector<std::string> shared_names_;
    std::vector<double> feeds_;
    double bound_ = 0;
};

}  // namespace kadr::interp
