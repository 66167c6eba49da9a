#include "interp/state.h"

namespace kadr::interp {

using nc::Function;
using path::FeedMode;
using path::Plane;

void Modal::set(Function function) {
    switch (function) {
        case Function::Rapid:
        case Function::Line:
        case Function::ArcCw:
        case Function::ArcCcw:
        case Function::TapIn:
        case Function::TapOut:
        case Function::ArcThrough:
        case Function::ArcTangent:
        case Function::Thread: motion = function; return;
        case Function::PlaneXy: plane = Plane::Xy; return;
        case Function::PlaneZx: plane = Plane::Zx; return;
        case Function::PlaneYz: plane = Plane::Yz; return;
        case Function::Absolute: is_incremental = false; return;
        case Function::Incremental: is_incremental = true; return;
        case Function::FeedPerMinute: feed_mode = FeedMode::PerMinute; return;
        case Function::FeedPerRevolution: feed_mode = FeedMode::PerRevolution; return;
        case Function::FeedInverseTime: feed_mode = FeedMode::InverseTime; return;
        case Function::ExactStop:
        case Function::ContinuousPath:
        case Function::TappingMode:
        case Function::BlendDistance:
        case Function::BlendTolerance:
        case Function::BlendSmooth:
            has_exact_stop = function == Function::ExactStop;
            taps = function == Function::TappingMode;
            blend = blend_of(function);
            return;
        default: return;  // the motions of curves begin in their own files
    }
}

}  // namespace kadr::interp
