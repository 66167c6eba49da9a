// summary.cpp — `--summary`: what the run amounts to.
#include "driver/outputs.h"
#include "driver/work_times.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kLongest = 20;  // statements that a summary may name

class SummaryOutput final : public RunOutput {
  public:
    explicit SummaryOutput(const OutputParts& parts) : parts_(parts) {}
    Wants wants() const override { return {.segments = true, .calls = true}; }

    Done follow(Execution& execution) override {
        machine_ = &execution.machine();
        times_.emplace(execution, parts_.session);
        return kDone;
    }
    void see_segment(const motion::Segment& segment) override { times_->add(segment); }
    void finish(const RunFigures& run) override {
        RunFigures figures = run;
        figures.tools = times_->tools();
        if (const machine::ToolLibrary* library = parts_.session.tools()) {
            for (ToolShare& tool : figures.tools) {
                const machine::LibraryTool* known = library->find(tool.tool);
                if (known != nullptr) tool.name = known->name;
            }
        }
        figures.cycles = times_->cycles();
        figures.longest = times_->longest(kLongest);
        const bool is_json = parts_.job.value_of("--summary") == "json";
        parts_.file.write(is_json ? summary_json(figures, *machine_)
                                  : summary_text(figures, *machine_));
    }

  private:
    OutputParts parts_;
    const machine::Machine* machine_ = nullptr;
    std::optional<WorkTimes> times_;
};

}  // namespace

std::unique_ptr<RunOutput> make_summary(const OutputParts& parts) {
    return std::make_unique<SummaryOutput>(parts);
}

}  // namespace kadr::driver
