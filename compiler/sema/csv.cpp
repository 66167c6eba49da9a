#include "sema/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/sema.h"
#include "base/done.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/unicode.h"

namespace kadr::sema {

namespace {

constexpr std::size_t kMostSlots = 50'000'000;  // elements of all arrays of a program
constexpr std::size_t kMostUnknown = 100;       // columns that are left out are reported

std::string_view trim(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

struct CsvCell {
    std::string text;
    std::uint32_t column = 1;  // first character, from 1
    std::size_t begin = 0;     // in the line, bytes, behind a quote
};

/// One line into cells; `""` inside quotes is a quote. False: a quote is not closed.
bool split(std::string_view line, char separator, std::vector<CsvCell>& cells) {
    cells.clear();
    std::size_t at = 0;
    std::size_t counted = 0;
    std::size_t characters = 0;
    while (true) {
        CsvCell cell;
        characters += count_code_points(line.substr(counted, at - counted));
        counted = at;
        cell.column = static_cast<std::uint32_t>(characters) + 1;
        std::size_t begin = at;
        while (begin < line.size() && (line[begin] == ' ' || line[begin] == '\t')) ++begin;
        if (begin < line.size() && line[begin] == '"') {
            at = begin + 1;
            cell.begin = at;
            while (true) {
                if (at >= line.size()) return false;
                if (line[at] == '"') {
                    if (at + 1 < line.size() && line[at + 1] == '"') ++at;
                    else break;
                }
                cell.text += line[at++];
            }
            at = std::min(line.find(separator, at), line.size());
        } else {
            const std::size_t end = std::min(line.find(separator, at), line.size());
            cell.text = trim(line.substr(at, end - at));
            cell.begin = begin;
            at = end;
        }
        cells.push_back(std::move(cell));
        if (at >= line.size()) return true;
        ++at;
    }
}

class TableReader {
  public:
    /// places  gets where cells stand; null: nobody asks
    TableReader(const TableSchema& schema, std::span<const EnumNames> enums, DiagnosticSink& sink,
                std::span<const BareUnit> bare = {},
                std::vector<PlacedTable::Place>* places = nullptr)
        : schema_(schema),
          enums_(enums),
          sink_(sink),
          bare_(bare),
          places_(places),
          bound_(schema.columns.size()) {
        for (const TableColumn& column : schema.columns) by_name_.try_emplace(column.name, &column);
    }

    std::optional<TableRows> read(const std::string& file, std::string_view text,
                                  const SourceRange& location) {
        file_ = file;
        location_ = location;
        begin_ = text.data();
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
        bool has_header = false;
        while (!text.empty()) {
            line_text_ = trim(next_line(text));
            ++line_;
            if (line_text_.empty() || line_text_.front() == '#') continue;
            if (!has_header) {
                has_header = true;
                // Some spreadsheets write semicolons, where the comma is the decimal sign.
                separator_ = line_text_.find(';') != std::string_view::npos ? ';' : ',';
                if (!read_header()) return std::nullopt;
                continue;
            }
            if (rows_.slots.size() > kMostSlots) {
                sink_.report(diag::TableTooLarge, location_).arg(file_).arg(kMostSlots);
                return std::nullopt;
            }
            row();
        }
        if (!has_header) {
            report(diag::TableEmpty, 1, 1).arg(file_);
            return std::nullopt;
        }
        if (failed_) return std::nullopt;
        return std::move(rows_);
    }

  private:
    /// Takes the first line, which ends with LF, CR LF, or CR alone, as an old spreadsheet writes.
    static std::string_view next_line(std::string_view& text) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        const bool is_pair = text.substr(end).starts_with("\r\n");
        text.remove_prefix(std::min(end + (is_pair ? 2 : 1), text.size()));
        return line;
    }

    DiagnosticBuilder report(const DiagnosticRow& row, std::uint32_t column, std::size_t length) {
        failed_ = failed_ || row.severity != Severity::Warning;
        TextLocation at;
        at.file = file_;
        at.line = std::max<std::uint32_t>(line_, 1);
        at.column = column;
        at.length = static_cast<std::uint32_t>(std::max<std::size_t>(1, length));
        at.text = line_text_;
        DiagnosticBuilder builder = sink_.report(row, std::move(at));
        if (location_.file.is_valid()) builder.note(location_, "the table is read here");
        return builder;
    }

    struct Bound {
        const TableColumn* column = nullptr;  // null: not wanted
        double factor = 1;
    };

    double factor_of(const TableColumn& column) const {
        const auto own = std::ranges::find(bare_, std::string_view(column.name), &BareUnit::column);
        if (own != bare_.end()) return own->factor;
        const Quantity quantity = column.kind == TableColumn::Kind::Feed    ? kFeedPerTime
                                  : column.kind == TableColumn::Kind::Speed ? kSpindleSpeed
                                                                            : column.quantity;
        return bare_factor(quantity, schema_.units);
    }

    bool unit_fits(const TableColumn& column, const UnitInfo& unit, double& factor) const {
        factor = unit.factor;
        if (column.kind == TableColumn::Kind::Number) return unit.quantity == column.quantity;
        const bool is_feed = column.kind == TableColumn::Kind::Feed;
        if (!is_feed && column.kind != TableColumn::Kind::Speed) return false;
        if (unit.quantity == (is_feed ? kFeedPerTime : kSpindleSpeed)) return true;
        factor *= kSecondForm;
        return unit.quantity == (is_feed ? kFeedPerTurn : kFeedPerTime);
    }

    Done read_header() {
        std::vector<CsvCell> cells;
        if (!split(line_text_, separator_, cells)) {
            report(diag::TableQuote, 1, line_text_.size());
            return kFailed;
        }
        std::vector<UnknownColumn> unknown;
        for (const CsvCell& cell : cells) {
            std::string_view name = cell.text;
            std::string_view unit;
            if (const std::size_t open = name.find('[');
                open != std::string_view::npos && name.back() == ']') {
                unit = trim(name.substr(open + 1, name.size() - open - 2));
                name = trim(name.substr(0, open));
            }
            const std::string spelled = composed(name);
            const auto found = by_name_.find(std::string_view(spelled));
            Bound bound;
            if (found == by_name_.end()) {
                unknown.push_back({std::string(name), cell.column, cell.text.size()});
                columns_.push_back(bound);
                continue;
            }
            const TableColumn& column = *found->second;
            if (has(column))
                report(diag::TableColumnTwice, cell.column, cell.text.size()).arg(name);
            bound_[index_of(column)] = true;
            bound.column = &column;
            bound.factor = factor_of(column);
            if (!unit.empty()) {
                const std::optional<UnitInfo> info = find_unit(unit);
                if (!info || !unit_fits(column, *info, bound.factor)) {
                    report(diag::TableUnit, cell.column, cell.text.size()).arg(unit).arg(name);
                }
            }
            columns_.push_back(bound);
        }
        if (!require_table(unknown)) return kFailed;
        report_missing(unknown);
        std::size_t told = 0;
        for (const UnknownColumn& column : unknown) {
            if (column.name.empty()) continue;
            if (++told > kMostUnknown) break;  // each message would hold all of a very long line
            report_unknown(column);
        }
        return Done(!failed_);
    }

    /// A column of the file that no member takes.
    struct UnknownColumn {
        std::string name;
        std::uint32_t column = 1;
        std::size_t length = 1;
    };

    /// A file that does not call itself a table and has none of its columns may have been named by
    /// mistake, or by somebody who wants to see it in messages: nothing of it is shown.
    Done require_table(const std::vector<UnknownColumn>& unknown) {
        if (unknown.size() != columns_.size() || upper_ascii(file_).ends_with(".CSV")) return kDone;
        sink_.report(diag::TableElse, location_).arg(file_).arg(schema_.type_name);
        failed_ = true;
        return kFailed;
    }

    void report_unknown(const UnknownColumn& unknown) {
        std::vector<std::string_view> names;
        for (const TableColumn& column : schema_.columns) {
            if (!has(column)) names.push_back(column.name);
        }
        DiagnosticBuilder builder =
            report(diag::TableColumnUnknown, unknown.column, unknown.length);
        builder.arg(unknown.name).arg(schema_.type_name);
        if (const auto near = nearest_name(unknown.name, names.data(), names.size())) {
            builder.fix("did you mean `" + std::string(*near) + "`?");
        }
    }

    std::size_t index_of(const TableColumn& column) const {
        return static_cast<std::size_t>(&column - schema_.columns.data());
    }
    bool has(const TableColumn& column) const { return bound_[index_of(column)]; }

    /// Members without a column. Where a column has nearly the name of one, it is that column which
    /// is wrong, and it is not reported again that nobody takes it.
    void report_missing(std::vector<UnknownColumn>& unknown) {
        for (const TableColumn& column : schema_.columns) {
            if (has(column) || column.is_optional || column.initial) continue;
            std::vector<std::string_view> names;
            names.reserve(unknown.size());
            for (const UnknownColumn& other : unknown) names.push_back(other.name);
            const auto near = nearest_name(column.name, names.data(), names.size());
            const auto misspelt =
                near ? std::find_if(unknown.begin(), unknown.end(),
                                    [&](const UnknownColumn& u) { return u.name == *near; })
                     : unknown.end();
            if (misspelt == unknown.end()) {
                report(diag::TableColumnMissing, 1, line_text_.size())
                    .arg(column.name)
                    .arg(schema_.type_name);
                continue;
            }
            report(diag::TableColumnMissing, misspelt->column, misspelt->length)
                .arg(column.name)
                .arg(schema_.type_name)
                .fix("did you mean `" + column.name + "`?");
            misspelt->name.clear();
        }
    }

    void row() {
        std::vector<CsvCell> cells;
        if (!split(line_text_, separator_, cells)) {
            report(diag::TableQuote, 1, line_text_.size());
            return;
        }
        if (cells.size() != columns_.size()) {
            report(diag::TableRowCells, 1, line_text_.size())
                .arg(cells.size())
                .arg(columns_.size());
            return;
        }
        const std::size_t first = rows_.slots.size();
        Slot empty{};
        empty.number = kNotGivenNumber;
        rows_.slots.resize(first + schema_.slots, empty);
        for (const TableColumn& column : schema_.columns) {
            const bool is_integer = column.kind != TableColumn::Kind::Number &&
                                    column.kind != TableColumn::Kind::Feed &&
                                    column.kind != TableColumn::Kind::Speed;
            Slot& slot = rows_.slots[first + column.slot];
            if (is_integer) slot.integer = kNotGivenInteger;
            if (!column.initial || has(column)) continue;
            slot = *column.initial;
            if (column.kind != TableColumn::Kind::Text) continue;
            slot.integer = static_cast<std::int64_t>(rows_.texts.size());
            rows_.texts.push_back(column.initial_text);
        }
        if (places_ != nullptr) keep_places(cells);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (columns_[i].column != nullptr)
                cell(columns_[i], cells[i], rows_.slots[first + columns_[i].column->slot]);
        }
    }

