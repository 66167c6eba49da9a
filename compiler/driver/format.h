// format.h — `kadr fmt`: programs in their canonical layout.
#pragma once

#include <span>
#include <string>

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

enum class FormatMode : std::uint8_t {
    Write,  // a file is replaced, whole or not at all; standard input goes to standard output
    Check,  // nothing is written; every file that would change is reported
};

/// Lays out Kadr programs. A file with a syntax error is reported and stays as it was.
Status format(Session& session, std::span<const std::string> sources, FormatMode mode);

}  // namespace kadr::driver
