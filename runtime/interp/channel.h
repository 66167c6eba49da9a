// channel.h — the parts of a channel, as they know each other.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

class Answers;
class BlockFunctions;
class Carriers;
class ContourTables;
class Cornering;
class CycleShapes;
class Cycles;
class DangerWatch;
class Executor;
class FeedWords;
class MotionChecks;
class Motions;
class PathSmoothing;
class ProgrammedFrames;
class RadiusCompensation;
class SmoothApproaches;
class Spindles;
class Splines;
class Stages;
class TiltedPlanes;
class ToolInUse;
class ToolMotion;
class Transformation;
class VirtualPlane;

/// Each part has its own state, and asks the others for what is theirs.
struct Channel {
    ChannelState& state;
    Spindles& spindles;
    FeedWords& feed;
    ProgrammedFrames& frames;
    ToolInUse& tool;
    Transformation& transformation;
    ToolMotion& tool_motion;
    TiltedPlanes& tilted_planes;
    Carriers& carriers;
    VirtualPlane& virtual_plane;
    Cornering& cornering;
    RadiusCompensation& compensation;
    SmoothApproaches& approaches;
    Stages& stages;
    PathSmoothing& smoothing;
    Splines& splines;
    Cycles& cycles;
    CycleShapes& shapes;
    ContourTables& contours;
    Motions& motions;
    MotionChecks& checks;
    DangerWatch& dangers;
    Answers& answers;
    BlockFunctions& functions;
    Executor& executor;
};

}  // namespace kadr::interp
