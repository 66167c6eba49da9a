// command_list.h — what was executed, as JSON Lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "driver/execution.h"
#include "driver/output.h"
#include "interp/listing.h"

namespace kadr::driver {

class CommandList {
  public:
    /// References outlive the list.
    CommandList(const Execution& execution, const Session& session, Output& out);

    void write(const path::Command& command);
    /// The last line of a list that is not complete: `{"op":"alarm","text":…}`.
    void write_alarm(std::string_view text);

  private:
    const std::string& source_of(const path::Command& command);

    const Execution& execution_;
    const Session& session_;
    Output& out_;
    interp::Listing listing_;
    std::vector<std::string> names_;  // of statements, by SourceId; empty: not asked for yet
    std::string line_;
    path::Command called_;  // with the number of its line in its own file
};

}  // namespace kadr::driver
