// program.h — a Kadr program, read, parsed and checked, with everything that it imports.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "driver/modules.h"
#include "driver/session.h"
#include "sema/code.h"

namespace kadr::driver {

struct KadrProgram {
    FileId file;
    std::unique_ptr<Modules> modules;  // the trees that were checked
    std::unique_ptr<sema::Code> code;
};

/// Reads and checks a file of the library, or one that a dialect names, at `location`, and that
/// lies beside it. Nothing, with messages, if it has errors.
std::optional<KadrProgram> load_program(Session& session, const std::string& path,
                                        const std::string& beside,
                                        const SourceRange& location = {});

/// Checks a text that is already among the sources and that the user named: it may read what lies
/// beside it. `keeps_names`: Code::names, for who looks on.
std::optional<KadrProgram> load_program(Session& session, FileId file, bool keeps_names = false);

}  // namespace kadr::driver
