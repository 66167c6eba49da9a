// limit_report.h — what kept the motion below its feed, and what that cost: by reason, by tool and
// by statement.
#pragma once

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

#include "driver/output.h"
#include "driver/program_locations.h"
#include "motion/segment.h"
#include "motion/speed_loss.h"
#include "path/command.h"

namespace kadr::driver {

/// What a location, a tool or the whole run takes, and what of it no feed has asked for.
struct LimitShare {
    double time = 0;                                  // s, of motion
    std::array<double, motion::kLossReasons> lost{};  // s, in the order of LossReason
    double all_lost() const;
};

class LimitReport {
  public:
    /// Both outlive this.
    ///
    /// has_pulses  what pieces take longer than planned is the pulses'
    LimitReport(const Execution& execution, const Session& session, bool has_pulses)
        : locations_(execution, session), has_pulses_(has_pulses) {}

    /// A command on its way to the planner.
    void see(const path::Command& command);
    /// What the planner reports. Before the piece comes to `add`, or behind it.
    void lose(const motion::SpeedLoss& loss);
    /// A planned piece; pieces come in the order of the commands.
    void add(const motion::Segment& segment);

    /// Rows of a table if the output's name ends in `.csv`, else a report to be read.
    ///
    /// source  what was run, as the report names it
    /// alarm   what ended the run before its end; empty: nothing did
    void write(Output& out, const std::string& source, const std::string& alarm);

  private:
    struct Row {
        ProgramLocation location;
        LimitShare share;
    };
    /// From a time on, s.
    struct ToolTime {
        double from = 0;
        std::int64_t tool = 0;
    };

    LimitShare& share_at(std::uint32_t line, SourceId source);
    LimitShare& share_of_tool(double time);
    void settle_until(double time);
    void forget_least();
    std::vector<const Row*> costly() const;
    std::string report(const std::string& source) const;
    std::string table() const;

    ProgramLocations locations_;
    bool has_pulses_;
    LimitShare all_;
    std::unordered_map<std::string, Row> rows_;
    std::vector<std::int64_t> calls_;  // of tools, that are not planned yet
    std::vector<ToolTime> tool_times_ = {{}};
    std::vector<std::pair<std::int64_t, LimitShare>> tools_;
    std::vector<motion::SpeedLoss> waiting_;  // reported before their pieces came
};

}  // namespace kadr::driver
