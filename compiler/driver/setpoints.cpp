#include "driver/setpoints.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "base/units.h"
#include "driver/columns.h"

namespace kadr::driver {

namespace {

constexpr int kDecimals = 9;
constexpr int kFeedDecimals = 6;

/// W; the energy on a millimetre of path stays the same as far as the least power lets it.
double beam_power(const machine::Laser& laser, const motion::Setpoint& setpoint) {
    if (!(setpoint.programmed_feed > 0)) return 0;
    const double share = std::min(1.0, setpoint.feed / setpoint.programmed_feed);
    return laser.least_power + (laser.power - laser.least_power) * share;
}

/// Whether setpoints tell of pulses: of the laser at the axes, or of the scanner's.
bool has_pulses(const machine::Machine& machine) {
    return (machine.laser && machine.laser->pulse > 0) ||
           (machine.scanner && machine.scanner->pulse > 0);
}

enum class Kind : std::uint8_t { Length, Feed, Count };

struct Column {
    std::string name;
    Kind kind = Kind::Length;
};

std::vector<Column> columns_of(const machine::Machine& machine) {
    std::vector<Column> columns = {{"t"}};
    for (const machine::MachineAxis& axis : machine.axes) columns.push_back({axis.name});
    for (const char* name : {"tip_x", "tip_y", "tip_z", "tool_i", "tool_j", "tool_k"})
        columns.push_back({name});
    columns.push_back({"feed", Kind::Feed});
    columns.push_back({"iso", Kind::Count});
    if (has_pulses(machine)) columns.push_back({"pulse", Kind::Count});
    if (machine.laser && machine.laser->power > 0) columns.push_back({"power", Kind::Feed});
    return columns;
}

/// Hands a setpoint's values over in the order of the columns.
template <typename Number, typename Count>
void for_columns(const machine::Machine& machine, const motion::Setpoint& setpoint,
                 const Number& number, const Count& count) {
    number(setpoint.time, kDecimals);
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const double value = setpoint.axis[i];
        number(machine.axes[i].is_rotary ? deg_from_rad(value) : value, kDecimals);
    }
    for (int i = 0; i < 3; ++i) number(setpoint.tip[i], kDecimals);
    for (int i = 0; i < 3; ++i) number(setpoint.tool[i], kDecimals);
    number(mm_min_from_feed(setpoint.feed), kFeedDecimals);
    count(setpoint.line);
    if (has_pulses(machine)) count(setpoint.pulses);
    if (machine.laser && machine.laser->power > 0)
        number(beam_power(*machine.laser, setpoint), kFeedDecimals);
}

class CsvTable final : public SetpointTable {
  public:
    CsvTable(const machine::Machine& machine, Output& out) : machine_(machine), out_(out) {
        std::string header;
        for (const Column& column : columns_of(machine))
            header += (header.empty() ? "" : ",") + column.name;
        out_.write(header + '\n');
    }

    void write(std::span<const motion::Setpoint> setpoints) override {
        text_.clear();
        for (const motion::Setpoint& setpoint : setpoints) {
            const std::size_t begin = text_.size();
            for_columns(
                machine_, setpoint,
                [&](double value, int decimals) {
                    if (text_.size() == begin) append_trimmed(text_, value, decimals);
                    else append_column(text_, value, decimals);
                },
                [&](std::uint32_t value) { append_column(text_, value); });
            text_ += '\n';
        }
        out_.write(text_);
    }

    void finish(const std::string& alarm) override {
        if (!alarm.empty()) out_.write("# not complete, ended by " + alarm + '\n');
    }

  private:
    const machine::Machine& machine_;
    Output& out_;
    std::string text_;
};

/// The number of rows is known at the end: the header keeps room for it and is written twice.
class NumpyTable final : public SetpointTable {
  public:
    NumpyTable(const machine::Machine& machine, Output& out) : machine_(machine), out_(out) {
        static_assert(std::endian::native == std::endian::little);
        out_.write(header());
    }

    void write(std::span<const motion::Setpoint> setpoints) override {
        bytes_.clear();
        for (const motion::Setpoint& setpoint : setpoints) {
            for_columns(
                machine_, setpoint, [&](double value, int) { append(value); },
                [&](std::uint32_t value) { append(value); });
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
        for (const Column& column : columns_of(machine_)) {
            text +=
                "('" + column.name + "', '" + (column.kind == Kind::Count ? "<u4" : "<f8") + "'), ";
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

    const machine::Machine& machine_;
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
