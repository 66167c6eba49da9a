// setup_sheet.cpp — `--setup-sheet`: what a person sets up before the program runs.
#include "driver/setup_sheet.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/units.h"
#include "driver/outputs.h"
#include "motion/transformed.h"
#include "nc/block.h"
#include "nc/parameters.h"
#include "plot/plot_svg.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kMostTools = 200;    // rows of a sheet
constexpr std::size_t kMostPictures = 40;  // of them with a picture
constexpr std::size_t kMostWork = 40;      // kinds of work of a tool
constexpr const char* kOwnMoves = "lines and arcs of the program";

/// A tool while it works.
struct ToolRun {
    SheetTool sheet;
    plot::PlotScene scene;
};

class SetupSheetOutput final : public RunOutput {
  public:
    explicit SetupSheetOutput(const OutputParts& parts)
        : session_(parts.session),
          file_(parts.file),
          is_markdown_(upper_ascii(parts.job.value_of("--setup-sheet")).ends_with(".MD")) {}

    Wants wants() const override { return {.segments = true, .calls = true}; }
    Done look_on(Aside& aside) override;
    Done follow(Execution& execution) override {
        execution_ = &execution;
        return kDone;
    }
    void see_segment(const motion::Segment& segment) override;
    void finish(const RunFigures& figures) override;

  private:
    ToolRun& run_of(std::int64_t tool);
    void draw(ToolRun& run, const motion::Segment& segment);
    std::string work_of(const motion::Segment& segment) const;
    void name_tools();
    std::vector<SheetOffset> offsets() const;
    std::vector<SheetParameter> parameters() const;
    std::vector<SheetAxis> axes(const motion::Totals& totals) const;

    Session& session_;
    Output& file_;
    bool is_markdown_;
    const Execution* execution_ = nullptr;
    std::vector<ToolRun> tools_;
    std::size_t at_ = 0;
    std::vector<std::int64_t> work_offsets_;  // by their numbers, in the order of use
    std::uint32_t work_line_ = 0;             // of `work_`
    std::uint16_t work_cycle_ = 0;
    std::string work_;
};

/// Which work offsets the text calls is seen where it is read.
Done SetupSheetOutput::look_on(Aside& aside) {
    auto others = std::move(aside.look_at);
    aside.look_at = [this, others = std::move(others)](const nc::Block& block) {
        if (others) others(block);
        const nc::Invocation* call = block.find(nc::Function::WorkOffset);
        if (call == nullptr) return;
        const auto number = static_cast<std::int64_t>(std::llround(
            block.argument(*call, nc::parameter_of<nc::Function::WorkOffset>("number"))));
        const bool is_known = std::ranges::find(work_offsets_, number) != work_offsets_.end();
        if (number > 0 && !is_known) work_offsets_.push_back(number);
    };
    return kDone;
}

/// Of tools beyond those that a sheet has room for the last one stands for all.
ToolRun& SetupSheetOutput::run_of(std::int64_t tool) {
    if (at_ < tools_.size() && tools_[at_].sheet.number == tool) return tools_[at_];
    const auto found =
        std::ranges::find_if(tools_, [&](const ToolRun& run) { return run.sheet.number == tool; });
    if (found != tools_.end()) {
        at_ = static_cast<std::size_t>(found - tools_.begin());
    } else if (tools_.size() < kMostTools) {
        at_ = tools_.size();
        tools_.emplace_back().sheet.number = tool;
    } else {
        at_ = tools_.size() - 1;
    }
    return tools_[at_];
}

/// What the program calls for it: the innermost function that is not called by the library. Of
/// ISO-7bit text the cycle.
std::string SetupSheetOutput::work_of(const motion::Segment& segment) const {
    const GeneratedText* text = execution_->generated();
    const expand::BlockOrigin* origin =
        text == nullptr ? nullptr : text->calls_behind(segment.line);
    std::string_view called;
    if (origin != nullptr) {
        for (const expand::SourceCall& call : origin->calls) {
            const bool has_place = call.range.file.is_valid();
            const bool is_ours =
                has_place &&
                session_.sources().name(call.range.file).starts_with(session_.share().library);
            if (!is_ours) called = call.function;
        }
    }
    if (!called.empty()) return std::string(called);
    if (segment.cycle != 0) return execution_->dialect().cycles()[segment.cycle - 1u].name;
    return kOwnMoves;
}

