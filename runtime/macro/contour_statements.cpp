// Statements that read a contour into a table of the program, and move along a row of one.
#include "macro/contour_statements.h"

#include <algorithm>
#include <array>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "macro/contour_table.h"
#include "macro/program_base.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::Statement;

namespace {

/// `L` along the outside, `G` along the inside, `P` facing outside, `N` facing inside.
std::optional<ContourCut> cut_of(std::string_view kind) {
    if (kind.size() != 1) return std::nullopt;
    switch (kind[0]) {
        case 'L': return ContourCut{false, false, false};
        case 'G': return ContourCut{false, true, false};
        case 'P': return ContourCut{true, false, false};
        case 'N': return ContourCut{true, true, false};
        default: return std::nullopt;
    }
}

/// Whether it is a table with so many columns, of reals.
bool is_table(const nc::ControlSymbol& symbol, std::size_t columns) {
    return symbol.type == nc::ValueType::Real && symbol.dimensions == 2 &&
           symbol.sizes[1] == columns;
}

std::string table_with(std::size_t columns) {
    return "an array of reals with " + std::to_string(columns) + " columns";
}

}  // namespace

Outcome ContourStatements::execute(CompiledLine& line, const ControlStatement& statement,
                                   Block& out) {
    switch (statement.kind) {
        case Statement::ContourBegin:
        case Statement::ContourCode: return begin(line, statement);
        case Statement::ContourEnd: return end(line, statement);
        default: return run_row(line, statement, out);
    }
}

Outcome ContourStatements::begin(CompiledLine& line, const ControlStatement& statement) {
    if (run_.counts.given > 0) return Outcome::Wait;
    if (open_) return run_.fail(line, diag::ContourTwice, statement.span);
    OpenContour open;
    open.is_coded = statement.kind == Statement::ContourCode;
    open.depth = run_.frames.size();
    const std::size_t columns = open.is_coded ? kCodedColumns : kContourColumns;
    open.table = run_.variables.variable_of(statement.table.load, {});
    if (open.table.symbol == nullptr || !is_table(*open.table.symbol, columns)) {
        return run_.fail(line, diag::ArgumentDiffers, statement.table.span,
                         {"the table", table_with(columns)});
    }
    if (!open.is_coded) {
        ControlValue kind;
        Outcome done = run_.evaluate(line, statement.value, kind);
        if (!goes_on(done)) return done;
        const std::string letter = kind.is_text() ? std::string(run_.evaluator.text(kind))
                                   : kind.kind == ControlValue::Kind::Char ? kind.character()
                                                                           : std::string();
        const auto cut = cut_of(letter);
        if (!cut)
            return run_.fail(line, diag::ContourKind, statement.value.span,
                             {run_.evaluator.written(kind)});
        open.cut = *cut;
        std::array<std::int64_t, 4> indices{};
        if (statement.variable.indices.is_given() &&
            run_.evaluator.indices(line.line, statement.variable, indices) !=
                Evaluator::Outcome::Done)
            return run_.fail(line, run_.evaluator.fault());
        open.undercuts = run_.variables.variable_of(statement.variable.load, indices);
        const bool takes_number =
            open.undercuts.store != nullptr && (open.undercuts.type == nc::ValueType::Int ||
                                                open.undercuts.type == nc::ValueType::Real);
        if (!takes_number) {
            return run_.fail(line, diag::ArgumentDiffers, statement.variable.span,
                             {"the number of undercuts", "a variable for a whole number"});
        }
    }
    if (statement.count.is_given()) {
        ControlValue ways;
        const Outcome done = run_.evaluate(line, statement.count, ways);
        if (!goes_on(done)) return done;
        const bool is_fine =
            ways.is_number() && (ways.number == 0 || (ways.number == 1 && !open.is_coded));
        if (!is_fine)
            return run_.fail(line, diag::ContourKind, statement.count.span,
                             {run_.evaluator.written(ways)});
        open.cut.both_ways = ways.number != 0;
    }
    if (run_.interpreter == nullptr)
        return run_.fail(line, diag::IsoNotSupported, statement.span, {"a contour as a table"});
    if (const std::string_view reason = run_.interpreter->begin_contour(); !reason.empty())
        return run_.fail(line, diag::ContourSurroundings, statement.span, {std::string(reason)});
    open_ = std::move(open);
    return Outcome::Nothing;
}

