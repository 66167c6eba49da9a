#include "machine/load_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "machine/element_reader.h"
#include "machine/number_list.h"

namespace kadr::machine {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// M functions below are the control's own everywhere.
constexpr std::int64_t kFirstFunction = 10;
constexpr std::int64_t kLastFunction = 99'999'999;
constexpr std::int64_t kLongestList = 1'000'000;

// A determinant below this turns a field of a metre into a line of a thousandth of a millimetre.
constexpr double kFlat = 1e-6;
// Times and positions of a few decimals differ by less when they are meant alike.
constexpr double kRounding = 1e-9;

constexpr std::string_view kPolygonKinds[] = {"fixed", "turning"};
constexpr std::string_view kTableHeader = "x [mm],y [mm],dx [mm],dy [mm]";

std::string shown(double value) { return format_shortest(round_to(value, 6)); }

// ------------------------------------------------------------------------------ the table

/// A row of the table, and where it stands.
struct GridRow {
    std::array<double, 4> values{};
    SourceRange location;
};

/// Rows into a grid: every x with every y.
class GridBuilder {
  public:
    explicit GridBuilder(DiagnosticSink& sink) : sink_(sink) {}

    void add(const GridRow& row) {
        const auto key = std::pair(row.values[1], row.values[0]);
        const auto [first, is_new] = rows_.emplace(key, row);
        if (is_new) return;
        sink_.report(diag::MachineTwice, row.location)
            .arg("the correction at " + words(key))
            .note(first->second.location, "the first description");
        is_sound_ = false;
    }

    std::optional<FieldGrid> grid(const SourceRange& location) {
        FieldGrid grid;
        for (const auto& [key, row] : rows_) {
            grid.x.push_back(key.second);
            grid.y.push_back(key.first);
        }
        for (std::vector<double>* values : {&grid.x, &grid.y}) {
            std::ranges::sort(*values);
            values->erase(std::unique(values->begin(), values->end()), values->end());
        }
        if (grid.x.size() < 2 || grid.y.size() < 2) {
            sink_.report(diag::ScannerTableGap, location)
                .arg("two values of x and two of y at least");
            return std::nullopt;
        }
        for (const double y : grid.y) {
            for (const double x : grid.x) {
                const auto row = rows_.find({y, x});
                if (row == rows_.end()) {
                    sink_.report(diag::ScannerTableGap, location)
                        .arg("the row of " + words({y, x}));
                    return std::nullopt;
                }
                grid.dx.push_back(row->second.values[2]);
                grid.dy.push_back(row->second.values[3]);
            }
        }
        if (!is_sound_) return std::nullopt;
        return grid;
    }

  private:
    /// The key is y, x: the order of the grid.
    static std::string words(const std::pair<double, double>& key) {
        return "x " + shown(key.second) + ", y " + shown(key.first);
    }

    DiagnosticSink& sink_;
    std::map<std::pair<double, double>, GridRow> rows_;
    bool is_sound_ = true;
};

// ------------------------------------------------------------------------------ the element

class ScannerReader {
  public:
    ScannerReader(const XmlElement& element, Sources& sources, DiagnosticSink& sink)
        : element_(element), reader_(element, sink), sources_(sources), sink_(sink) {}

    Scanner read() {
        read_functions();
        scanner_.half_field = reader_.positive("field", QuantityKind::Length).value_or(2) / 2;
        scanner_.jump_speed = reader_.positive("jump_speed", QuantityKind::Velocity).value_or(1);
        scanner_.mark_speed =
            reader_.positive("mark_speed", QuantityKind::Velocity).value_or(kInfinity);
        scanner_.step = reader_.positive("step", QuantityKind::Time).value_or(scanner_.step);
        scanner_.pulse = reader_.positive("pulse", QuantityKind::Frequency).value_or(0);
        scanner_.chord_tolerance = reader_.positive("chord_tolerance", QuantityKind::Length)
                                       .value_or(scanner_.chord_tolerance);
        scanner_.list_size =
            static_cast<std::size_t>(reader_.whole("list_size", 1, kLongestList)
                                         .value_or(static_cast<std::int64_t>(scanner_.list_size)));
        read_delays();
        read_matrix();
        read_correction();
        return std::move(scanner_);
    }

  private:
    void read_functions() {
        scanner_.on_function = reader_.whole("on", kFirstFunction, kLastFunction).value_or(0);
        scanner_.off_function = reader_.whole("off", kFirstFunction, kLastFunction).value_or(0);
        if (scanner_.on_function != 0 && scanner_.on_function == scanner_.off_function) {
            sink_.report(diag::ScannerOneFunction, reader_.location("off"))
                .arg(scanner_.off_function);
        }
    }

