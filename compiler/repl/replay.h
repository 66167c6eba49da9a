// replay.h — a transcript, evaluated, written, read back and executed.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "driver/options.h"
#include "driver/shared_inputs.h"
#include "interp/interpreter.h"
#include "motion/pipeline.h"
#include "plot/plot_scene.h"

namespace kadr::repl {

/// One line of the ISO-7bit text, and what executing it came to.
struct TextLine {
    std::uint32_t number = 0;  // from 1
    std::string text;
    std::string done;  // "line to X10 Y20, 0.3 s"; empty: nothing was executed
};

/// What an evaluation came to.
struct ReplayOutcome {
    bool is_ok = false;           // no error and no alarm
    std::string messages;         // rendered; those that were seen before are left out
    std::uint32_t lines = 0;      // of the text up to the last block; the frame's end not counted
    std::vector<TextLine> first;  // lines behind the wanted one …
    std::deque<TextLine> last;    // … if there are more than fit in `first`, the last of them
    std::vector<interp::StateItem> state;
    AxisValues position{};
    motion::Totals totals;
    plot::PlotScene scene;
    std::string plot_subtitle;
    std::vector<std::string> reported;  // all messages, without their lines
    std::vector<std::string> values;    // of the expressions that were to be shown, as texts
    std::vector<std::string> names;     // functions and cycles that can be called, for completion
    std::map<std::string, std::vector<std::string>> parameters;  // of each of them
};

struct ReplayRequest {
    std::string program;                             // its text
    std::uint32_t known_lines = 0;                   // lines up to here are not kept
    std::uint32_t shown_from = sema::kNothingShown;  // expressions from this byte on are shown
};

/// Lines that an outcome keeps from the start, and from the end.
inline constexpr std::size_t kFirstLines = 200;
inline constexpr std::size_t kLastLines = 5;

/// Evaluates the whole program. Nothing of it outlives the call but the outcome. What has been
/// `text` of it before is not shown again.
ReplayOutcome replay(const driver::Options& options, driver::SharedInputs& inputs,
                     const ReplayRequest& request, std::vector<std::string> reported_before);

}  // namespace kadr::repl
