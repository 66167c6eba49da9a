#include "sema/tool_table.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/diagnostics/tools.h"
#include "machine/counting_sink.h"
#include "sema/csv.h"
#include "sema/quantity.h"

namespace kadr::sema {

namespace {

// The columns; each has one slot of a row, in this order.
enum class Column : std::uint8_t {
    Number,
    Name,
    Kind,
    Diameter,
    Corner,
    Length,
    Flutes,
    TipAngle,
    Pitch,
    Holder,
    Material,
    Speed,
    ToothFeed,
    TurnFeed,
};

struct ColumnRow {
    std::string_view name;
    TableColumn::Kind kind;
    Quantity quantity;
    bool is_needed = false;
};

// In the order of Column.
constexpr std::array kColumns = {
    ColumnRow{"number", TableColumn::Kind::Integer, kNumber},
    ColumnRow{"name", TableColumn::Kind::Text, kNumber, true},
    ColumnRow{"kind", TableColumn::Kind::Text, kNumber, true},
    ColumnRow{"d", TableColumn::Kind::Number, kLength},
    ColumnRow{"r", TableColumn::Kind::Number, kLength},
    ColumnRow{"length", TableColumn::Kind::Number, kLength},
    ColumnRow{"flutes", TableColumn::Kind::Integer, kNumber},
    ColumnRow{"tip_angle", TableColumn::Kind::Number, kAngle},
    ColumnRow{"pitch", TableColumn::Kind::Number, kLength},
    ColumnRow{"holder", TableColumn::Kind::Text, kNumber},
    ColumnRow{"material", TableColumn::Kind::Text, kNumber},
    ColumnRow{"vc", TableColumn::Kind::Number, kFeedPerTime},
    ColumnRow{"fz", TableColumn::Kind::Number, kLength},
    ColumnRow{"f", TableColumn::Kind::Number, kFeedPerTurn},
};

// A cutting speed is said in metres per minute, whatever else a file has.
constexpr std::array kBare = {BareUnit{"vc", 1000.0 / 60.0}};

// What belongs to the tool and not to its cutting data.
constexpr std::array kOfTool = {Column::Kind,   Column::Diameter, Column::Corner, Column::Length,
                                Column::Flutes, Column::TipAngle, Column::Pitch,  Column::Holder};

TableSchema schema() {
    TableSchema schema;
    schema.type_name = "tool";
    for (const ColumnRow& row : kColumns) {
        TableColumn column;
        column.name = row.name;
        column.kind = row.kind;
        column.quantity = row.quantity;
        column.is_optional = !row.is_needed;
        column.slot = schema.slots++;
        schema.columns.push_back(std::move(column));
    }
    return schema;
}

/// One row of the file.
class ToolRow {
  public:
    ToolRow(const PlacedTable& table, std::size_t row, FileId file)
        : table_(table), first_(row * kColumns.size()), file_(file) {}

    std::string text(Column column) const {
        const std::int64_t index = slot(column).integer;
        return index == kNotGivenInteger ? std::string()
                                         : table_.rows.texts[static_cast<std::size_t>(index)];
    }
    std::optional<std::int64_t> whole(Column column) const {
        const std::int64_t value = slot(column).integer;
        return value == kNotGivenInteger ? std::nullopt : std::optional(value);
    }
    std::optional<double> number(Column column) const {
        const double value = slot(column).number;
        return std::isnan(value) ? std::nullopt : std::optional(value);
    }
    bool has(Column column) const { return place(column).length > 0; }
    SourceRange at(Column column) const {
        const PlacedTable::Place& cell = place(column);
        return {file_, cell.offset, cell.offset + cell.length};
    }
    /// From its first cell to its last one.
    SourceRange range() const {
        SourceRange all{file_, 0xffffffffu, 0};
        for (std::size_t i = 0; i < kColumns.size(); ++i) {
            const PlacedTable::Place& cell = table_.places[first_ + i];
            if (cell.length == 0) continue;
            all.begin = std::min(all.begin, cell.offset);
            all.end = std::max(all.end, cell.offset + cell.length);
        }
        return all.end == 0 ? SourceRange{file_, 0, 0} : all;
    }

  private:
    const Slot& slot(Column column) const {
        return table_.rows.slots[first_ + static_cast<std::size_t>(column)];
    }
    const PlacedTable::Place& place(Column column) const {
        return table_.places[first_ + static_cast<std::size_t>(column)];
    }

    const PlacedTable& table_;
    std::size_t first_;
    FileId file_;
};

machine::ToolEntry entry_of(const ToolRow& row) {
    machine::ToolEntry entry;
    entry.number = row.whole(Column::Number);
    entry.kind = row.text(Column::Kind);
    machine::LibraryTool& tool = entry.tool;
    tool.name = row.text(Column::Name);
    tool.diameter = row.number(Column::Diameter);
    tool.corner_radius = row.number(Column::Corner);
    tool.length = row.number(Column::Length);
    tool.flutes = row.whole(Column::Flutes);
    tool.tip_angle = row.number(Column::TipAngle);
    tool.pitch = row.number(Column::Pitch);
    tool.holder = row.text(Column::Holder);
    tool.range = row.range();
    entry.number_at = row.at(Column::Number);
    entry.name_at = row.at(Column::Name);
    entry.kind_at = row.has(Column::Kind) ? row.at(Column::Kind) : tool.range;
    entry.diameter_at = row.at(Column::Diameter);
    entry.corner_at = row.at(Column::Corner);
    entry.flutes_at = row.at(Column::Flutes);
    entry.tip_at = row.at(Column::TipAngle);
    return entry;
}

void add_cutting(const ToolRow& row, machine::ToolLibraryBuilder& builder) {
    machine::CuttingData cutting{row.text(Column::Material), row.number(Column::Speed),
                                 row.number(Column::ToothFeed), row.number(Column::TurnFeed)};
    const bool says = !cutting.material.empty() || cutting.cutting_speed ||
                      cutting.feed_per_tooth || cutting.feed_per_turn;
    if (says) builder.add_cutting(std::move(cutting), row.range());
}

}  // namespace

std::optional<machine::ToolLibrary> read_tool_table(FileId file, const Sources& sources,
                                                    DiagnosticSink& sink) {
    const std::string name(sources.name(file));
    const auto table = read_placed_table(schema(), kBare, name, sources.text(file), sink);
    if (!table) return std::nullopt;
    machine::CountingSink counting(sink);
    machine::ToolLibraryBuilder builder(counting);
    const std::size_t rows = table->places.size() / kColumns.size();
    bool has_tool = false;
    for (std::size_t i = 0; i < rows; ++i) {
        const ToolRow row(*table, i, file);
        const bool goes_on = !row.has(Column::Number) && !row.has(Column::Name);
        if (!goes_on) {
            builder.add(entry_of(row));
            has_tool = true;
        } else if (!has_tool) {
            counting.report(diag::ToolRowFirst, row.range());
            continue;
        }
        for (const Column column : kOfTool) {
            if (!goes_on || !row.has(column)) continue;
            counting.report(diag::ToolRowApart, row.at(column))
                .arg(kColumns[static_cast<std::size_t>(column)].name);
        }
        add_cutting(row, builder);
    }
    if (counting.has_errors()) return std::nullopt;
    return builder.take(name);
}

}  // namespace kadr::sema
