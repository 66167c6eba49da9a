// setpoints.cpp — `--setpoints`: every axis at every tick.
#include "driver/setpoints.h"

#include "driver/outputs.h"

namespace kadr::driver {

namespace {

class SetpointsOutput final : public RunOutput {
  public:
    explicit SetpointsOutput(const OutputParts& parts) : file_(parts.file) {}
    Wants wants() const override { return {.setpoints = true, .every_tick = true}; }

    Done follow(Execution& execution) override {
        table_ = open_setpoints(execution.machine(), file_);
        return kDone;
    }
    void see_setpoints(std::span<const motion::Setpoint> some) override { table_->write(some); }
    void finish(const RunFigures& figures) override { table_->finish(figures.alarm); }

  private:
    Output& file_;
    std::unique_ptr<SetpointTable> table_;
};

}  // namespace

std::unique_ptr<RunOutput> make_setpoints(const OutputParts& parts) {
    return std::make_unique<SetpointsOutput>(parts);
}

}  // namespace kadr::driver
