// support.h — the oracles, and a lathe as the paper on constant cutting speed has it.
#pragma once

#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "base/units.h"
#include "tests/motion/support.h"

namespace kadr::process::test {

using nlohmann::json;

/// By value: a loop over a part of a temporary would outlive it.
inline json oracle(const std::string& name) {
    std::ifstream file(std::string(KADR_ROOT) + "/tests/oracles/" + name);
    return json::parse(file);
}

/// A spindle that holds a cutting speed.
inline motion::CommandedSpindle spindle_of(double speed_m_min, double most_rpm) {
    motion::CommandedSpindle spindle;
    spindle.is_turning = spindle.holds_cutting_speed = true;
    spindle.cutting_speed = feed_from_mm_min(speed_m_min * 1000);
    spindle.limit = speed_from_rpm(most_rpm);
    return spindle;
}

/// Commands that face a disc: spindle on at its limit, rapid to the first radius, the cut.
inline std::vector<path::Command> facing(double speed_m_min, double most_rpm, double from,
                                         double to, double feed_per_revolution) {
    using path::Command;
    Command limit = motion::test::simple(path::Op::SpeedLimit);
    limit.speed_limit().most = most_rpm;
    Command spindle = motion::test::spindle_on(speed_m_min);
    spindle.spindle().has_cutting_speed = true;
    Command cut = motion::test::line_to({to, 0, 0}, feed_per_revolution);
    cut.motion().feed_mode = path::FeedMode::PerRevolution;
    return {motion::test::rapid_to({from, 0, 0}), limit, spindle, cut};
}

}  // namespace kadr::process::test
