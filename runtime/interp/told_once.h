// told_once.h — what a run tells once and not again. Internal to interp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kadr::interp {

/// What has been told, or need not be told any more.
struct ToldOnce {
    bool spin = false;   // that a turn about the tool means nothing
    bool shape = false;  // … the shape of a tool for faces
    bool spindle_stopped = false;
    bool rapid = false;  // a rapid into the work
    bool arc_is_line = false;
    bool thread_speed = false;
    bool turned_edge = false;  // the spindle stops in a cycle whose plane is turned
    double bound = 0;          // speed of the spindle that is beyond one
    bool no_tool = false;      // … or one was called
    bool units = false;
    bool preset = false;
    bool measure = false;
    bool touch = false;
    bool life = false;                            // data of tool life
    std::vector<std::int64_t> tools;              // that nobody knows
    std::vector<std::int64_t> edges;              // … of their edges
    std::vector<std::string> shared_names;        // of several tools
    std::vector<std::int64_t> radii;              // offsets without one
    std::vector<std::int64_t> machine_functions;  // M functions that mean nothing here
    std::vector<std::int64_t> parameters;         // … of the control
};

}  // namespace kadr::interp
