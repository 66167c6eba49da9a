// tool_offsets.h — the offsets of tools by number: as the machine has them, and as the program has
// written them since. The run's own copy; the machine's file is never changed.
//
// Where tools have several cutting edges each has an offset of its own. The first has the number of
// the tool, the others one that `of_edge` gives; offsets that only have a number are first ones.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "machine/machine.h"
#include "nc/language.h"

namespace kadr::interp {

class ToolOffsets {
  public:
    /// What an offset consists of. Lengths have the numbers of SINUMERIK: the first is that of a
    /// mill or drill along itself, of a turning tool the one along X, and its second is along Z.
    enum class Column : std::uint8_t {
        First,
        FirstWear,
        Second,
        SecondWear,
        Third,
        ThirdWear,
        Radius,
        RadiusWear,
        FirstBase,  // of the adapter, added to the lengths
        SecondBase,
        ThirdBase,
        Tip,   // 0 to 9, as in machine::ToolData
        Type,  // 0: nobody has given it
    };

    static constexpr std::int64_t kMostEdges = machine::kMostEdges;
    /// The number of an edge's offset; edge 0 counts as the first.
    static constexpr std::int64_t of_edge(std::int64_t tool, std::int64_t edge) {
        return edge <= 1 ? tool : tool + (edge - 1) * kEdge;
    }
    static constexpr std::int64_t tool_of(std::int64_t number) { return number % kEdge; }
    static constexpr std::int64_t edge_of(std::int64_t number) { return number / kEdge + 1; }

    /// is_lathe  the machine is one, or the control is a lathe's
    ToolOffsets(const machine::Machine& machine, bool is_lathe);

    /// The column that a system variable is of this offset.
    std::optional<Column> column_of(nc::SystemQuantity quantity, std::int64_t number) const;
    /// … that has this number among an edge's data, x of $TC_DPx; nothing: no length hangs on it.
    static std::optional<Column> column_of_datum(std::int64_t datum);
    static constexpr std::int64_t kMostNumberedDatum = 25;  // of these data
    /// … and the one that has this number in the vocabulary (tool_offset_data).
    Column column_at(std::int64_t index, std::int64_t number) const;
    /// The machine has a tool of this number, or the program has written its offset.
    bool is_known(std::int64_t number) const { return offsets_.contains(number); }
    /// The highest number of a tool that has data; 0: none has.
    std::int64_t last_tool() const;
    /// How many of the tool's edges have data.
    std::int64_t edges(std::int64_t tool) const;
    /// The number D that calls a cutting edge of a tool: that of the edge, unless the program has
    /// given it another one; 0: the tool has no such edge.
    std::int64_t number_of(std::int64_t tool, std::int64_t cutting_edge) const;
    /// The cutting edge that such a number calls.
    std::int64_t cutting_edge(std::int64_t tool, std::int64_t number) const;
    /// Gives it another one; false: there is no such edge, or the number calls another one of the
    /// tool.
    bool give_number(std::int64_t tool, std::int64_t cutting_edge, std::int64_t number);
    /// The tool that has a number D, behind so many others that have it, too; 0: there is none.
    std::int64_t tool_with(std::int64_t number, std::int64_t passed) const;
    /// The tool has lengths along X and Z: its type has it so, or the machine is a lathe.
    bool is_turning(std::int64_t number) const;
    /// mm; 0 of an offset that nobody has set.
    double value(Column column, std::int64_t number) const;
    void set(Column column, std::int64_t number, double value);
    /// Data on which nothing depends, by their numbers; 0 if nobody has given them.
    double datum(std::int64_t number, std::int64_t datum) const;
    void set_datum(std::int64_t number, std::int64_t datum, double value);
    /// What acts, geometry, wear and adapter, mm: length 1, 2 or 3.
    double length(std::size_t part, std::int64_t number) const;
    double radius(std::int64_t number) const;
    int tip(std::int64_t number) const { return whole(Column::Tip, number); }
    int type(std::int64_t number) const { return whole(Column::Type, number); }

  private:
    int whole(Column column, std::int64_t number) const;

    static constexpr std::int64_t kEdge = std::int64_t{1} << 32;  // more than tools have numbers
    static constexpr std::size_t kColumns = 13;
    std::map<std::int64_t, std::array<double, kColumns>> offsets_;
    std::map<std::int64_t, std::int64_t> cutting_edges_;  // of offsets whose number was given
    std::map<std::pair<std::int64_t, std::int64_t>, double> data_;  // by tool and datum
    bool is_lathe_;
};

}  // namespace kadr::interp
