// program_files.h — where programs come from that do not stand in the text which runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nc/reader.h"

namespace kadr::macro {

class ProgramFiles {
  public:
    struct File {
        std::string name;  // for messages
        std::unique_ptr<nc::TextSource> text;
    };
    virtual ~ProgramFiles() = default;
    /// The names of all of them that the dialect's programs can call, each once.
    virtual std::vector<std::string> names(const nc::Dialect& dialect) {
        static_cast<void>(dialect);
        return {};
    }
    /// The file of the program with this name (a number without leading zeros), which can be read
    /// again from any position. Nothing: there is none.
    ///
    /// kind  of the program (nc::kind_of); empty: any, in the order in which the control looks
    virtual std::optional<File> open(const nc::Dialect& dialect, const std::string& program,
                                     const std::string& kind) = 0;
};

}  // namespace kadr::macro
