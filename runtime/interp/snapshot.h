// snapshot.h — what a control's screen shows between two blocks: position, feed, speed, tool.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "path/command.h"

namespace kadr::interp {

struct Snapshot {
    AxisMask axes = 0;     // that the machine has
    AxisValues work{};     // programmed system, mm and deg; X is a diameter where the program's is
    AxisValues machine{};  // machine system, mm and deg
    std::optional<double> feed;  // unit of its mode: mm/min, mm/rev, 1/min
    path::FeedMode feed_mode = path::FeedMode::PerMinute;
    path::SpindleMode spindle = path::SpindleMode::Stop;
    double speed = 0;  // rpm; m/min under constant cutting speed
    bool has_cutting_speed = false;
    std::int64_t master_spindle = 0;  // of a machine with several; else 0
    struct NumberedSpindle {
        std::int64_t number = 0;
        path::SpindleMode mode = path::SpindleMode::Stop;
        double speed = 0;  // as above
    };
    std::vector<NumberedSpindle> spindles;  // all of such a machine, in the order of their numbers
    std::int64_t tool = 0;                  // in the spindle; 0 none
    std::int64_t selected_tool = 0;         // for the next change
    std::int64_t length_offset = 0;         // number of the length offset that acts (H); 0 none
    std::int64_t radius_offset = 0;         // number of the radius offset (D); 0 none
    std::optional<std::int64_t> edge;       // that acts, 0 none; nothing where tools have no edges
    double tool_length = 0;                 // that acts, mm
    std::int64_t work_offset = 0;           // number of the work offset that acts
    path::CoolantMode coolant = path::CoolantMode::Off;
    std::string_view cycle;  // that every block with axis words calls; empty: none
};

}  // namespace kadr::interp
