#include "driver/setpoints.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "base/units.h"
#include "driver/columns.h"
#include "machine/setpoint_columns.h"

namespace kadr::driver {

namespace {

constexpr int kDecimals = 9;
constexpr int kFeedDecimals = 6;

/// W; the energy on a millimetre of path stays the same as far as the least power lets it.
double beam_power(const machine::Laser& laser, const motion::Setpoint& setpoint) {
    if (!(setpoint.nominal_feed > 0)) return 0;
    const double share = std::min(1.0, setpoint.feed / setpoint.nominal_feed);
    return laser.least_power + (laser.power - laser.least_power) * share;
}

enum class ColumnKind : std::uint8_t { Length, Feed, Count };

/// A number of a setpoint, as the table has it.
struct SetpointCell {
    ColumnKind kind = ColumnKind::Length;
    double number = 0;        // of a Length or a Feed
    std::uint32_t count = 0;  // of a Count
};

struct SetpointColumn {
    std::string name;
    ColumnKind kind = ColumnKind::Length;
};

SetpointCell length(double value) { return {ColumnKind::Length, value}; }
SetpointCell feed(double value) { return {ColumnKind::Feed, value}; }
SetpointCell counted(std::uint32_t value) { return {ColumnKind::Count, 0, value}; }

/// All numbers of a setpoint, in the order of machine::setpoint_columns.
void fill(const machine::Machine& machine, const motion::Setpoint& setpoint,
          std::vector<SetpointCell>& cells) {
    cells.clear();
    cells.push_back(length(setpoint.time));
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const double value = setpoint.axis[i];
        cells.push_back(length(machine.axes[i].is_rotary ? deg_from_rad(value) : value));
    }
    for (int i = 0; i < 3; ++i) cells.push_back(length(setpoint.tip[i]));
    for (int i = 0; i < 3; ++i) cells.push_back(length(setpoint.tool[i]));
    cells.push_back(feed(mm_min_from_feed(setpoint.feed)));
    cells.push_back(counted(setpoint.line));
    if (machine::has_pulses(machine)) cells.push_back(counted(setpoint.pulses));
    if (machine.laser && machine.laser->power > 0)
        cells.push_back(feed(beam_power(*machine.laser, setpoint)));
}

/// The columns that the machine file asks for, and how a setpoint fills them.
class ChosenColumns {
  public:
    explicit ChosenColumns(const machine::Machine& machine)
        : machine_(machine), chosen_(machine::chosen_columns(machine)) {
        fill(machine, {}, cells_);
        const std::vector<std::string> names = machine::setpoint_columns(machine);
        for (const std::size_t i : chosen_) columns_.push_back({names[i], cells_[i].kind});
    }
    const std::vector<SetpointColumn>& columns() const { return columns_; }

    template <typename Look>
    void for_each(const motion::Setpoint& setpoint, const Look& look) {
        fill(machine_, setpoint, cells_);
        for (const std::size_t i : chosen_) look(cells_[i]);
    }

  private:
    const machine::Machine& machine_;
    std::vector<std::size_t> chosen_;
    std::vector<SetpointColumn> columns_;
    std::vector<SetpointCell> cells_;
};

class CsvTable final : public SetpointTable {
  public:
    CsvTable(const machine::Machine& machine, Output& out) : columns_(machine), out_(out) {
        std::string header;
        for (const SetpointColumn& column : columns_.columns())
            header += (header.empty() ? "" : ",") + column.name;
        out_.write(header + '\n');
    }

    void write(std::span<const motion::Setpoint> setpoints) override {
        text_.clear();
        for (const motion::Setpoint& setpoint : setpoints) {
            const std::size_t begin = text_.size();
            columns_.for_each(setpoint, [&](const SetpointCell& cell) {
                if (text_.size() > begin) text_ += ',';
                if (cell.kind == ColumnKind::Count) text_ += std::to_string(cell.count);
                else
                    append_trimmed(text_, cell.number,
                                   cell.kind == ColumnKind::Feed ? kFeedDecimals : kDecimals);
            });
            text_ += '\n';
        }
        out_.write(text_);
    }

    void finish(const std::string& alarm) override {
        if (!alarm.empty()) out_.write("# not complete, ended by " + alarm + '\n');
    }

  private:
    ChosenColumns columns_;
    Output& out_;
    std::string text_;
};

/// The number of rows is known at the end: the header keeps room for it and is written twice.
class NumpyTable final : public SetpointTable {
  public:
    NumpyTable(const machine::Machine& machine, Output& out) : columns_(machine), out_(out) {
        static_assert(std::endian::native == std::endian::little);
        out_.write(header());
    }

    void write(std::span<const motion::Setpoint> setpoints) override {
        bytes_.clear();
        for (const motion::Setpoint& setpoint : setpoints) {
            columns_.for_each(setpoint, [&](const SetpointCell& cell) {
                if (cell.kind == ColumnKind::Count) append(cell.count);
                else append(cell.number);
            });
        }
        rows_ += setpoints.size();
        out_.write(bytes_);
    }

    void finish(const std::string&) override { out_.overwrite(0, header()); }

  private:
    template <typename T>
    void append(T value) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof value);
        std::memcpy(bytes_.data() + at, &value, sizeof value);
    }

    /// Magic, version 1.0, length, and a dictionary of Python, padded with blanks to a multiple of
    /// 64 bytes that is the same for every number of rows.
    std::string header() const {
        constexpr std::size_t kFixed = 10;       // bytes in front of the dictionary
        constexpr std::size_t kMostDigits = 20;  // of the number of rows
        std::string text = "{'descr': [";
        for (const SetpointColumn& column : columns_.columns()) {
            text += "('" + column.name + "', '" +
                    (column.kind == ColumnKind::Count ? "<u4" : "<f8") + "'), ";
        }
        text += "], 'fortran_order': False, 'shape': (";
        const std::string rows = std::to_string(rows_);
        const std::size_t most = kFixed + text.size() + kMostDigits + 5;
        const std::size_t size = (most + 63) / 64 * 64 - kFixed;
        text += rows + ",), }";
        text.resize(size - 1, ' ');
        text += '\n';
        std::string all = "\x93NUMPY";
        all += '\1';
        all += '\0';
        all += static_cast<char>(size & 0xffu);
        all += static_cast<char>(size >> 8u);
        return all + text;
    }

    ChosenColumns columns_;
    Output& out_;
    std::uint64_t rows_ = 0;
    std::string bytes_;
};

}  // namespace

std::unique_ptr<SetpointTable> open_setpoints(const machine::Machine& machine, Output& out) {
    if (out.name().ends_with(".npy")) return std::make_unique<NumpyTable>(machine, out);
    return std::make_unique<CsvTable>(machine, out);
}

}  // namespace kadr::driver
