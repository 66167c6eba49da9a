// program.h — a Kadr program, read, parsed and checked, with everything that it imports.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "driver/modules.h"
#include "driver/session.h"
#include "sema/code.h"

namespace kadr::driver {

struct Program {
    FileId file;
    std::unique_ptr<Modules> modules;  // the trees that were checked
    std::unique_ptr<sema::Code> code;
};

/// Reads and checks a file, `-` for standard input. Nothing, with messages, if it has errors.
std::optional<Program> load_program(Session& session, const std::string& path);

/// Checks a text that is already among the sources.
std::optional<Program> load_program(Session& session, FileId file);

}  // namespace kadr::driver
