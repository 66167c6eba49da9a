// trace.cpp — `--trace`: what each block has changed, a table or JSON Lines.
#include "driver/trace.h"

#include "driver/outputs.h"

namespace kadr::driver {

namespace {

TraceFormat format_of(const std::string& file) {
    return file.ends_with(".jsonl") ? TraceFormat::Json : TraceFormat::Table;
}

class TraceOutput final : public RunOutput {
  public:
    explicit TraceOutput(const OutputParts& parts) : session_(parts.session), file_(parts.file) {}
    Wants wants() const override { return {.steps = true}; }

    Done follow(Execution& execution) override {
        trace_.emplace(session_, format_of(file_.name()), execution.text_name());
        return kDone;
    }
    void see_step(const TraceStep& step, const TraceState& state) override {
        text_.clear();
        trace_->append(step, state, text_);
        file_.write(text_);
    }
    void finish(const RunFigures& figures) override {
        if (figures.alarm.empty()) return;
        text_.clear();
        trace_->append_alarm(figures.alarm, text_);
        file_.write(text_);
    }

  private:
    const Session& session_;
    Output& file_;
    std::optional<Trace> trace_;
    std::string text_;
};

}  // namespace

std::unique_ptr<RunOutput> make_trace(const OutputParts& parts) {
    return std::make_unique<TraceOutput>(parts);
}

}  // namespace kadr::driver
