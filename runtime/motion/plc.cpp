#include "motion/plc.h"

namespace kadr::motion {

double MachinePlc::acknowledged(const IssuedFunction& function) {
    const machine::MachineFunction* known = machine_.find_function(function.code);
    return function.time + (known != nullptr ? known->takes : 0);
}

}  // namespace kadr::motion
