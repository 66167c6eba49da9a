#include "driver/compare.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/done.h"
#include "base/json_writer.h"
#include "base/numbers.h"
#include "base/put.h"
#include "base/units.h"
#include "driver/execution.h"
#include "driver/output.h"
#include "driver/summary.h"
#include "motion/comparison.h"
#include "process/planned_motion.h"

namespace kadr::driver {

namespace {

using motion::ComparedPoint;
using motion::Comparison;
using motion::Parting;

/// One of the two: a session of its own, for it may be for another control.
class ComparedProgram {
  public:
    ComparedProgram(Session& session, const std::string& source, const std::string& dialect)
        : session_(options_for_machine(session, dialect), session.inputs(), session.sources(),
                   session.messages()),
          source_(source) {}

    Done open() {
        auto text = open_source(session_, source_);
        if (!text) return kFailed;
        execution_ = Execution::open(session_, source_, std::move(text));
        if (!execution_) return kFailed;
        motion::PlannerOptions options;
        execution_->place_messages(options);
        motion_ = std::make_unique<process::PlannedMotion>(*execution_, execution_->machine(),
                                                           options, execution_->sink());
        return kDone;
    }

    Status status() const { return session_.status(); }
    process::PlannedMotion& motion() { return *motion_; }
    motion::Totals totals() const { return motion_->totals(); }
    const machine::Chain& chain() const {
        const auto& kinematics = execution_->machine().kinematics;
        return kinematics ? kinematics->chain : motion::kNoChain;
    }
    /// Plans what is left, for its time.
    void finish() {
        std::vector<motion::Segment> batch(kBatch);
        while (motion_->pull(batch) > 0) continue;
    }
    std::string_view control() const { return execution_->dialect().title(); }
    std::string text_name() const {
        return std::filesystem::path(execution_->text_name()).filename().string();
    }
    std::string place(std::uint32_t line) const {
        if (macro::NcProgram::is_in_main_text(line))
            return text_name() + ':' + std::to_string(line);
        const TextLocation called = execution_->location_of(line);
        return std::filesystem::path(called.file).filename().string() + ':' +
               std::to_string(called.line);
    }

  private:
    static Options options_for(const Session& session, const std::string& dialect) {
        Options options = session.options();
        options.dialect = dialect;
        return options;
    }
    /// With its options. Where nobody names a machine it is the stock one with tools and offsets:
    /// on an empty one the length of another tool and another work offset move alike.
    static Options options_for_machine(Session& session, const std::string& dialect) {
        Options options = options_for(session, dialect);
        if (!options.machine.empty()) return options;
        Session asked(options, session.inputs(), session.sources(), session.messages());
        options.machine = asked.stock_machine() + "-set-up";
        options.has_stand_in_tools = true;
        return options;
    }

