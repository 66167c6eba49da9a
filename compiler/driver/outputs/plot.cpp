// plot.cpp — `--plot`: the path as a drawing.
#include "base/numbers.h"
#include "base/units.h"
#include "driver/outputs.h"
#include "motion/transformed.h"
#include "plot/plot_svg.h"
#include "plot/plot_tools.h"

namespace kadr::driver {

namespace {

class PlotOutput final : public RunOutput {
  public:
    explicit PlotOutput(const OutputParts& parts)
        : session_(parts.session),
          file_(parts.file),
          color_(parts.job.value_of("--plot-color") == "line" ? plot::PlotColor::Line
                                                              : plot::PlotColor::Feed) {}
    Wants wants() const override { return {.segments = true}; }

    Done follow(Execution& execution) override {
        execution_ = &execution;
        return kDone;
    }
    void see_segment(const motion::Segment& segment) override;
    void finish(const RunFigures& figures) override;

  private:
    double shade_of(const motion::Segment& segment) const;

    const Session& session_;
    Output& file_;
    plot::PlotColor color_;
    const Execution* execution_ = nullptr;
    plot::PlotScene scene_;
    plot::PlotTools tools_;  // along the path
};

/// What the colour of the segment stands for.
double PlotOutput::shade_of(const motion::Segment& segment) const {
    if (color_ == plot::PlotColor::Feed) return round_to(mm_min_from_feed(segment.feed), 3);
    const SourceRange range = execution_->statement(segment.source);
    if (!range.file.is_valid()) return segment.line;
    return session_.sources().locate(range.file, range.begin).line;
}

void PlotOutput::see_segment(const motion::Segment& segment) {
    const double shade = shade_of(segment);
    const auto& kinematics = execution_->machine().kinematics;
    if (!segment.goes_straight()) {
        scene_.add(segment, shade);
    } else {
        for (const motion::Segment& line : motion::tip_lines(kinematics->chain, segment))
            scene_.add(line, shade);
    }
    if (kinematics) tools_.add(kinematics->chain, segment);
}

void PlotOutput::finish(const RunFigures& figures) {
    const machine::Machine& machine = execution_->machine();
    plot::PlotText text;
    text.title = figures.source;
    text.subtitle = subtitle_of(figures, machine);
    text.has_diameters = machine.is_lathe;
    text.warning = warning_of(figures);
    file_.write(plot::plot_svg(scene_, text, color_, tools_.all()));
}

}  // namespace

std::unique_ptr<RunOutput> make_plot(const OutputParts& parts) {
    return std::make_unique<PlotOutput>(parts);
}

}  // namespace kadr::driver
