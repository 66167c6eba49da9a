// drive.cpp — `--drive`: the drives over time, simulated; a drawing, or rows of a table.
#include "base/diagnostics/driver.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "driver/drive_table.h"
#include "driver/outputs.h"
#include "plot/drive_plot.h"
#include "process/drive_run.h"

namespace kadr::driver {

namespace {

class DriveOutput final : public RunOutput {
  public:
    explicit DriveOutput(const OutputParts& parts) : session_(parts.session), file_(parts.file) {}
    Wants wants() const override { return {.segments = true}; }

    Done follow(Execution& execution) override;
    void see_segment(const motion::Segment& segment) override { drives_->add(segment); }
    void finish(const RunFigures& figures) override;

  private:
    void take(process::DriveSample sample);
    std::string warning(const RunFigures& figures) const;

    Session& session_;
    Output& file_;
    const Execution* execution_ = nullptr;
    std::unique_ptr<process::DriveRun> drives_;
    std::optional<DriveTable> table_;  // nothing: they are drawn
    plot::DriveTrace trace_;
};

Done DriveOutput::follow(Execution& execution) {
    execution_ = &execution;
    const machine::Machine& machine = execution.machine();
    if (!machine.drives) {
        session_.messages().report(diag::MachineWithoutDrives).arg(machine.name);
        return kFailed;
    }
    if (file_.name().ends_with(".csv")) table_.emplace(file_);
    const double period = session_.options().tick.value_or(machine.tick);
    drives_ = std::make_unique<process::DriveRun>(
        machine, period, [this](const process::DriveSample& sample) { take(sample); });
    return kDone;
}

void DriveOutput::take(process::DriveSample sample) {
    if (!table_) {
        trace_.add(sample);
        return;
    }
    if (!macro::NcProgram::is_in_main_text(sample.line))
        sample.line = execution_->location_of(sample.line).line;
    table_->add(sample);
}

std::string DriveOutput::warning(const RunFigures& figures) const {
    if (!figures.alarm.empty()) return warning_of(figures);
    return drives_->has_stalled() ? "not complete, the spindle drive stalls" : "";
}

void DriveOutput::finish(const RunFigures& figures) {
    if (drives_->has_stalled()) {
        session_.messages()
            .report(diag::SpindleStalls)
            .arg(round_to(rpm_from_angular_speed(drives_->wanted_speed()), 1))
            .arg(round_to(rpm_from_angular_speed(drives_->speed()), 1));
    }
    const std::string what_is_wrong = warning(figures);
    if (table_) {
        table_->finish();
        if (!what_is_wrong.empty()) file_.write("# " + what_is_wrong + '\n');
        return;
    }
    const machine::Machine& machine = execution_->machine();
    plot::DriveText text;
    text.title = figures.source + ": the drives";
    text.subtitle = figures.dialect + " · " + machine_title(machine);
    text.warning = what_is_wrong;
    file_.write(plot::drive_svg(trace_, *machine.drives, text));
}

}  // namespace

std::unique_ptr<RunOutput> make_drive(const OutputParts& parts) {
    return std::make_unique<DriveOutput>(parts);
}

}  // namespace kadr::driver
