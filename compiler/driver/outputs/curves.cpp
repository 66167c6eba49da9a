// curves.cpp — `--curves`: the axes over time, and `--window`: in which part of the run.
#include "base/result.h"
#include "driver/amount.h"
#include "driver/outputs.h"
#include "plot/motion_plot.h"

namespace kadr::driver {

namespace {

/// `1.5s..2s`; an end may be left out. Else what is wrong with it.
Result<plot::TimeWindow, std::string> window_of(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) {
        return '`' + text + "` is no part of a run; write `1.5s..2s`, `1.5s..` or `..2s`";
    }
    plot::TimeWindow window;
    const std::pair<std::string, double*> ends[] = {{text.substr(0, dots), &window.from},
                                                    {text.substr(dots + 2), &window.to}};
    for (const auto& [end, time] : ends) {
        if (end.empty()) continue;
        const auto seconds = seconds_of(end);
        if (!seconds) return '`' + end + "` is not a time; write `1ms` or `0.002s`";
        *time = *seconds;
    }
    if (window.to > 0 && window.to <= window.from) return '`' + text + "` ends before it begins";
    return window;
}

class CurvesOutput final : public RunOutput {
  public:
    explicit CurvesOutput(const OutputParts& parts) : parts_(parts) {}
    Wants wants() const override { return {.setpoints = true}; }

    Done follow(Execution& execution) override;
    void see_setpoints(std::span<const motion::Setpoint> some) override {
        for (const motion::Setpoint& setpoint : some) trace_->add(setpoint);
    }
    void finish(const RunFigures& figures) override;

  private:
    OutputParts parts_;
    std::optional<plot::MotionTrace> trace_;
};

Done CurvesOutput::follow(Execution& execution) {
    plot::TimeWindow window;
    if (const auto asked = window_of(parts_.job.value_of("--window"))) window = *asked;
    const double tick = parts_.session.options().tick.value_or(execution.machine().tick);
    trace_.emplace(execution.machine(), tick, window);
    return kDone;
}

void CurvesOutput::finish(const RunFigures& figures) {
    plot::MotionText text;
    text.title = figures.source + ": the axes over time";
    text.subtitle = subtitle_of(figures, trace_->machine());
    if (trace_->has_too_many_blocks())
        text.subtitle += " · too many blocks to be marked, a shorter window shows them";
    text.warning = warning_of(figures);
    parts_.file.write(plot::motion_svg(*trace_, text));
}

}  // namespace

std::string fault_of_window(const std::string& text) {
    const auto window = window_of(text);
    return window ? std::string() : window.error();
}

std::unique_ptr<RunOutput> make_curves(const OutputParts& parts) {
    return std::make_unique<CurvesOutput>(parts);
}

}  // namespace kadr::driver