    Session session_;
    std::string source_;
    std::unique_ptr<Execution> execution_;
    std::unique_ptr<process::PlannedMotion> motion_;
};

const char* words_of(Parting parting) {
    switch (parting) {
        case Parting::Path: return "the paths part";
        case Parting::Kind: return "one cuts or stands where the other does not";
        case Parting::Length: return "one stops before the other";
        case Parting::Followers: return "an axis beside X, Y, Z is elsewhere";
        case Parting::Standing: return "they stand for different times";
        case Parting::Pitch: return "the pitches of their threads differ";
        case Parting::Gear: return "the spindle leads one, and the other goes at its feed";
        case Parting::Start: return "their threads begin at other angles of the spindle";
        case Parting::Spindle: return "the spindle turns otherwise";
        case Parting::Pulses: return "the laser burns other points";
        case Parting::Marks: return "the module beside the axes does something else";
        case Parting::End: return "one ends before the other";
    }
    return "";
}

const char* name_of(Parting parting) {
    constexpr std::array<const char*, 12> kNames = {"way",      "kind",   "length", "followers",
                                                    "standing", "pitch",  "gear",   "start",
                                                    "spindle",  "pulses", "marks",  "end"};
    return kNames[static_cast<std::size_t>(parting)];
}

std::string point_text(const path::Vec3& point) {
    return fmt::format("X{} Y{} Z{}", format_shortest(round_to(point.x(), 4)),
                       format_shortest(round_to(point.y(), 4)),
                       format_shortest(round_to(point.z(), 4)));
}

/// "239.5 rpm", "120 m/min, counter-clockwise", "it stands".
std::string spindle_text(const motion::CommandedSpindle& spindle) {
    if (!spindle.is_turning) return "it stands";
    const std::string speed =
        spindle.holds_cutting_speed
            ? format_shortest(round_to(spindle.cutting_speed * 60 / 1000, 3)) + " m/min"
            : format_shortest(round_to(spindle.speed * 60, 3)) + " rpm";
    return speed + (spindle.is_counterclockwise ? ", counter-clockwise" : "");
}

std::string comparison_text(const Comparison& result, const std::array<ComparedProgram*, 2>& sides,
                            double tolerance) {
    std::string out;
    for (const ComparedProgram* side : sides) {
        put(out, "  {:<20}{:<34}{:>12}{:>12.1f} mm\n", side->text_name(), side->control(),
            duration_text(side->totals().time), side->totals().length);
    }
    const auto report = [&](const ComparedPoint& point) {
        const bool by_spindle = result.parting == Parting::Spindle;
        const auto behind = [&](const motion::CommandedSpindle& spindle) {
            return by_spindle ? "   " + spindle_text(spindle) : std::string();
        };
        put(out, "    {:<24}{}{}\n    {:<24}{}{}\n", sides[0]->place(point.first_line),
            point_text(point.first), behind(result.first_spindle),
            sides[1]->place(point.second_line), point_text(point.second),
            behind(result.second_spindle));
    };
    if (result.parting) {
        put(out, "\n  not the same motion: {}, after {} stretches alike\n",
            words_of(*result.parting), result.stretches > 0 ? result.stretches - 1 : 0);
        report(result.parted);
        return out;
    }
    put(out, "\n  the same motion within {} mm: {} stretches, {:.1f} um apart at most\n",
        format_shortest(tolerance), result.stretches, 1000 * result.greatest_distance);
    if (result.greatest_distance > 0) report(result.widest);
    if (result.greatest_feed_share > 0) {
        put(out, "  feeds within {:.3g} %\n", 100 * result.greatest_feed_share);
        report(result.fastest);
    }
    return out;
}

void put_point(JsonWriter& json, JsonName name, const ComparedPoint& point,
               const std::array<ComparedProgram*, 2>& sides) {
    const std::array<std::uint32_t, 2> lines = {point.first_line, point.second_line};
    const std::array<path::Vec3, 2> points = {point.first, point.second};
    json.key(name).array([&] {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            json.object([&] {
                json.key("at").value(sides[i]->place(lines[i]));
                json.key("x").rounded(points[i].x(), 9);
                json.key("y").rounded(points[i].y(), 9);
                json.key("z").rounded(points[i].z(), 9);
            });
        }
    });
}

std::string comparison_json(const Comparison& result,
                            const std::array<ComparedProgram*, 2>& sides) {
    std::string out;
    JsonWriter json(out);
    json.object([&] {
        json.key("same").value(!result.parting.has_value());
        if (result.parting) json.key("parting").value(name_of(*result.parting));
        json.key("stretches").value(result.stretches);
        json.key("distance_mm").rounded(result.greatest_distance, 9);
        json.key("feed_share").rounded(result.greatest_feed_share, 9);
        json.key("time_s").array([&] {
            for (const ComparedProgram* side : sides) json.rounded(side->totals().time, 9);
        });
        json.key("length_mm").array([&] {
            for (const ComparedProgram* side : sides) json.rounded(side->totals().length, 9);
        });
        if (result.parting) put_point(json, "parted", result.parted, sides);
        else put_point(json, "widest", result.widest, sides);
    });
    json.end_line();
    return out;
}

}  // namespace

Status compare(Session& session, const CompareJob& job) {
    ComparedProgram first(session, job.sources[0], job.dialects[0]);
    ComparedProgram second(session, job.sources[1], job.dialects[1]);
    const std::array<ComparedProgram*, 2> sides = {&first, &second};
    for (ComparedProgram* side : sides) {
        if (!side->open()) return side->status() == Status::Done ? Status::Failed : side->status();
    }
    const Comparison result =
        motion::compare(first.motion(), second.motion(), job.tolerance, first.chain());
    for (ComparedProgram* side : sides) side->finish();
    const Status status = session.status();
    if (status != Status::Done) return status;
    auto output = Output::open(session.files(), "-", session.messages(), session.output_rules());
    if (!output) return Status::Usage;
    output->write(job.summary == SummaryFormat::Json
                      ? comparison_json(result, sides)
                      : comparison_text(result, sides, job.tolerance));
    if (!output->commit(session.messages())) return Status::Usage;
    return result.parting ? Status::Failed : Status::Done;
}

}  // namespace kadr::driver