    void read_delays() {
        ScannerDelays& delays = scanner_.delays;
        delays.jump = reader_.magnitude("jump_delay", QuantityKind::Time).value_or(0);
        delays.mark = reader_.magnitude("mark_delay", QuantityKind::Time).value_or(0);
        delays.polygon = reader_.magnitude("polygon_delay", QuantityKind::Time).value_or(0);
        delays.polygon_turning = reader_.choice("polygon", kPolygonKinds).value_or(0) == 1;
        delays.laser_on = reader_.quantity("laser_on_delay", QuantityKind::Time).value_or(0);
        delays.laser_off = reader_.magnitude("laser_off_delay", QuantityKind::Time).value_or(0);
        if (delays.laser_off > delays.mark + kRounding)
            report_beam("laser_off_delay", delays.laser_off, "mark_delay", delays.mark);
        if (-delays.laser_on > delays.jump + kRounding)
            report_beam("laser_on_delay", delays.laser_on, "jump_delay", delays.jump);
    }

    void report_beam(const char* beam, double beam_delay, const char* motion, double delay) {
        sink_.report(diag::ScannerBeamJumps, reader_.location(beam))
            .arg(beam)
            .arg(round_to(beam_delay * 1e6, 3))
            .arg(motion)
            .arg(round_to(delay * 1e6, 3));
    }

    void read_matrix() {
        if (!reader_.has("matrix")) return;
        const std::string text = reader_.text("matrix");
        const auto matrix = number_list<4>(text, ' ');
        if (matrix && std::abs((*matrix)[0] * (*matrix)[3] - (*matrix)[1] * (*matrix)[2]) > kFlat) {
            scanner_.matrix = *matrix;
            return;
        }
        sink_.report(diag::ScannerMatrix, reader_.location("matrix")).arg(shown_value(text));
    }

    void read_correction() {
        if (!reader_.has("correction")) return;
        const std::string name = reader_.text("correction");
        const std::filesystem::path folder =
            std::filesystem::path(sources_.name(element_.range.file)).parent_path();
        const auto file = sources_.read((folder / name).string());
        if (!file) {
            sink_.report(diag::FileUnreadable, reader_.location("correction"))
                .arg((folder / name).string());
            return;
        }
        const auto grid = read_field_grid(*file, sources_, sink_);
        if (!grid) return;
        scanner_.correction = *grid;
        const double half = scanner_.half_field;
        for (const std::vector<double>* values : {&grid->x, &grid->y}) {
            if (values->front() <= -half + kRounding && values->back() >= half - kRounding)
                continue;
            sink_.report(diag::ScannerTableSmall, reader_.location("correction"))
                .arg(shown(values->front()))
                .arg(shown(values->back()))
                .arg(shown(half));
            return;
        }
    }

    const XmlElement& element_;
    ElementReader reader_;
    Sources& sources_;
    DiagnosticSink& sink_;
    Scanner scanner_;
};

}  // namespace

std::optional<FieldGrid> read_field_grid(FileId file, const Sources& sources,
                                         DiagnosticSink& sink) {
    const std::string_view text = sources.text(file);
    GridBuilder builder(sink);
    bool has_header = false;
    bool is_sound = true;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = trimmed(text.substr(begin, end - begin));
        const SourceRange location{file, static_cast<std::uint32_t>(begin),
                                   static_cast<std::uint32_t>(begin + line.size())};
        begin = end + 1;
        if (line.empty() || line.starts_with('#')) continue;
        if (!has_header) {
            has_header = true;
            if (line == kTableHeader) continue;
            sink.report(diag::ScannerTableRow, location)
                .arg(shown_value(line))
                .arg("the header `" + std::string(kTableHeader) + "`");
            return std::nullopt;
        }
        if (const auto values = number_list<4>(line, ',')) {
            builder.add({*values, location});
            continue;
        }
        sink.report(diag::ScannerTableRow, location).arg(shown_value(line)).arg("four numbers");
        is_sound = false;
    }
    if (!is_sound) return std::nullopt;
    return builder.grid({file, 0, 0});
}

Scanner read_scanner(const XmlElement& element, Sources& sources, DiagnosticSink& sink) {
    return ScannerReader(element, sources, sink).read();
}

}  // namespace kadr::machine
