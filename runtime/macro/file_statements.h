// file_statements.h — statements that write, read and delete files of the control.
#pragma once

#include "macro/control_files.h"
#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramBase;

class FileStatements {
  public:
    /// run  outlives it
    explicit FileStatements(ProgramBase& run) : run_(run) {}

    /// A statement with a file.
    Outcome execute(CompiledLine& line, const nc::ControlStatement& statement);
    /// Whether the program has written or deleted the file of this path; else it is as it was
    /// before.
    bool knows(std::string_view path) const { return files_.knows(name_of(path)); }
    /// … and it is there.
    bool has(std::string_view path) const { return files_.has(name_of(path)); }

  private:
    Outcome read_file(CompiledLine& line, const nc::ControlStatement& statement,
                      const std::string& name, ControlFiles::Error& error);
    std::string name_of(std::string_view path) const;

    ProgramBase& run_;
    ControlFiles files_;
};

}  // namespace kadr::macro
