// call_trail.h — which call of a Kadr program a statement belongs to, beside that of the statement
// before.
#pragma once

#include <span>
#include <vector>

#include "base/source.h"
#include "expand/statement_watch.h"

namespace kadr::driver {

class CallTrail {
  public:
    struct Arrival {
        bool enters_function = false;  // it is the first statement of a call
        /// It is another line than that of the statement before in this call, or the same once
        /// more.
        bool enters_line = false;
    };
    /// `calls`: those that have not returned; `lines`: first and last of the statement.
    Arrival come_to(std::span<const expand::RunningCall> calls, const SourceRange& statement,
                    std::uint64_t line);

  private:
    struct Activation {
        const sema::FunctionCode* function = nullptr;
        std::uint32_t return_to = 0;
        SourceRange statement;
        std::uint64_t line = 0;
    };
    std::vector<Activation> known_;
};

}  // namespace kadr::driver
