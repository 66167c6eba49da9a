#include "machine/load_pipeline.h"

#include <cmath>

#include "base/diagnostics/machine.h"
#include "base/done.h"
#include "base/numbers.h"
#include "machine/described.h"
#include "machine/element_reader.h"
#include "machine/setpoint_columns.h"
#include "path/op_names.h"

namespace kadr::machine {

namespace {

using path::Op;

// Far above what a machine needs; in the memory of small computers all the same.
constexpr std::int64_t kMostAhead = 1'000'000;
constexpr std::int64_t kMostBatch = 100'000;
constexpr std::int64_t kMostQueue = 1'000;
// Of a tick; what a period of a few decimals misses a whole number of ticks by is rounding.
constexpr double kWhole = 1e-6;

/// What a module may do with a command.
enum class Serving : std::uint8_t {
    Never,     // the path, the spindle and the end of the program are nobody else's
    Time,      // takes time or switches something; may be left out
    Motion,    // moves the tool
    ScanPath,  // … along a path that a beam can be led
};

Serving serving_of(Op op) {
    switch (op) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Spline:
        case Op::Involute:
        case Op::Parametric: return Serving::ScanPath;
        case Op::Probe: return Serving::Motion;
        case Op::Dwell:
        case Op::Tool:
        case Op::Coolant:
        case Op::Function:
        case Op::Stop:
        case Op::OptionalStop:
        case Op::Message:
        case Op::External: return Serving::Time;
        case Op::Thread:
        case Op::Spindle:
        case Op::OtherSpindle:
        case Op::SpeedLimit:
        case Op::ToolLength:
        case Op::End:
        case Op::ScannerOn:
        case Op::ScannerOff: return Serving::Never;
    }
    return Serving::Never;
}

class PipelineReader {
  public:
    PipelineReader(const XmlElement& element, const Machine& machine, DiagnosticSink& sink)
        : element_(element), machine_(machine), sink_(sink) {}

    Pipeline read() {
        const ElementReader reader(element_, sink_);
        set(pipeline_.ahead, reader.whole("ahead", 1, kMostAhead));
        for (const XmlElement& child : element_.children) {
            if (child.name == "serve") read_row(child);
            if (child.name == "translate") read_translate(child);
            if (child.name == "interpolate")
                read_ticked(child, pipeline_.interpolate, "interpolate");
            if (child.name == "output") read_output(child);
        }
        return std::move(pipeline_);
    }

  private:
    static void set(std::size_t& value, const std::optional<std::int64_t>& given) {
        if (given) value = static_cast<std::size_t>(*given);
    }

    void read_row(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (!reader.has("command") || !reader.has("by")) return;
        const std::string name = reader.text("command");
        const auto op = path::find_op(name);
        const Serving serving = op ? serving_of(*op) : Serving::Never;
        if (serving == Serving::Never) {
            auto message = sink_.report(diag::PipelineCommand, reader.location("command"));
            message.arg(name);
            const std::vector<std::string_view> names = path::op_names();
            const auto better = op ? std::nullopt : proposal(name, names);
            if (better)
                message.fix(reader.location("command"), *better, "the command is called so");
            return;
        }
        if (!described_.require_first("who serves `" + name + '`', reader.location("command")))
            return;
        const std::string module = reader.text("by");
        if (module == kNoModule && serving != Serving::Time) {
            sink_.report(diag::PipelineMotion, reader.location("by")).arg(name);
            return;
        }
        if (module == kScannerModule && !require_scanner(reader, name, serving)) return;
        pipeline_.modules.push_back({*op, module, reader.location("by")});
    }

    Done require_scanner(const ElementReader& reader, const std::string& name, Serving serving) {
        if (serving == Serving::ScanPath && machine_.scanner) return kDone;
        sink_.report(diag::PipelineScanner, reader.location("by"))
            .arg(name)
            .arg(serving == Serving::ScanPath ? "the machine file describes none"
                                              : "it is no path for a beam");
        return kFailed;
    }

    void read_translate(const XmlElement& element) {
        if (!described_.require_first("the stage `translate`", element.range)) return;
        const ElementReader reader(element, sink_);
        PipelineStage& stage = pipeline_.translate;
        stage.period = reader.positive("period", QuantityKind::Time).value_or(0);
        set(stage.batch, reader.whole("batch", 1, kMostBatch));
        set(stage.queue, reader.whole("queue", 1, kMostQueue));
    }

    /// A stage that works in whole ticks.
    void read_ticked(const XmlElement& element, PipelineStage& stage, const std::string& name) {
        if (!described_.require_first("the stage `" + name + '`', element.range)) return;
        const ElementReader reader(element, sink_);
        set(stage.queue, reader.whole("queue", 1, kMostQueue));
        const auto period = reader.positive("period", QuantityKind::Time);
        if (!period) return;
        const double ticks = *period / machine_.tick;
        const double whole = std::round(ticks);
        if (std::fabs(ticks - whole) > kWhole * whole || whole < 1) {
            sink_.report(diag::PipelinePeriod, reader.location("period"))
                .arg(reader.text("period"))
                .arg(format_shortest(round_to(machine_.tick * 1000, 6)));
            return;
        }
        stage.period = *period;
        // What is longer is handed on in parts: the memory of a stage is bounded.
        stage.batch = static_cast<std::size_t>(std::min(whole, double{kMostBatch}));
    }

    void read_output(const XmlElement& element) {
        read_ticked(element, pipeline_.output, "output");
        const ElementReader reader(element, sink_);
        read_columns(element);
        if (!reader.has("file")) return;
        const std::string file = reader.text("file");
        const bool is_table = file.ends_with(".csv") || file.ends_with(".npy");
        const bool has_hole = file.find('{') != std::string::npos;
        std::string rest = file;
        if (const auto hole = rest.find("{program}"); hole != std::string::npos)
            rest.erase(hole, std::string_view("{program}").size());
        if (is_table && rest.find_first_of("{}") == std::string::npos && rest.size() >= 4 &&
            (has_hole || rest.size() > 4)) {
            pipeline_.setpoints.file = file;
            return;
        }
        sink_.report(diag::PipelineFile, reader.location("file"))
            .arg(file)
            .arg(is_table ? "in braces stands `{program}`, once" : "it ends in `.csv` or `.npy`");
    }

    void read_columns(const XmlElement& element) {
        const XmlAttribute* attribute = element.find("columns");
        if (attribute == nullptr) return;
        for (const XmlWord& word : words_of(*attribute)) {
            if (columns_of_word(word.text, machine_).empty()) {
                sink_.report(diag::PipelineColumn, word.range).arg(word.text).arg(known_columns());
                continue;
            }
            if (described_.require_first("the column `" + word.text + '`', word.range))
                pipeline_.setpoints.columns.push_back(word.text);
        }
    }

    std::string known_columns() const {
        std::string names;
        for (const std::string& name : setpoint_columns(machine_))
            names += (names.empty() ? "" : " ") + name;
        return names;
    }

    const XmlElement& element_;
    const Machine& machine_;
    DiagnosticSink& sink_;
    Pipeline pipeline_;
    Described described_{sink_};
};

}  // namespace

Pipeline read_pipeline(const XmlElement& element, const Machine& machine, DiagnosticSink& sink) {
    return PipelineReader(element, machine, sink).read();
}

}  // namespace kadr::machine
