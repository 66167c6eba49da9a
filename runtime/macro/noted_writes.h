// noted_writes.h — what the program writes into the control, for who looks on: tool data,
// offsets, frames, timers, before and behind the write.
#pragma once

#include "macro/control_variables.h"
#include "macro/evaluator.h"
#include "macro/program_units.h"

namespace kadr::macro {

class NotedWrites {
  public:
    /// References outlive it.
    NotedWrites(ControlVariables& variables, const Evaluator& evaluator,
                const nc::Language& language)
        : variables_(variables), evaluator_(evaluator), language_(language) {}

    /// Keeps the data that the block may write, as they are before it.
    void note_data(const nc::Block& block);
    /// Whether `report_data` has something to report, when the block is executed.
    bool has_data() const { return !data_.empty(); }
    /// What has become of them.
    void report_data();
    /// Writes a variable.
    VariableFault store(const CompiledLine& line, const nc::Reference& reference,
                        std::span<const std::int64_t> indices, const ControlValue& value);

  private:
    struct WrittenOffset {
        bool is_of_tool = false;
        std::int64_t number = 0;
    };

    ControlVariables& variables_;
    const Evaluator& evaluator_;
    const nc::Language& language_;
    std::vector<ControlVariable> data_;  // that the last block may write, before it
    WrittenOffset owner_;                // … and whose they are
};

}  // namespace kadr::macro
