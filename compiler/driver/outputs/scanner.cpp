// scanner.cpp — `--scanner`: what the scanner is told, list by list.
#include "base/diagnostics/machine.h"
#include "driver/outputs.h"
#include "driver/scanner_list.h"

namespace kadr::driver {

namespace {

class ScannerOutput final : public RunOutput {
  public:
    explicit ScannerOutput(const OutputParts& parts) : session_(parts.session), file_(parts.file) {}
    Wants wants() const override { return {.scanner_lists = true}; }

    Done follow(Execution& execution) override {
        const machine::Machine& machine = execution.machine();
        if (!machine.scanner) {
            session_.messages().report(diag::MachineWithoutScanner).arg(machine.name);
            return kFailed;
        }
        text_.emplace(*machine.scanner, file_);
        return kDone;
    }
    void see_scanner_list(const process::StartedList& list) override { text_->write(list); }
    void finish(const RunFigures& figures) override { text_->finish(figures.alarm); }

  private:
    Session& session_;
    Output& file_;
    std::optional<ScannerText> text_;
};

}  // namespace

std::unique_ptr<RunOutput> make_scanner(const OutputParts& parts) {
    return std::make_unique<ScannerOutput>(parts);
}

}  // namespace kadr::driver