    void keep_places(const std::vector<CsvCell>& cells) {
        const auto line = static_cast<std::size_t>(line_text_.data() - begin_);
        const std::size_t first = places_->size();
        places_->resize(first + schema_.columns.size());
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (columns_[i].column == nullptr) continue;
            (*places_)[first + index_of(*columns_[i].column)] = {
                static_cast<std::uint32_t>(line + cells[i].begin),
                static_cast<std::uint32_t>(cells[i].text.size())};
        }
    }

    void cell(const Bound& bound, const CsvCell& cell, Slot& slot) {
        const TableColumn& column = *bound.column;
        const auto wrong = [&] {
            report(diag::TableCell, cell.column, cell.text.size())
                .arg(cell.text)
                .arg(column.name)
                .arg(word_for(column));
        };
        if (cell.text.empty() && column.kind != TableColumn::Kind::Text) {
            if (!column.is_optional) report(diag::TableCellEmpty, cell.column, 1).arg(column.name);
            return;
        }
        switch (column.kind) {
            case TableColumn::Kind::Text:
                slot.integer = static_cast<std::int64_t>(rows_.texts.size());
                rows_.texts.push_back(cell.text);
                return;
            case TableColumn::Kind::Bool:
                if (cell.text == "true" || cell.text == "yes" || cell.text == "1") slot.integer = 1;
                else if (cell.text == "false" || cell.text == "no" || cell.text == "0") {
                    slot.integer = 0;
                } else {
                    wrong();
                }
                return;
            case TableColumn::Kind::Enum:
                for (const auto& [name, value] : enums_[column.enumeration].members) {
                    if (name == cell.text) {
                        slot.integer = value;
                        return;
                    }
                }
                wrong();
                return;
            case TableColumn::Kind::Integer: {
                const char* end = cell.text.data() + cell.text.size();
                const auto read = std::from_chars(cell.text.data(), end, slot.integer);
                if (read.ec != std::errc() || read.ptr != end) wrong();
                return;
            }
            case TableColumn::Kind::Number:
            case TableColumn::Kind::Feed:
            case TableColumn::Kind::Speed: break;
        }
        std::string text = cell.text;
        if (separator_ == ';') std::replace(text.begin(), text.end(), ',', '.');
        const char* end = text.data() + text.size();
        const Decimal number = parse_number(text.data(), end);
        double factor = bound.factor;
        const std::string_view rest =
            trim({number.end, static_cast<std::size_t>(end - number.end)});
        bool fits = number.end != text.data();
        if (fits && !rest.empty()) {
            const std::optional<UnitInfo> unit = find_unit(rest);
            fits = unit && unit_fits(column, *unit, factor);
        }
        if (!fits) {
            wrong();
            return;
        }
        slot.number = number.value * factor;
    }

