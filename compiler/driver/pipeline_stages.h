// pipeline_stages.h — the stages between planned motion and written setpoints, as the machine file
// sizes them.
//
//     translate ahead → [queue] → interpolate → [queue] → output
//
// With threads every stage works in its own and stops when its queue is full; without, one works
// for the next. Sizes decide when something is done, never what: the setpoints are the same.
#pragma once

#include <functional>
#include <span>

#include "base/done.h"
#include "base/stream.h"
#include "machine/machine.h"
#include "motion/pipeline.h"

namespace kadr::driver {

/// Who gets the setpoints.
struct SetpointReader {
    std::function<void(std::span<const motion::Setpoint>)> write;
    /// Asked in front of each batch: whether it wants no more of them.
    std::function<bool()> has_enough;
};

/// Walks planned motion at `tick` (0: the machine's) and hands its setpoints over in the batches of
/// the last stage, until the motion ends or the reader has enough.
void run_stages(Stream<motion::Segment>& segments, const machine::Machine& machine, double tick,
                bool has_threads, const SetpointReader& reader);

/// Every module that the machine file names is linked into the program.
Done require_modules(const machine::Machine& machine, DiagnosticSink& sink);

}  // namespace kadr::driver
