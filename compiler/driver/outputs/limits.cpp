// limits.cpp — `--limits`: what keeps the motion below its feed.
#include "driver/limit_report.h"
#include "driver/outputs.h"

namespace kadr::driver {

namespace {

class LimitsOutput final : public RunOutput {
  public:
    explicit LimitsOutput(const OutputParts& parts) : session_(parts.session), file_(parts.file) {}
    Wants wants() const override {
        return {.commands = true, .segments = true, .speed_losses = true, .calls = true};
    }

    Done follow(Execution& execution) override {
        const auto& laser = execution.machine().laser;
        report_.emplace(execution, session_, laser && laser->pulse > 0);
        return kDone;
    }
    void see_command(const path::Command& command) override { report_->see(command); }
    void see_segment(const motion::Segment& segment) override { report_->add(segment); }
    void see_speed_loss(const motion::SpeedLoss& loss) override { report_->lose(loss); }
    void finish(const RunFigures& figures) override {
        report_->write(file_, figures.source, figures.alarm);
    }

  private:
    const Session& session_;
    Output& file_;
    std::optional<LimitReport> report_;
};

}  // namespace

std::unique_ptr<RunOutput> make_limits(const OutputParts& parts) {
    return std::make_unique<LimitsOutput>(parts);
}

}  // namespace kadr::driver
