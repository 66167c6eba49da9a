#include "driver/summary.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/json_writer.h"
#include "base/printable.h"
#include "base/put.h"
#include "base/units.h"

namespace kadr::driver {

namespace {

/// A value of an axis as people and files have it: mm or degrees (per s, s², s³).
double shown(const machine::MachineAxis& axis, double value) {
    return axis.is_rotary ? deg_from_rad(value) : value;
}

void put_member(JsonWriter& json, JsonName name, double value) { json.key(name).rounded(value, 9); }

using AxisFigures = std::array<double, kAxes>;

void put_axes(JsonWriter& json, JsonName name, const machine::Machine& machine,
              const AxisFigures& values) {
    json.key(name).object([&] {
        for (std::size_t i = 0; i < machine.axes.size(); ++i)
            json.key_of(machine.axes[i].name).rounded(shown(machine.axes[i], values[i]), 9);
    });
}

void put_travel(JsonWriter& json, const machine::Machine& machine, const motion::Totals& totals) {
    json.key("travel").object([&] {
        for (std::size_t i = 0; i < machine.axes.size(); ++i) {
            const machine::MachineAxis& axis = machine.axes[i];
            json.key_of(axis.name).object([&] {
                put_member(json, "min", shown(axis, totals.travel_min[i]));
                put_member(json, "max", shown(axis, totals.travel_max[i]));
            });
        }
    });
}

/// `label   value`, the values in one column.
void put_row(std::string& out, std::string_view label, std::string_view value) {
    put(out, "  {:<14}{}\n", label, value);
}

void put_times(std::string& out, const motion::Totals& totals) {
    put_row(out, "time", duration_text(totals.time));
    const auto share = [&](std::string_view name, double time) {
        if (time <= 0) return;
        put_row(out, fmt::format("  {}", name),
                fmt::format("{:<16}{:4.0f} %", duration_text(time), 100 * time / totals.time));
    };
    share("cutting", totals.cutting_time);
    share("rapid", totals.rapid_time);
    share("dwell", totals.dwell_time);
    share("tool change", totals.tool_change_time);
    share("held", totals.hold_time);
    share("waiting", totals.wait_time);  // for the machine to acknowledge M functions
    share("scanner", totals.external_time);
}

void put_scan(std::string& out, const process::ScanFigures& scan) {
    put_row(out, "marks",
            fmt::format("{}, {:.1f} mm in {}", scan.marks, scan.mark_length,
                        duration_text(scan.mark_time)));
    put_row(out, "jumps",
            fmt::format("{}, {:.1f} mm in {}", scan.jumps, scan.jump_length,
                        duration_text(scan.jump_time)));
    put_row(out, "lists",
            fmt::format("{}, {} of delays and waiting", scan.lists,
                        duration_text(scan.time - scan.mark_time - scan.jump_time)));
    if (scan.pulses > 0) put_row(out, "beam pulses", fmt::format("{}", scan.pulses));
}

void put_scan(JsonWriter& json, const process::ScanFigures& scan) {
    json.key("scanner").object([&] {
        json.key("lists").value(scan.lists);
        json.key("marks").value(scan.marks);
        json.key("jumps").value(scan.jumps);
        json.key("pulses").value(scan.pulses);
        put_member(json, "time_s", scan.time);
        put_member(json, "mark_s", scan.mark_time);
        put_member(json, "jump_s", scan.jump_time);
        put_member(json, "mark_length_mm", scan.mark_length);
        put_member(json, "jump_length_mm", scan.jump_length);
    });
}

void put_row_of_work(std::string& out, std::string_view name, const WorkShare& share) {
    put(out, "  {:<14}{:<16}{:<16}{:>10.1f} mm\n", name, duration_text(share.time),
        duration_text(share.cutting_time), share.length);
}

void put_tools(std::string& out, const std::vector<ToolShare>& tools) {
    if (tools.size() < 2) return;
    put(out, "\n  {:<14}{:<16}{:<16}{:>10}\n", "tool", "time", "cutting", "path");
    for (const ToolShare& tool : tools)
        put_row_of_work(out,
                        tool.tool == 0 ? "none"
                                       : "T" + std::to_string(tool.tool) +
                                             (tool.name.empty() ? "" : " " + tool.name),
                        tool.share);
}

void put_cycles(std::string& out, const std::vector<CycleShare>& cycles) {
    if (cycles.empty()) return;
    put(out, "\n  {:<14}{:<16}{:<16}{:>10}\n", "cycle", "time", "cutting", "path");
    for (const CycleShare& cycle : cycles) put_row_of_work(out, cycle.cycle, cycle.share);
}

/// Where most of the time goes; a statement without a name of its own is known by its location.
void put_longest(std::string& out, const std::vector<LocationShare>& longest, double time) {
    constexpr std::size_t kShown = 5;
    if (longest.size() < 2 || !(time > 0)) return;
    std::size_t width = 0;
    for (const LocationShare& row : std::span(longest).first(std::min(kShown, longest.size())))
        width = std::max(width, row.place.size());
    out += "\n  longest\n";
    for (const LocationShare& row : std::span(longest).first(std::min(kShown, longest.size()))) {
        put(out, "  {:<{}}  {:>16}{:4.0f} %  {}\n", row.place, width, duration_text(row.share.time),
            100 * row.share.time / time, row.text);
    }
}

void put_share(JsonWriter& json, const WorkShare& share) {
    put_member(json, "time_s", share.time);
    put_member(json, "cutting_s", share.cutting_time);
    put_member(json, "length_mm", share.length);
}

void put_work(JsonWriter& json, const RunFigures& figures) {
    const auto put_tool = [&](const ToolShare& tool) {
        json.object([&] {
            json.key("tool").value(tool.tool);
            if (!tool.name.empty()) json.key("name").value(tool.name);
            put_share(json, tool.share);
        });
    };
    const auto put_cycle = [&](const CycleShare& cycle) {
        json.object([&] {
            json.key("cycle").value(cycle.cycle);
            put_share(json, cycle.share);
        });
    };
    const auto put_location = [&](const LocationShare& location) {
        json.object([&] {
            json.key("at").value(location.place);
            if (!location.text.empty()) json.key("text").value(location.text);
            put_share(json, location.share);
        });
    };
    json.key("tools").array([&] { std::ranges::for_each(figures.tools, put_tool); });
    json.key("cycles").array([&] { std::ranges::for_each(figures.cycles, put_cycle); });
    json.key("longest").array([&] { std::ranges::for_each(figures.longest, put_location); });
}

void put_counts(JsonWriter& json, const RunFigures& figures) {
    json.key("blocks").value(figures.blocks);
    json.key("commands").value(figures.commands);
    if (figures.setpoints > 0) json.key("setpoints").value(figures.setpoints);
    if (figures.pulses) json.key("pulses").value(*figures.pulses);
}

void put_times(JsonWriter& json, const motion::Totals& totals) {
    put_member(json, "time_s", totals.time);
    put_member(json, "cutting_s", totals.cutting_time);
    put_member(json, "rapid_s", totals.rapid_time);
    put_member(json, "dwell_s", totals.dwell_time);
    put_member(json, "tool_change_s", totals.tool_change_time);
    put_member(json, "hold_s", totals.hold_time);
    put_member(json, "wait_s", totals.wait_time);
}

std::string counted(std::size_t number, std::string_view noun) {
    return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string limit_text(double value) {
    return std::isfinite(value) ? fmt::format("{:.1f}", value) : std::string("-");
}

void put_axis_table(std::string& out, const machine::Machine& machine,
                    const motion::Totals& totals) {
    put(out, "  {:<5}{:>12}{:>12}{:>12}{:>14}{:>14}{:>14}\n", "axis", "from", "to", "travel",
        "max velocity", "acceleration", "jerk");
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::MachineAxis& axis = machine.axes[i];
        const double from = shown(axis, totals.travel_min[i]);
        const double to = shown(axis, totals.travel_max[i]);
        put(out, "  {:<5}{:>12.3f}{:>12.3f}{:>12.3f}{:>14.1f}{:>14}{:>14}  {}\n", axis.name, from,
            to, to - from, shown(axis, totals.max_velocity[i]) * 60,
            limit_text(shown(axis, totals.max_acceleration[i])),
            limit_text(shown(axis, totals.max_jerk[i])), axis.is_rotary ? "deg" : "mm");
    }
    put(out, "  {:<41}{:>14}{:>14}{:>14}\n", "", "per min", "per s2", "per s3");
}

}  // namespace

std::string duration_text(double seconds) {
    if (seconds < 60) return fmt::format("{:.3g} s", seconds);
    const auto whole = static_cast<long long>(std::llround(seconds));
    const long long hours = whole / 3600;
    const long long minutes = whole / 60 % 60;
    if (hours == 0) return fmt::format("{} min {:02} s", minutes, whole % 60);
    return fmt::format("{} h {:02} min {:02} s", hours, minutes, whole % 60);
}

std::string summary_text(const RunFigures& figures, const machine::Machine& machine) {
    const motion::Totals& totals = figures.totals;
    std::string out = figures.source + '\n';
    put_row(out, "control", figures.dialect);
    put_row(out, "machine", machine.title.empty() ? machine.name : machine.title);
    put_row(out, "blocks",
            fmt::format("{} executed, {} commands", figures.blocks, figures.commands));
    put_times(out, totals);
    put_row(
        out, "path",
        fmt::format("{:.1f} mm, {:.1f} mm of it at feed", totals.length, totals.cutting_length));
    if (figures.setpoints > 0) put_row(out, "setpoints", fmt::format("{}", figures.setpoints));
    if (figures.pulses) put_row(out, "pulses", fmt::format("{}", *figures.pulses));
    if (figures.scan) put_scan(out, *figures.scan);
    out += '\n';
    put_axis_table(out, machine, totals);
    put_tools(out, figures.tools);
    put_cycles(out, figures.cycles);
    put_longest(out, figures.longest, totals.time);
    if (figures.warnings + figures.errors + figures.alarms > 0) {
        put(out, "\n  {}, {}, {}\n", counted(figures.warnings, "warning"),
            counted(figures.errors, "error"), counted(figures.alarms, "alarm"));
    }
    if (!figures.alarm.empty()) put(out, "  not complete, ended by {}\n", figures.alarm);
    return printable(out);
}

std::string summary_json(const RunFigures& figures, const machine::Machine& machine) {
    const motion::Totals& totals = figures.totals;
    std::string out;
    JsonWriter json(out);
    json.object([&] {
        json.key("source").value(figures.source);
        json.key("dialect").value(figures.dialect);
        json.key("machine").value(machine.name);
        put_counts(json, figures);
        put_times(json, totals);
        if (figures.scan) put_scan(json, *figures.scan);
        put_member(json, "length_mm", totals.length);
        put_member(json, "cutting_length_mm", totals.cutting_length);
        put_travel(json, machine, totals);
        put_axes(json, "max_velocity", machine, totals.max_velocity);
        put_axes(json, "max_acceleration", machine, totals.max_acceleration);
        put_axes(json, "max_jerk", machine, totals.max_jerk);
        put_work(json, figures);
        json.key("alarms").value(figures.alarms);
        json.key("errors").value(figures.errors);
        json.key("warnings").value(figures.warnings);
        if (!figures.alarm.empty()) json.key("ended_by").value(figures.alarm);
    });
    json.end_line();
    return out;
}

}  // namespace kadr::driver
