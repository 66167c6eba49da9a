// inputs.h — the dialects, machines and the library of this tree, shared by the sessions of a test
// program.
#pragma once

#include "base/disk_files.h"
#include "driver/shared_inputs.h"

namespace kadr::test {

inline driver::SharedInputs& inputs() {
    static driver::SharedInputs inputs(disk(), driver::share_below(KADR_ROOT, disk()));
    return inputs;
}

}  // namespace kadr::test
