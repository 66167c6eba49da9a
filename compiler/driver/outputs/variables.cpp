// variables.cpp — `--variables`: the control's variables at the end.
#include "driver/variables.h"

#include "driver/outputs.h"

namespace kadr::driver {

namespace {

class VariablesOutput final : public RunOutput {
  public:
    explicit VariablesOutput(const OutputParts& parts) : file_(parts.file) {}
    Wants wants() const override { return {.in_step = true}; }

    Done follow(Execution& execution) override {
        execution_ = &execution;
        return kDone;
    }
    void finish(const RunFigures&) override {
        file_.write(variables_json(execution_->variables()));
    }

  private:
    Output& file_;
    const Execution* execution_ = nullptr;
};

}  // namespace

std::unique_ptr<RunOutput> make_variables(const OutputParts& parts) {
    return std::make_unique<VariablesOutput>(parts);
}

}  // namespace kadr::driver
