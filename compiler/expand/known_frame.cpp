#include "expand/known_frame.h"

namespace kadr::expand {

control::ProgramFrame KnownFrame::made() {
    const auto [frame, fault] = steps_.frame();
    fault_ = fault;
    return frame;
}

}  // namespace kadr::expand
