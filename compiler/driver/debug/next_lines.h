// next_lines.h — which line of ISO-7bit text a Kadr program will make next.
//
// In front of a statement the line does not exist yet: the program is evaluated a second time
// beside the one that runs, a little ahead of it. Nobody sees what that reports.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "driver/generated_text.h"
#include "driver/trace.h"

namespace kadr::driver {

class NextLines {
  public:
    /// All outlive it. `name`: of the text.
    NextLines(Session& session, const KadrProgram& program, const nc::Dialect& dialect,
              std::string name);

    /// A line by its number, from 1; numbers rise from call to call. Nothing: the program makes no
    /// such line, or not soon.
    std::optional<TraceStep> line(std::uint32_t number);

  private:
    bool read_more();

    const KadrProgram& program_;
    std::string name_;
    DiagnosticList silence_;
    GeneratedText text_;
    bool has_started_ = false;
    std::deque<std::string> lines_;
    std::uint32_t first_ = 1;  // number of the first of them
};

}  // namespace kadr::driver