void SetupSheetOutput::draw(ToolRun& run, const motion::Segment& segment) {
    const double shade = round_to(mm_min_from_feed(segment.feed), 3);
    if (!segment.goes_straight()) return run.scene.add(segment, shade);
    const auto& kinematics = execution_->machine().kinematics;
    for (const motion::Segment& line : motion::tip_lines(kinematics->chain, segment))
        run.scene.add(line, shade);
}

void SetupSheetOutput::see_segment(const motion::Segment& segment) {
    using motion::SegmentKind;
    const bool is_external = motion::is_external(segment.kind);
    ToolRun& run = is_external && !tools_.empty() ? tools_[at_] : run_of(segment.tool_number);
    SheetTool& sheet = run.sheet;
    const bool cuts = segment.kind == SegmentKind::Feed || segment.kind == SegmentKind::Mark;
    if (cuts) sheet.cutting += segment.duration;
    else if (segment.kind == SegmentKind::Rapid || segment.kind == SegmentKind::Jump)
        sheet.rapid += segment.duration;
    else if (segment.kind == SegmentKind::ToolChange) sheet.change += segment.duration;
    else sheet.other += segment.duration;
    if (motion::is_motion(segment.kind)) draw(run, segment);
    if (!cuts) return;
    if (segment.line != work_line_ || segment.cycle != work_cycle_ || work_.empty()) {
        work_ = work_of(segment);
        work_line_ = segment.line;
        work_cycle_ = segment.cycle;
    }
    const auto known = std::ranges::find(sheet.work, work_, &SheetWork::name);
    if (known != sheet.work.end()) known->time += segment.duration;
    else if (sheet.work.size() < kMostWork) sheet.work.push_back({work_, segment.duration});
    else sheet.work.back().time += segment.duration;
}

void SetupSheetOutput::name_tools() {
    const machine::ToolLibrary* library = session_.tools();
    const machine::Machine& machine = execution_->machine();
    for (ToolRun& run : tools_) {
        SheetTool& sheet = run.sheet;
        if (const machine::ToolData* own = machine.find_tool(sheet.number)) {
            sheet.name = own->name;
            sheet.radius = own->radius;
            sheet.length = own->length;
        }
        sheet.library = library == nullptr ? nullptr : library->find(sheet.number);
        if (sheet.library != nullptr) sheet.name = sheet.library->name;
        if (!run.scene.feed_box().is_empty()) sheet.lowest = run.scene.feed_box().lower.z();
    }
}

std::vector<SheetOffset> SetupSheetOutput::offsets() const {
    const machine::Machine& machine = execution_->machine();
    std::vector<SheetOffset> all;
    for (const std::int64_t number : work_offsets_) {
        SheetOffset offset;
        offset.word = number <= 6 ? "G" + std::to_string(53 + number) : std::to_string(number);
        const auto index = static_cast<std::size_t>(number);
        for (std::size_t i = 0; index < machine.work_offsets.size() && i < kAxes; ++i) {
            const double value = machine.work_offsets[index][i];
            if (value == 0) continue;
            if (!offset.position.empty()) offset.position += ' ';
            offset.position += std::string(kAxisNames[i]) + ' ' + format_shortest(value);
        }
        all.push_back(std::move(offset));
    }
    return all;
}

