// inputs.h — the dialects, machines and the library of this tree, shared by the sessions of a test
// program.
#pragma once

#include "base/disk_files.h"
#include "driver/session.h"

namespace kadr::test {

inline driver::SharedInputs& inputs() {
    static driver::SharedInputs inputs(disk(), driver::share_below(KADR_ROOT, disk()));
    return inputs;
}

/// One session for a whole test program, which may read what lies in `folder` as well; its messages
/// are nobody's.
inline driver::Session& quiet_session(const std::string& folder = {}) {
    static Sources sources = inputs().new_sources();
    static driver::Messages messages(sources, {}, [](std::string_view) {});
    static driver::Session session({}, inputs(), sources, messages);
    if (!folder.empty()) session.access().allow(folder);
    return session;
}

}  // namespace kadr::test
