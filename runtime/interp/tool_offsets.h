// tool_offsets.h — the offsets of tools by number: as the machine has them, and as the program has
// written them since. The run's own copy; the machine's file is never changed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "machine/machine.h"
#include "nc/language.h"

namespace kadr::interp {

class ToolOffsets {
  public:
    /// What an offset consists of; the numbers are those of the vocabulary (tool_offset_data).
    enum class Column : std::uint8_t {
        Length = 1,
        LengthWear,
        Radius,
        RadiusWear,
        Cross,  // along X, of a lathe's tool; on the radius
        CrossWear,
        Tip,  // 0 to 9, as in machine::ToolData
    };
    static constexpr std::size_t kColumns = 7;

    explicit ToolOffsets(const machine::Machine& machine);

    static std::optional<Column> column_of(nc::Quantity quantity);
    /// The machine has a tool of this number, or the program has written its offset.
    bool is_known(std::int64_t number) const { return offsets_.contains(number); }
    /// mm; 0 of an offset that nobody has set.
    double value(Column column, std::int64_t number) const;
    void set(Column column, std::int64_t number, double value);
    /// What acts: geometry and wear, mm.
    double length(std::int64_t number) const;
    double radius(std::int64_t number) const;
    double cross(std::int64_t number) const;
    int tip(std::int64_t number) const;

  private:
    std::map<std::int64_t, std::array<double, kColumns>> offsets_;
};

}  // namespace kadr::interp
