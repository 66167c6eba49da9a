// check.h — `kadr check`: find mistakes, write nothing.
#pragma once

#include <span>
#include <string>

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

/// Checks Kadr programs; reads and interprets ISO-7bit texts, without motion. An alarm counts as a
/// mistake of the program here.
Status check(Session& session, std::span<const std::string> sources);

}  // namespace kadr::driver
