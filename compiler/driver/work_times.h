// work_times.h — where the time of a run goes: by tool, and by statement of the program.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "driver/execution.h"
#include "driver/program_locations.h"
#include "driver/session.h"
#include "motion/segment.h"

namespace kadr::driver {

/// What one tool or one statement takes of a run.
struct WorkShare {
    double time = 0;          // s, everything
    double cutting_time = 0;  // s at feed
    double length = 0;        // mm, of the tip, all motion
};

struct ToolShare {
    std::int64_t tool = 0;  // 0: before the first call, or none
    WorkShare share;
    std::string name{};  // of the tool library; empty: it has it not, or there is none
};

struct CycleShare {
    std::string cycle;  // its name in Kadr
    WorkShare share;
};

struct LocationShare {
    std::string place;  // "flange.kadr:41"; of ISO-7bit text file and line
    std::string text;   // the statement, its first line; empty for ISO-7bit text
    WorkShare share;
};

/// Adds up planned motion. What the library moves counts for the statement that called it.
///
/// Memory is bounded: of very many statements those are forgotten that have taken least so far.
class WorkTimes {
  public:
    /// Both outlive this.
    WorkTimes(const Execution& execution, const Session& session)
        : execution_(execution), locations_(execution, session) {}

    /// A piece of motion; pieces come in the order of the run.
    void add(const motion::Segment& segment);

    /// In the order in which they were called first; a tool that is called again has one row.
    std::vector<ToolShare> tools() const;
    /// Of the cycles that the control runs, what they move themselves: the travel to their
    /// positions is not theirs. The longest first.
    std::vector<CycleShare> cycles() const;
    /// The longest first.
    std::vector<LocationShare> longest(std::size_t most) const;

  private:
    struct Row {
        ProgramLocation location;
        WorkShare share;
    };

    WorkShare& share_of(const motion::Segment& segment);
    std::uint64_t key_of(const ProgramLocation& location);
    void take_tool(std::int64_t tool);
    void forget_least();
    LocationShare shown(const Row& row) const;

    const Execution& execution_;
    ProgramLocations locations_;
    std::vector<ToolShare> tools_ = {{}};
    std::size_t tool_at_ = 0;
    std::vector<WorkShare> cycles_;  // by Segment::cycle
    // Keys of lines and statements that follow one another do so too: flat text fills the table
    // from one end to the other.
    std::unordered_map<std::uint64_t, Row> rows_;
    std::unordered_map<std::string, std::uint64_t> called_;  // keys of lines of called programs
    // Of the piece added last; nearly every motion comes as several.
    Row* last_ = nullptr;
    std::uint32_t last_line_ = 0;
    SourceId last_source_;
};

}  // namespace kadr::driver
