#include "driver/pipeline_stages.h"

#include <string>
#include <vector>

#include "base/diagnostics/machine.h"
#include "base/read_ahead.h"
#include "process/command_modules.h"

namespace kadr::driver {

namespace {

/// Hands planned motion on as soon as it lasts for a period.
class Periods final : public Stream<motion::Segment> {
  public:
    Periods(Stream<motion::Segment>& segments, double period)
        : segments_(segments), period_(period) {}

    std::size_t pull(std::span<motion::Segment> out) override {
        std::size_t count = 0;
        for (double time = 0; count < out.size() && time < period_; ++count) {
            if (segments_.pull(out.subspan(count, 1)) == 0) break;
            time += out[count].duration;
        }
        return count;
    }

  private:
    Stream<motion::Segment>& segments_;
    double period_;
};

void write_all(Stream<motion::Setpoint>& setpoints, std::size_t batch,
               const SetpointReader& reader) {
    std::vector<motion::Setpoint> gathered(batch);
    std::size_t count = 0;
    while (!reader.has_enough()) {
        const std::size_t more = setpoints.pull(std::span(gathered).subspan(count));
        if (more == 0) break;
        count += more;
        if (count < batch) continue;
        reader.write(gathered);
        count = 0;
    }
    if (count > 0) reader.write(std::span(gathered).first(count));
}

}  // namespace

void run_stages(Stream<motion::Segment>& segments, const machine::Machine& machine, double tick,
                bool has_threads, const SetpointReader& reader) {
    const machine::Pipeline& pipeline = machine.pipeline;
    if (!has_threads) {
        motion::Sampler sampler(segments, machine, tick);
        write_all(sampler, pipeline.output.batch, reader);
        return;
    }
    Periods periods(segments, pipeline.translate.period);
    Stream<motion::Segment>& translated =
        pipeline.translate.period > 0 ? static_cast<Stream<motion::Segment>&>(periods) : segments;
    ReadAhead<motion::Segment> planned(translated, pipeline.translate.batch,
                                       pipeline.translate.queue);
    motion::Sampler sampler(planned, machine, tick);
    ReadAhead<motion::Setpoint> sampled(sampler, pipeline.interpolate.batch,
                                        pipeline.interpolate.queue);
    write_all(sampled, pipeline.output.batch, reader);
}

Done require_modules(const machine::Machine& machine, DiagnosticSink& sink) {
    std::string known;
    for (const std::string_view name : process::module_names()) {
        known += known.empty() ? "`" : ", `";
        known += name;
        known += '`';
    }
    Done all = kDone;
    for (const machine::ModuleRow& row : machine.pipeline.modules) {
        if (process::is_module(row.module)) continue;
        sink.report(diag::PipelineModule, row.range).arg(row.module).arg(known);
        all = kFailed;
    }
    return all;
}

}  // namespace kadr::driver