Outcome ContourStatements::end(CompiledLine& line, const ControlStatement& statement) {
    if (!open_) return run_.fail(line, diag::ContourMissing, statement.span);
    if (run_.counts.given > 0) return Outcome::Wait;
    auto said = run_.interpreter->end_contour();
    const OpenContour open = std::move(*open_);
    open_.reset();
    if (!said) {  // reported
        run_.end();
        return Outcome::Nothing;
    }
    run_.variables.system_variables().put_units(*said);
    const std::size_t rows = open.table.symbol->sizes[0];
    const auto fail_for = [&](ContourFault fault) {
        switch (fault) {
            case ContourFault::TooFew:
                return run_.fail(line, diag::ContourTooShort, statement.span,
                                 {std::to_string(said->size()), open.is_coded ? "1" : "3"});
            case ContourFault::FullCircle:
                return run_.fail(line, diag::ContourFullCircle, statement.span);
            case ContourFault::TableTooSmall: break;
        }
        return run_.fail(line, diag::ContourTableSmall, statement.span,
                         {open.table.symbol->name, std::to_string(rows)});
    };
    const auto fill = [&](const auto& filled) {
        for (const auto& row : filled) {
            for (std::size_t i = 0; i < row.cells.size(); ++i) {
                const auto element = static_cast<std::uint32_t>(row.index * row.cells.size() + i);
                run_.variables.set_number(open.table, element, row.cells[i]);
            }
        }
    };
    if (open.is_coded) {
        const auto coded = coded_contour(*said, rows);
        if (!coded) return fail_for(coded.error());
        fill(*coded);
    } else {
        const auto prepared = prepared_contour(*said, open.cut, rows);
        if (!prepared) return fail_for(prepared.error());
        fill(prepared->rows);
        run_.variables.set_number(open.undercuts, 0, prepared->undercuts);
    }
    // What is wrong with a contour is an alarm here, so that this never reports an error (unsure).
    return run_.store(line, statement.variable, ControlValue::of(0, nc::ValueType::Int));
}

Outcome ContourStatements::run_row(CompiledLine& line, const ControlStatement& statement,
                                   Block& out) {
    if (run_.interpreter == nullptr)
        return run_.fail(line, diag::IsoNotSupported, statement.span, {"a contour as a table"});
    if (run_.counts.given > 0) return Outcome::Wait;
    const nc::Reference& row = statement.table;
    std::array<std::int64_t, 4> indices{};
    switch (run_.evaluator.indices(line.line, row, indices)) {
        case Evaluator::Outcome::Done: break;
        case Evaluator::Outcome::Later: return Outcome::Wait;
        case Evaluator::Outcome::Fault: return run_.fail(line, run_.evaluator.fault());
    }
    const nc::ControlSymbol& table = run_.variables.level().symbols.at(row.load.index);
    if (!is_table(table, kContourColumns))
        return run_.fail(line, diag::ArgumentDiffers, row.span,
                         {"the table", table_with(kContourColumns)});
    if (indices[0] < 0 || indices[0] >= table.sizes[0])
        return run_.fail(line, diag::IndexWrong, row.span,
                         {Evaluator::wrong_index(table, indices)});
    const auto element = element_of(run_.evaluator.contour_row(table, indices[0]));
    if (!element)
        return run_.fail(line, diag::ContourRowWrong, row.span, {std::to_string(indices[0])});
    // In the plane that acts, by coordinates and radii, whatever the program's words are now.
    const double unit = element->modes.is_metric ? 1 : kMmPerInch;
    const auto axis = [&](nc::SystemQuantity quantity) {
        const double name = run_.interpreter->quantity(quantity, 0, 0).value_or(-1);
        return static_cast<std::size_t>(-name) - 1;
    };
    const std::array<std::size_t, 2> axes{axis(nc::SystemQuantity::FirstPlaneAxis),
                                          axis(nc::SystemQuantity::SecondPlaneAxis)};
    const bool is_arc = element->shape.is_arc();
    out.motion = is_arc ? (element->shape.sweep < 0 ? Function::ArcCw : Function::ArcCcw)
                 : element->is_rapid ? Function::Rapid
                                     : Function::Line;
    out.x_measure = nc::XMeasure::Radius;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const auto to = static_cast<nc::Slot>(axes[i]);
        const auto center =
            static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + axes[i]);
        out.set(to, element->shape.to[k] * unit);
        out.absolute |= bit(to);
        if (!is_arc) continue;
        // A position of a centre is a diameter where words of the axis are.
        const double factor =
            run_.interpreter->word_factor(-static_cast<std::int64_t>(axes[i]) - 1);
        out.set(center, element->shape.center[k] * unit * factor);
        out.absolute |= bit(center);
    }
    return Outcome::Block;
}

}  // namespace kadr::macro
