#include "motion/plc_handshake.h"

#include <algorithm>

namespace kadr::motion {

void PlcHandshake::begin(Piece& piece, std::deque<IssuedFunction>& issued, double time) {
    Plc& plc = plc_ != nullptr ? *plc_ : machine_plc_;
    for (; piece.issues > 0; --piece.issues) {
        IssuedFunction function = issued.front();
        issued.pop_front();
        function.time = time;
        acknowledged_ = std::max({acknowledged_, time, plc.acknowledged(function)});
    }
    if (piece.awaits) piece.segment.duration = std::max(0.0, acknowledged_ - time);
}

}  // namespace kadr::motion
