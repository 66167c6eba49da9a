#include "driver/debug/steps.h"

#include <algorithm>
#include <utility>

namespace kadr::driver {

namespace {

bool is_same_value(const macro::ControlVariable& a, const macro::ControlVariable& b) {
    return a.kind == b.kind && a.number == b.number && a.text == b.text;
}

/// Each variable once, from its first value in the block to its last; without those that have it
/// back.
std::vector<macro::VariableChange> summed_up(std::vector<macro::VariableChange>& changes) {
    std::vector<macro::VariableChange> sum;
    for (macro::VariableChange& change : changes) {
        const auto known = std::find_if(sum.begin(), sum.end(), [&](const auto& other) {
            return other.after.name == change.after.name;
        });
        if (known == sum.end()) {
            sum.push_back(std::move(change));
        } else {
            known->after = std::move(change.after);
        }
    }
    sum.erase(std::remove_if(
                  sum.begin(), sum.end(),
                  [](const auto& change) { return is_same_value(change.before, change.after); }),
              sum.end());
    changes.clear();
    return sum;
}

}  // namespace

TraceState state_of(Execution& execution) {
    TraceState state;
    state.now = execution.interpreter().snapshot();
    state.codes = execution.reader().codes();
    state.modal = modal_entries(state.now);
    return state;
}

void Steps::find_statement(TraceStep& step) const {
    const GeneratedText* generated = execution_->generated();
    if (generated == nullptr) return;
    const auto line = static_cast<std::uint32_t>(step.line);
    step.statement = execution_->statement(generated->lines().find(line));
    const expand::BlockOrigin* calls = generated->calls_behind(line);
    step.has_calls = calls != nullptr;
    if (step.has_calls) step.calls = *calls;
}

void Steps::show_beginning() {
    if (look_ && !has_begun_) {
        TraceStep begin;
        begin.file = execution_->text_name();
        look_(begin, state_of(*execution_));
    }
    has_begun_ = true;
}

const TraceStep& Steps::begin(const macro::WatchedLine& line) {
    end();
    show_beginning();
    TraceStep& step = step_.emplace();
    step.file = line.file.empty() ? execution_->text_name() : std::string(line.file);
    step.line = line.line;
    step.number = line.number;
    step.program = line.program;
    step.level = line.level;
    step.text = line.text;
    if (line.file.empty()) find_statement(step);
    changes_.clear();
    blocks_before_ = execution_->blocks();
    statements_before_ = execution_->reader().statements();
    return step;
}

void Steps::end() {
    if (!step_) return;
    const bool was_executed = execution_->blocks() != blocks_before_ ||
                              execution_->reader().statements() != statements_before_;
    if (look_ && was_executed) {
        step_->block = ++traced_;
        step_->variables = summed_up(changes_);
        look_(*step_, state_of(*execution_));
    }
    step_.reset();
}

}  // namespace kadr::driver