    std::string word_for(const TableColumn& column) const {
        switch (column.kind) {
            case TableColumn::Kind::Bool: return "true or false";
            case TableColumn::Kind::Integer: return "a whole number";
            case TableColumn::Kind::Enum: return "one of " + enums_[column.enumeration].name;
            case TableColumn::Kind::Text: return "a text";
            case TableColumn::Kind::Number: return describe(column.quantity);
            case TableColumn::Kind::Feed: return "feed";
            case TableColumn::Kind::Speed: return "speed";
        }
        return "";
    }

    const TableSchema& schema_;
    std::span<const EnumNames> enums_;
    DiagnosticSink& sink_;
    std::span<const BareUnit> bare_;
    std::vector<PlacedTable::Place>* places_;
    const char* begin_ = nullptr;  // of the text
    std::string file_;
    SourceRange location_;
    std::string_view line_text_;
    std::uint32_t line_ = 0;
    char separator_ = ',';
    std::unordered_map<std::string_view, const TableColumn*> by_name_;  // of the schema
    std::vector<bool> bound_;                                           // of them in the file
    std::vector<Bound> columns_;
    TableRows rows_;
    bool failed_ = false;
};

}  // namespace

std::optional<TableRows> read_table(const TableSchema& schema, std::span<const EnumNames> enums,
                                    const std::string& path, const SourceRange& location,
                                    FileAccess* access, DiagnosticSink& sink) {
    const bool is_absolute = !path.empty() && (path[0] == '/' || path[0] == '\\');
    const std::string file = is_absolute ? path : schema.folder + path;
    if (access == nullptr) {
        sink.report(diag::FileElsewhere, location).arg(file);
        return std::nullopt;
    }
    const auto text = access->read_named(file);
    if (!text) {
        report_unread(sink, diag::TableUnreadable, location, file, text.error(), *access);
        return std::nullopt;
    }
    return TableReader(schema, enums, sink).read(file, *text, location);
}

std::optional<PlacedTable> read_placed_table(const TableSchema& schema,
                                             std::span<const BareUnit> bare,
                                             const std::string& file, std::string_view text,
                                             DiagnosticSink& sink) {
    PlacedTable table;
    auto rows = TableReader(schema, {}, sink, bare, &table.places).read(file, text, {});
    if (!rows) return std::nullopt;
    table.rows = *std::move(rows);
    return table;
}

}  // namespace kadr::sema
