#include "machine/tool_library.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/danger_limits.h"
#include "base/diagnostics/machine.h"
#include "base/diagnostics/tools.h"
#include "base/numbers.h"
#include "machine/element_reader.h"
#include "machine/machine.h"

namespace kadr::machine {

namespace {

constexpr std::int64_t kMostTools = 99'999'999;
constexpr std::int64_t kMostFlutes = 1000;
// mm: a radius that is worked out from a diameter in inches is nobody's mistake.
constexpr double kRadiusSlack = 1e-3;

/// As kinds are spelled here: `Centre_Drill`, `centre-drill` are `centre drill`.
std::string plain_kind(std::string_view text) {
    std::string kind(text);
    for (char& c : kind) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (c == '_' || c == '-') c = ' ';
    }
    return kind;
}

std::string kind_list() {
    std::string list;
    for (const std::string_view kind : kToolKinds)
        list.append(list.empty() ? "`" : ", `").append(kind).append("`");
    return list;
}

std::string shown(double value) { return format_shortest(round_to(value, 4)); }

bool is_text_of_controls(std::string_view name) {
    return std::ranges::all_of(name, [](char c) { return c >= ' ' && c <= '~' && c != '"'; });
}

}  // namespace

bool is_turned_with(ToolKind kind) {
    return kind == ToolKind::Turning || kind == ToolKind::Grooving || kind == ToolKind::Threading;
}

double LibraryTool::offset_radius() const {
    if (is_turned_with(kind)) return corner_radius.value_or(0);
    return diameter.value_or(0) / 2;
}

const LibraryTool* ToolLibrary::find(std::string_view name) const {
    const auto found = std::ranges::find(tools, name, &LibraryTool::name);
    return found == tools.end() ? nullptr : &*found;
}

const LibraryTool* ToolLibrary::find(std::int64_t number) const {
    const auto found = std::ranges::find(tools, number, &LibraryTool::number);
    return found == tools.end() ? nullptr : &*found;
}

Done ToolLibraryBuilder::require_name(const ToolEntry& entry) {
    const LibraryTool& tool = entry.tool;
    const SourceRange name_at = entry.name_at.file.is_valid() ? entry.name_at : tool.range;
    if (!entry.number || tool.name.empty()) {
        sink_.report(diag::ToolWithout, tool.range).arg(entry.number ? "name" : "number");
        return kFailed;
    }
    bool is_good = true;
    if (*entry.number < 1 || *entry.number > kMostTools) {
        sink_.report(diag::ToolNumberBad, entry.number_at).arg(*entry.number);
        is_good = false;
    }
    if (!is_text_of_controls(tool.name)) {
        sink_.report(diag::ToolNameBad, name_at).arg(tool.name);
        is_good = false;
    }
    const bool is_new_number =
        bool(described_.require_first("tool " + std::to_string(*entry.number), entry.number_at));
    const bool is_new_name = bool(described_.require_first("a tool `" + tool.name + '`', name_at));
    return Done(is_good && is_new_number && is_new_name);
}

Done ToolLibraryBuilder::require_sizes(const ToolEntry& entry) {
    const LibraryTool& tool = entry.tool;
    bool is_good = true;
    const auto require = [&](bool holds, std::string_view what, double value, const SourceRange& at,
                             std::string_view range) {
        if (holds) return;
        sink_.report(diag::ToolSizeBad, at).arg(what).arg(shown(value)).arg(range);
        is_good = false;
    };
    const double d = tool.diameter.value_or(1);
    const double r = tool.corner_radius.value_or(0);
    const double angle = tool.tip_angle.value_or(180);
    const std::int64_t flutes = tool.flutes.value_or(1);
    require(d > 0, "d", d, entry.diameter_at, "above zero");
    require(r >= 0, "r", r, entry.corner_at, "zero or above");
    require(angle > 0 && angle <= 180, "tip_angle", angle, entry.tip_at,
            "above 0 and at most 180 degrees");
    require(flutes > 0 && flutes <= kMostFlutes, "flutes", static_cast<double>(flutes),
            entry.flutes_at, "1 to 1000");
    if (!is_good || !tool.diameter || !tool.corner_radius || is_turned_with(tool.kind))
        return Done(is_good);
    const bool is_ball = tool.kind == ToolKind::BallMill;
    require(r <= d / 2 + kRadiusSlack && (!is_ball || r >= d / 2 - kRadiusSlack), "r", r,
            entry.corner_at,
            (is_ball ? "half of the diameter of a ball, " : "at most half of the diameter, ") +
                shown(d / 2) + " mm");
    return Done(is_good);
}

void ToolLibraryBuilder::add(ToolEntry entry) {
    const bool has_name = bool(require_name(entry));
    const std::string spelled = plain_kind(entry.kind);
    const auto kind = std::ranges::find(kToolKinds, spelled);
    if (kind == kToolKinds.end()) {
        auto message =
            sink_.report(diag::ToolKindUnknown,
                         entry.kind_at.file.is_valid() ? entry.kind_at : entry.tool.range);
        message.arg(entry.kind).note("known are " + kind_list());
        if (const auto better = proposal(spelled, kToolKinds))
            message.fix("did you mean `" + *better + "`?");
    } else {
        entry.tool.kind = static_cast<ToolKind>(kind - kToolKinds.begin());
    }
    const bool has_sizes = bool(require_sizes(entry));
    last_is_good_ = has_name && has_sizes && kind != kToolKinds.end();
    if (!last_is_good_) return;
    entry.tool.number = *entry.number;
    library_.tools.push_back(std::move(entry.tool));
}

void ToolLibraryBuilder::add_cutting(CuttingData cutting, const SourceRange& at) {
    const auto require = [&](const std::optional<double>& value, std::string_view what) {
        if (value && !(*value > 0))
            sink_.report(diag::ToolSizeBad, at).arg(what).arg(shown(*value)).arg("above zero");
    };
    require(cutting.cutting_speed, "vc");
    require(cutting.feed_per_tooth, "fz");
    require(cutting.feed_per_turn, "f");
    if (!last_is_good_) return;  // the tool itself has been reported
    LibraryTool& tool = library_.tools.back();
    const std::string what = cutting.material.empty()
                                 ? "cutting data of `" + tool.name + '`'
                                 : "`" + cutting.material + "` of `" + tool.name + '`';
    if (described_.require_first(what, at)) tool.cutting.push_back(std::move(cutting));
}

ToolLibrary ToolLibraryBuilder::take(std::string file) {
    library_.file = std::move(file);
    return std::move(library_);
}

void add_tools(Machine& machine, const ToolLibrary& library, DiagnosticSink& sink) {
    for (const LibraryTool& tool : library.tools) {
        const auto own = std::ranges::find_if(machine.tools, [&](const ToolData& data) {
            return data.number == tool.number && data.edge == 1;
        });
        if (own == machine.tools.end()) {
            ToolData data;
            data.number = tool.number;
            data.name = tool.name;
            data.length = tool.length.value_or(0);
            data.radius = tool.offset_radius();
            machine.tools.push_back(std::move(data));
            continue;
        }
        const double radius = tool.offset_radius();
        if (own->radius > 0 && radius > 0 &&
            std::abs(own->radius - radius) > danger::kCutterSlack / 2) {
            sink.report(diag::ToolsDiffer, tool.range)
                .arg(tool.number)
                .arg(tool.name)
                .arg(shown(radius))
                .arg(machine.name)
                .arg(shown(own->radius));
        }
        own->name = tool.name;
        if (!(own->radius > 0)) own->radius = radius;
    }
}

}  // namespace kadr::machine
