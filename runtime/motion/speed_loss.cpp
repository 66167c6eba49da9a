#include "motion/speed_loss.h"

namespace kadr::motion {

std::string_view reason_name(LossReason reason) {
    switch (reason) {
        case LossReason::MachineFeed: return "greatest feed of the machine";
        case LossReason::AxisVelocity: return "velocity of an axis";
        case LossReason::Curvature: return "acceleration in the bend";
        case LossReason::CurveJerk: return "jerk in the bend";
        case LossReason::Corner: return "corner";
        case LossReason::Stop: return "stop";
        case LossReason::SlowerPiece: return "slower block beside it";
        case LossReason::Jerk: return "jerk of ramps";
        case LossReason::PulseWindow: return "pulse window";
    }
    return "";
}

}  // namespace kadr::motion
