#include "interp/state.h"

namespace kadr::interp {

using nc::Function;
using path::FeedMode;
using path::Plane;

bool Modal::set(Function function) {
    switch (function) {
        case Function::Rapid:
        case Function::Line:
        case Function::ArcCw:
        case Function::ArcCcw:
        case Function::TapIn:
        case Function::TapOut:
        case Function::ArcThrough:
        case Function::ArcTangent:
        case Function::Thread: motion = function; return true;
        case Function::PlaneXy: plane = Plane::Xy; return true;
        case Function::PlaneZx: plane = Plane::Zx; return true;
        case Function::PlaneYz: plane = Plane::Yz; return true;
        case Function::Absolute: is_incremental = false; return true;
        case Function::Incremental: is_incremental = true; return true;
        case Function::FeedPerMinute: feed_mode = FeedMode::PerMinute; return true;
        case Function::FeedPerRevolution: feed_mode = FeedMode::PerRevolution; return true;
        case Function::FeedInverseTime: feed_mode = FeedMode::InverseTime; return true;
        case Function::ExactStop:
        case Function::ContinuousPath:
        case Function::TappingMode:
        case Function::BlendDistance:
        case Function::BlendTolerance:
        case Function::BlendSmooth:
            has_exact_stop = function == Function::ExactStop;
            taps = function == Function::TappingMode;
            blend = blend_of(function);
            return true;
        default: return false;  // not modal, or the state of something else than the block
    }
}

}  // namespace kadr::interp
