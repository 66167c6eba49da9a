// program_files.h — programs of a control in files: found in folders by the names that the dialect
// gives them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/done.h"
#include "driver/session.h"
#include "macro/program_files.h"

namespace kadr::driver {

class ProgramFolders final : public macro::ProgramFiles {
  public:
    /// folders  in the order in which they are searched
    /// session  knows what may be read, and notes what was
    ProgramFolders(std::vector<std::string> folders, Session& session)
        : session_(session), folders_(std::move(folders)) {}

    std::optional<File> open(const nc::Dialect& dialect, const std::string& program,
                             const std::string& kind) override;
    std::vector<std::string> names(const nc::Dialect& dialect) override;

  private:
    const std::vector<std::string>& names_in(const std::string& folder);

    Done require_readable(const std::string& file);

    Session& session_;
    std::vector<std::string> folders_;
    std::map<std::string, std::vector<std::string>> names_;  // of files, by folder
};

}  // namespace kadr::driver
