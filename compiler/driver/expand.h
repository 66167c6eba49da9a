// expand.h — `kadr expand`: a Kadr program as ISO-7bit text.
#pragma once

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

/// Writes the text, and the source map if one is asked for. Nothing is touched if there is an
/// error.
Status expand(Session& session, const ExpandJob& job);

}  // namespace kadr::driver
