#include "driver/setup_sheet.h"

#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/put.h"
#include "driver/summary.h"
#include "plot/base64.h"
#include "plot/svg_text.h"

namespace kadr::driver {

namespace {

using machine::LibraryTool;

std::string mm(double value) { return format_shortest(round_to(value, 3)); }
std::string mm(const std::optional<double>& value) { return value ? mm(*value) : "–"; }

/// A table that both forms are made of. Cells are plain text.
struct SheetTable {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
    std::vector<bool> is_marked;   // by row; may be shorter
    std::size_t numbers_from = 1;  // columns from here on are numbers, to the right
};

std::string name_of(const SheetTool& tool) {
    return tool.number == 0 ? "none" : "T" + std::to_string(tool.number);
}

/// What the library tells, else the machine.
std::string diameter_of(const SheetTool& tool) {
    if (tool.library != nullptr && tool.library->diameter) return mm(*tool.library->diameter);
    const bool has_nose = tool.library != nullptr && is_turned_with(tool.library->kind);
    return tool.radius > 0 && !has_nose ? mm(2 * tool.radius) : "–";
}

/// What the machine has measured, else the library.
std::string length_of(const SheetTool& tool) {
    if (tool.length != 0) return mm(tool.length);
    return tool.library != nullptr && tool.library->length ? mm(*tool.library->length) : "–";
}

std::string kind_of(const SheetTool& tool) {
    return tool.library == nullptr ? "–" : std::string(tool_kind_name(tool.library->kind));
}

std::string holder_of(const SheetTool& tool) {
    return tool.library == nullptr || tool.library->holder.empty() ? "–" : tool.library->holder;
}

SheetTable tool_table(const SetupSheet& sheet) {
    SheetTable table{
        "Tools, in the order of use",
        {"tool", "name", "kind", "holder", "d mm", "r mm", "length mm", "flutes", "lowest Z mm"},
        {},
        {},
        4};
    for (const SheetTool& tool : sheet.tools) {
        if (tool.number == 0) continue;
        const LibraryTool* known = tool.library;
        table.rows.push_back(
            {name_of(tool), tool.name.empty() ? "–" : tool.name, kind_of(tool), holder_of(tool),
             diameter_of(tool), mm(known != nullptr ? known->corner_radius : std::nullopt),
             length_of(tool),
             known != nullptr && known->flutes ? std::to_string(*known->flutes) : "–",
             mm(tool.lowest)});
    }
    return table;
}

SheetTable work_table(const SetupSheet& sheet) {
    SheetTable table{"What they do", {"tool", "work", "time"}, {}, {}, 2};
    for (const SheetTool& tool : sheet.tools) {
        bool is_first = true;
        for (const SheetWork& work : tool.work) {
            table.rows.push_back(
                {is_first ? name_of(tool) : "", work.name, duration_text(work.time)});
            is_first = false;
        }
    }
    return table;
}

SheetTable time_table(const SetupSheet& sheet) {
    SheetTable table{
        "Times", {"tool", "cutting", "rapid", "change", "other", "together"}, {}, {}, 1};
    SheetTool total;
    const auto row = [&](const std::string& name, const SheetTool& tool) {
        const auto shown = [](double time) {
            return time > 0 ? duration_text(time) : std::string("–");
        };
        table.rows.push_back({name, shown(tool.cutting), shown(tool.rapid), shown(tool.change),
                              shown(tool.other), shown(tool.time())});
    };
    for (const SheetTool& tool : sheet.tools) {
        row(tool.name.empty() ? name_of(tool) : name_of(tool) + " " + tool.name, tool);
        total.cutting += tool.cutting;
        total.rapid += tool.rapid;
        total.change += tool.change;
        total.other += tool.other;
    }
    row("all", total);
    table.is_marked.assign(table.rows.size(), false);
    table.is_marked.back() = true;
    return table;
}

SheetTable offset_table(const SetupSheet& sheet) {
    SheetTable table{"Work offsets", {"offset", "in the machine file"}, {}, {}, 2};
    for (const SheetOffset& offset : sheet.offsets)
        table.rows.push_back({offset.word, offset.position.empty() ? "0" : offset.position});
    return table;
}

SheetTable parameter_table(const SetupSheet& sheet) {
    SheetTable table{"Parameters", {"name", "value", "default"}, {}, {}, 3};
    for (const SheetParameter& parameter : sheet.parameters) {
        const bool differs = parameter.differs();
        table.rows.push_back({parameter.name, parameter.value + (differs ? " ←" : ""),
                              parameter.standard.empty() ? "–" : parameter.standard});
        table.is_marked.push_back(differs);
    }
    return table;
}

SheetTable travel_table(const SetupSheet& sheet) {
    SheetTable table{"Travel of the axes", {"axis", "from", "to", "limits"}, {}, {}, 1};
    for (const SheetAxis& axis : sheet.axes) {
        const std::string unit = axis.is_rotary ? " deg" : " mm";
        const std::string limits =
            axis.lower || axis.upper ? mm(axis.lower) + " to " + mm(axis.upper) + unit : "–";
        table.rows.push_back({axis.name, mm(axis.least) + unit, mm(axis.most) + unit, limits});
    }
    return table;
}

std::vector<SheetTable> tables_of(const SetupSheet& sheet) {
    std::vector<SheetTable> tables = {tool_table(sheet),      work_table(sheet),
                                      time_table(sheet),      offset_table(sheet),
                                      parameter_table(sheet), travel_table(sheet)};
    std::erase_if(tables, [](const SheetTable& table) { return table.rows.empty(); });
    return tables;
}

constexpr const char* kStyle = R"(<style>
:root { color-scheme: light dark; --ink: #22262c; --soft: #666d78; --line: #d5d9df; --paper: #ffffff; --mark: #fff3cf; --alert: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8eb; --soft: #9aa3ad; --line: #3a4048; --paper: #1b1e22; --mark: #4a3f1a; --alert: #ff8a80; } }
@media print { :root { --ink: #000; --soft: #444; --line: #999; --paper: #fff; --mark: #eee; } }
body { margin: 0 auto; max-width: 62rem; padding: 1.6rem; background: var(--paper); color: var(--ink); font: 15px/1.45 "Inter", "Segoe UI", "DejaVu Sans", "Liberation Sans", Arial, sans-serif; }
h1 { font-size: 1.6rem; margin: 0; }
h2 { font-size: 1.05rem; margin: 1.8rem 0 .4rem; }
p { margin: .1rem 0; color: var(--soft); }
p.alert { color: var(--alert); font-weight: 600; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; color: var(--soft); border-bottom: 1.5px solid var(--soft); }
th, td { padding: .28rem .7rem .28rem 0; vertical-align: top; white-space: nowrap; }
td { border-bottom: 1px solid var(--line); }
.n { text-align: right; padding-right: 0; padding-left: .7rem; }
tr.mark td { background: var(--mark); font-weight: 600; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(26rem, 1fr)); gap: 1rem; }
img { width: 100%; border: 1px solid var(--line); border-radius: 4px; background: #f7f8f9; }
tr, figure { break-inside: avoid; }
figure { margin: 0; }
@media print { body { padding: 0; font-size: 11px; } .pictures { grid-template-columns: 1fr 1fr; } }
</style>
)";

void put_html_table(std::string& out, const SheetTable& table) {
    put(out, "<h2>{}</h2>\n<div class=\"wide\"><table>\n<tr>", plot::escaped(table.title));
    const auto kind = [&](std::size_t i) { return i >= table.numbers_from ? " class=\"n\"" : ""; };
    for (std::size_t i = 0; i < table.head.size(); ++i)
        put(out, "<th{}>{}</th>", kind(i), plot::escaped(table.head[i]));
    out += "</tr>\n";
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const bool is_marked = row < table.is_marked.size() && table.is_marked[row];
        out += is_marked ? "<tr class=\"mark\">" : "<tr>";
        for (std::size_t i = 0; i < table.rows[row].size(); ++i)
            put(out, "<td{}>{}</td>", kind(i), plot::escaped(table.rows[row][i]));
        out += "</tr>\n";
    }
    out += "</table></div>\n";
}

void put_picture(std::string& out, const SheetTool& tool) {
    if (tool.picture.empty()) return;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(tool.picture.data());
    put(out, "<figure><img alt=\"path of {}\" src=\"data:image/svg+xml;base64,{}\"></figure>\n",
        plot::escaped(name_of(tool)),
        plot::base64_of(std::span<const std::uint8_t>(bytes, tool.picture.size())));
}

/// `|` would end a cell.
std::string in_cell(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '|') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

void put_markdown_table(std::string& out, const SheetTable& table) {
    put(out, "\n## {}\n\n|", table.title);
    for (const std::string& cell : table.head) put(out, " {} |", in_cell(cell));
    out += "\n|";
    for (std::size_t i = 0; i < table.head.size(); ++i)
        out += i >= table.numbers_from ? " ---: |" : " --- |";
    out += '\n';
    for (const std::vector<std::string>& row : table.rows) {
        out += '|';
        for (const std::string& cell : row) put(out, " {} |", in_cell(cell));
        out += '\n';
    }
}

}  // namespace

std::string setup_sheet_html(const SetupSheet& sheet) {
    std::string out;
    put(out,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Set-up of {}</title>\n{}</head>\n<body>\n<h1>{}</h1>\n<p>{}</p>\n",
        plot::escaped(sheet.title), kStyle, plot::escaped(sheet.title),
        plot::escaped(sheet.subtitle));
    if (!sheet.library.empty()) put(out, "<p>tools of {}</p>\n", plot::escaped(sheet.library));
    if (!sheet.warning.empty())
        put(out, "<p class=\"alert\">{}</p>\n", plot::escaped(sheet.warning));
    for (const SheetTable& table : tables_of(sheet)) put_html_table(out, table);
    const bool has_pictures = std::ranges::any_of(
        sheet.tools, [](const SheetTool& tool) { return !tool.picture.empty(); });
    if (has_pictures) {
        out += "<h2>Paths</h2>\n<div class=\"pictures\">\n";
        for (const SheetTool& tool : sheet.tools) put_picture(out, tool);
        out += "</div>\n";
    }
    out += "</body>\n</html>\n";
    return out;
}

std::string setup_sheet_markdown(const SetupSheet& sheet) {
    std::string out;
    put(out, "# {}\n\n{}\n", sheet.title, sheet.subtitle);
    if (!sheet.library.empty()) put(out, "\nTools of `{}`.\n", sheet.library);
    if (!sheet.warning.empty()) put(out, "\n**{}**\n", sheet.warning);
    for (const SheetTable& table : tables_of(sheet)) put_markdown_table(out, table);
    return out;
}

}  // namespace kadr::driver