/// The text of a default, behind the name that it belongs to; empty: there is none.
std::string default_behind(std::string_view text) {
    const std::size_t equals = text.find_first_not_of(" \t\r\n");
    if (equals == std::string_view::npos || text[equals] != '=') return {};
    int depth = 0;
    bool is_quoted = false;
    std::size_t end = equals + 1;
    for (; end < text.size(); ++end) {
        const char c = text[end];
        if (c == '"') is_quoted = !is_quoted;
        if (is_quoted) continue;
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (depth == 0 && (c == ',' || c == ')')) break;
        // `in 1mm..5mm` says what is admitted.
        if (depth == 0 && text.substr(end).starts_with(" in ")) break;
        if (c == ')' || c == ']' || c == '}') --depth;
    }
    std::string_view value = text.substr(equals + 1, end - equals - 1);
    while (!value.empty() && std::isspace(static_cast<unsigned char>(value.front())) != 0)
        value.remove_prefix(1);
    while (!value.empty() && std::isspace(static_cast<unsigned char>(value.back())) != 0)
        value.remove_suffix(1);
    return std::string(value);
}

std::vector<SheetParameter> SetupSheetOutput::parameters() const {
    std::vector<SheetParameter> all;
    const KadrProgram* program = execution_->program();
    if (program == nullptr) return all;
    const sema::FunctionCode* chosen = chosen_program(*program->code, session_.options().program);
    if (chosen == nullptr) return all;
    for (const sema::ParameterInfo& parameter : chosen->parameters) {
        SheetParameter row;
        row.name = parameter.name;
        const std::string_view text = session_.sources().text(parameter.range.file);
        const std::size_t name = text.find(parameter.name, parameter.range.begin);
        if (parameter.has_default && name != std::string_view::npos)
            row.standard = default_behind(text.substr(name + parameter.name.size()));
        row.value = row.standard;
        for (const sema::Define& define : session_.options().defines)
            if (define.name == parameter.name) row.value = define.value;
        all.push_back(std::move(row));
    }
    return all;
}

std::vector<SheetAxis> SetupSheetOutput::axes(const motion::Totals& totals) const {
    std::vector<SheetAxis> all;
    const std::vector<machine::MachineAxis>& axes = execution_->machine().axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const machine::MachineAxis& axis = axes[i];
        const auto shown = [&](double value) {
            return axis.is_rotary ? deg_from_rad(value) : value;
        };
        SheetAxis row{
            axis.name,    axis.is_rotary, shown(totals.travel_min[i]), shown(totals.travel_max[i]),
            std::nullopt, std::nullopt};
        if (std::isfinite(axis.lower)) row.lower = shown(axis.lower);
        if (std::isfinite(axis.upper)) row.upper = shown(axis.upper);
        all.push_back(std::move(row));
    }
    return all;
}

void SetupSheetOutput::finish(const RunFigures& figures) {
    name_tools();
    const machine::Machine& machine = execution_->machine();
    SetupSheet sheet;
    sheet.title = figures.source;
    sheet.subtitle = subtitle_of(figures, machine);
    sheet.warning = warning_of(figures);
    if (const machine::ToolLibrary* library = session_.tools()) sheet.library = library->file;
    sheet.time = figures.totals.time;
    sheet.offsets = offsets();
    sheet.parameters = parameters();
    sheet.axes = axes(figures.totals);
    for (ToolRun& run : tools_) {
        if (!(run.sheet.time() > 0)) continue;
        const bool has_path = !run.scene.feed_box().is_empty();
        if (!is_markdown_ && has_path && sheet.tools.size() < kMostPictures) {
            plot::PlotText text;
            text.title = "T" + std::to_string(run.sheet.number);
            if (!run.sheet.name.empty()) text.title += ' ' + run.sheet.name;
            text.subtitle = "cutting " + duration_text(run.sheet.cutting);
            text.has_diameters = machine.is_lathe;
            run.sheet.picture = plot::plot_svg(run.scene, text, plot::PlotColor::Feed);
        }
        sheet.tools.push_back(std::move(run.sheet));
    }
    file_.write(is_markdown_ ? setup_sheet_markdown(sheet) : setup_sheet_html(sheet));
}

}  // namespace

std::unique_ptr<RunOutput> make_setup_sheet(const OutputParts& parts) {
    return std::make_unique<SetupSheetOutput>(parts);
}

}  // namespace kadr::driver
