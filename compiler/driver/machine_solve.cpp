#include "driver/machine_solve.h"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostics/machine.h"
#include "base/done.h"
#include "base/json_writer.h"
#include "base/numbers.h"
#include "base/put.h"
#include "base/units.h"
#include "machine/number_list.h"
#include "machine/orientation.h"
#include "machine/path_choice.h"

namespace kadr::driver {

namespace {

using machine::Chain;
using machine::ChainPosition;
using machine::kJoints;
using machine::Machine;
using machine::MachineAxis;
using machine::Vec3;

/// Positions by logical axis, as people have them: mm and degrees.
struct SolveWords {
    AxisValues values{};
    AxisMask given = 0;
};

constexpr auto at(std::size_t joint) { return static_cast<Eigen::Index>(joint); }

std::string shown(double value) {
    const double rounded = round_to(value, 6);
    return format_shortest(rounded == 0 ? 0 : rounded);  // no minus in front of zero
}

void put_numbers(JsonWriter& json, const Vec3& values) {
    json.array([&] {
        for (const double value : values) json.rounded(value, 12);
    });
}

/// A machine with a chain, and what is asked of it.
class Solver {
  public:
    Solver(Session& session, const SolveJob& job, const Machine& machine)
        : session_(session),
          job_(job),
          machine_(machine),
          chain_(machine.kinematics->chain),
          tip_(machine::tip_of_length(chain_, job.length)) {}

    std::string forward() {
        const auto words = read_words("--axes", job_.axes);
        if (!words) return {};
        const ChainPosition position = position_of(*words);
        const machine::Pose pose = machine::forward(chain_, position, tip_);
        const Vec3 direction = pose.rotation * chain_.tool_direction;
        if (job_.as_json) return forward_json(position, pose, direction);
        std::string out = head();
        put(out, "axes {}{}\n", words_of(position), outside_text(position));
        put(out, "tip  X{} Y{} Z{}\n", shown(pose.tip.x()), shown(pose.tip.y()),
            shown(pose.tip.z()));
        put(out, "tool {} {} {}\n", shown(direction.x()), shown(direction.y()),
            shown(direction.z()));
        return out;
    }

    std::string backward() {
        const auto target = read_words("--at", job_.at);
        const auto start = read_words("--from", job_.from);
        if (!read_orientation() || !target || !start) return {};
        target_ = {target->values[0], target->values[1], target->values[2]};
        query_.start = position_of(*start).rotary;
        query_.rule = machine_.kinematics->rule;
        query_.pole_tolerance = machine_.kinematics->pole_tolerance;
        query_.mode = job_.follows_vector ? machine::PathMode::Vector : machine::PathMode::Axis;
        set_limits();
        const Vec3 direction = query_.rotation * chain_.tool_direction;
        const bool spins = chain_.has(machine::kPsi) && query_.fixes_spin;
        const auto solutions =
            spins ? machine::solve(chain_, query_.rotation) : machine::solve(chain_, direction);
        if (!solutions) {
            report_reach(solutions.error(), direction);
            return {};
        }
        std::vector<ChainPosition> positions;
        for (const machine::Solution& solution : *solutions)
            positions.push_back(standing(settled(solution).rotary));
        const auto end = machine::choose_path(chain_, query_);
        return job_.as_json ? backward_json(*solutions, positions, end)
                            : text(*solutions, positions, end);
    }

  private:
    using Choice = Result<machine::PathEnd, machine::PathRefusal>;

    // ---------------------------------------------------------------- what was asked

    /// Axis letters with numbers, commas or blanks between them.
    std::optional<SolveWords> read_words(const char* option, const std::string& text) {
        SolveWords words;
        std::string_view rest = machine::trimmed(text);
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find_first_of(", "), rest.size());
            const std::string_view word = rest.substr(0, end);
            rest = rest.substr(std::min(rest.find_first_not_of(", ", end), rest.size()));
            const auto value = machine::plain_number(word.substr(1));
            const MachineAxis* axis = nullptr;
            for (const MachineAxis& candidate : machine_.axes) {
                if (candidate.name == word.substr(0, 1)) axis = &candidate;
            }
            if (!value) {
                session_.messages().report(diag::SolveWord).arg(word).arg(option);
                return std::nullopt;
            }
            if (axis == nullptr) {
                session_.messages()
                    .report(diag::SolveAxis)
                    .arg(machine_.name)
                    .arg(word.substr(0, 1))
                    .arg(option);
                return std::nullopt;
            }
            words.values[index(axis->axis)] = *value;
            words.given |= bit(axis->axis);
        }
        return words;
    }

    /// Direction or angles; without both the tool stands as at base position.
    Done read_orientation() {
        query_ = machine::query_for(chain_, chain_.tool_direction);
        const bool is_euler = !job_.euler.empty();
        const std::string& text = is_euler ? job_.euler : job_.tool;
        if (text.empty()) return kDone;
        const auto numbers = machine::number_list<3>(text, ',');
        if (!numbers) {
            session_.messages()
                .report(diag::SolveWord)
                .arg(text)
                .arg(is_euler ? "--euler" : "--tool");
            return kFailed;
        }
        const Vec3 given = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
        if (is_euler) {
            query_.rotation = machine::euler_zyz(rad_from_deg(1) * given);
            query_.fixes_spin = true;
            return kDone;
        }
        const auto direction = machine::unit_of(given);
        if (!direction) {
            session_.messages().report(diag::SolveNoDirection).arg(text);
            return kFailed;
        }
        query_ = machine::query_for(chain_, *direction);
        return kDone;
    }

    void set_limits() {
        for (std::size_t k = 0; k < kJoints; ++k) {
            if (!chain_.has(k)) continue;
            if (const MachineAxis* axis = machine_.find(chain_.joints[k].axis))
                query_.limits[k] = {axis->lower, axis->upper};
        }
    }

    // ---------------------------------------------------------------- positions

    ChainPosition position_of(const SolveWords& words) const {
        const AxisValues& v = words.values;
        ChainPosition position;
        position.linear = {v[index(Axis::X)], v[index(Axis::Y)], v[index(Axis::Z)]};
        position.parallel = {v[index(Axis::U)], v[index(Axis::V)], v[index(Axis::W)]};
        for (std::size_t k = 0; k < kJoints; ++k) {
            if (chain_.has(k))
                position.rotary[at(k)] = rad_from_deg(v[index(chain_.joints[k].axis)]);
        }
        return position;
    }

    ChainPosition standing(const Vec3& rotary) const {
        ChainPosition position;
        position.rotary = rotary;
        position.linear = machine::inverse_linear(chain_, target_, position, tip_);
        return position;
    }

    /// What is free stays where it is.
    machine::Solution settled(const machine::Solution& solution) const {
        machine::Solution placed = machine::at_pole(chain_, solution, query_.start[machine::kR1]);
        if (!query_.fixes_spin) placed.rotary[machine::kPsi] = query_.start[machine::kPsi];
        return placed;
    }

    /// Where an axis of the machine stands, canonical; nothing for one that is not in the chain.
    double value_of(const MachineAxis& axis, const ChainPosition& position) const {
        for (std::size_t k = 0; k < kJoints; ++k) {
            if (chain_.has(k) && chain_.joints[k].axis == axis.axis) return position.rotary[at(k)];
        }
        if (axis.axis <= Axis::Z) return position.linear[at(index(axis.axis))];
        if (axis.axis >= Axis::U) return position.parallel[at(index(axis.axis) - index(Axis::U))];
        return 0;
    }

    static double shown_unit(const MachineAxis& axis, double value) {
        return axis.is_rotary ? deg_from_rad(value) : value;
    }

    std::string words_of(const ChainPosition& position) const {
        std::string out;
        for (const MachineAxis& axis : machine_.axes) {
            put(out, "{}{}{}", out.empty() ? "" : " ", axis.name,
                shown(shown_unit(axis, value_of(axis, position))));
        }
        return out;
    }

    /// The axes that would leave their limits, and an axis that is not there at all.
    std::vector<std::string> outside(const ChainPosition& position) const {
        constexpr double kSlack = 1e-9;
        std::vector<std::string> texts;
        for (const MachineAxis& axis : machine_.axes) {
            const double value = value_of(axis, position);
            if (value >= axis.lower - kSlack && value <= axis.upper + kSlack) continue;
            texts.push_back(fmt::format(
                "{}{} (limits {}..{})", axis.name, shown(shown_unit(axis, value)),
                shown(shown_unit(axis, axis.lower)), shown(shown_unit(axis, axis.upper))));
        }
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
            constexpr double kInPlane = 1e-6;  // mm
            const double value = position.linear[at(index(axis))];
            if (machine_.find(axis) == nullptr && std::abs(value) > kInPlane)
                texts.push_back(fmt::format("{}{}, an axis that the machine has not",
                                            kAxisNames[index(axis)], shown(value)));
        }
        return texts;
    }

    std::string outside_text(const ChainPosition& position) const {
        std::string out;
        for (const std::string& text : outside(position))
            out += (out.empty() ? "   out of limits: " : ", ") + text;
        return out;
    }

    // ---------------------------------------------------------------- answers

    std::string axis_name(std::size_t joint) const {
        return std::string(kAxisNames[index(chain_.joints[joint].axis)]);
    }

    std::string head() const { return fmt::format("{}: {}\n", machine_.name, machine_.title); }

    std::string text(const machine::Solutions& solutions,
                     const std::vector<ChainPosition>& positions, const Choice& end) const {
        std::string out = head();
        const Vec3 direction = query_.rotation * chain_.tool_direction;
        put(out, "tip X{} Y{} Z{}, tool {} {} {}, length {} mm\n\n", shown(target_.x()),
            shown(target_.y()), shown(target_.z()), shown(direction.x()), shown(direction.y()),
            shown(direction.z()), shown(job_.length));
        put(out, "configuration");
        for (const MachineAxis& axis : machine_.axes) put(out, "{:>13}", axis.name);
        out += '\n';
        for (std::size_t i = 0; i < positions.size(); ++i) {
            put(out, "{:>13}", solutions[i].configuration);
            for (const MachineAxis& axis : machine_.axes)
                put(out, "{:>13}", shown(shown_unit(axis, value_of(axis, positions[i]))));
            if (solutions[i].is_pole) put(out, "   pole: {} is free", axis_name(machine::kR1));
            if (solutions[i].is_equator) out += "   end of the reach";
            put(out, "{}\n", outside_text(positions[i]));
        }
        put(out, "\nfrom {}, {}: {}\n", rotary_words(query_.start),
            job_.follows_vector ? "along the great circle" : "by its axes", choice_text(end));
        return out;
    }

    std::string rotary_words(const Vec3& rotary) const {
        std::string out;
        for (std::size_t k = 0; k < kJoints; ++k) {
            if (!chain_.has(k)) continue;
            put(out, "{}{}{}", out.empty() ? "" : " ", axis_name(k),
                shown(deg_from_rad(rotary[at(k)])));
        }
        return out;
    }

    std::string choice_text(const Choice& end) const {
        std::string out;
        if (!end) {
            out += "no path";
            for (int i = 1; i <= 2; ++i)
                put(out, "; configuration {}: {}", i, refusal_text(end, i));
            return out;
        }
        put(out, "configuration {}, to {}: {}", end->configuration, rotary_words(end->rotary),
            reason_text(*end));
        if (end->is_long) put(out, "; {} goes the long way", axis_name(machine::kR1));
        if (job_.follows_vector && end->mode == machine::PathMode::Axis)
            out += "; not along the great circle, but by axes";
        if (end->passes_pole && !end->switches_at_pole)
            put(out, "; at the pole the motion stops and {} turns", axis_name(machine::kR1));
        out += outside_text(standing(end->rotary));
        return out;
    }

    std::string reason_text(const machine::PathEnd& end) const {
        using machine::PathReason;
        switch (end.reason) {
            case PathReason::OnlyOne: return "the only one that is admitted";
            case PathReason::PoleSwitch:
                return axis_name(machine::kR2) + " alone turns, through the pole";
            case PathReason::LeastSquares:
                return fmt::format("the least sum of squares, {} deg2",
                                   shown(end.sum_squares * std::pow(deg_from_rad(1), 2)));
            case PathReason::LeastFirst: return "the least travel of the leading axis";
            case PathReason::LeastSecond:
                return "equal travels of the leading axis, the least of the other";
            case PathReason::Tie:
                return "as good as the other, which is another configuration or the negative "
                       "direction";
        }
        return {};
    }

    std::string refusal_text(const Choice& end, int configuration) const {
        using machine::CandidateFault;
        const machine::CandidateRefusal& why =
            end.error().configurations[static_cast<std::size_t>(configuration - 1)];
        const std::string axis = axis_name(why.joint) + shown(deg_from_rad(why.value));
        switch (why.fault) {
            case CandidateFault::NoSolution: return "does not exist here";
            case CandidateFault::FirstOutside:
            case CandidateFault::SecondOutside:
            case CandidateFault::SpinOutside: return axis + " is out of limits";
            case CandidateFault::OnlyLongTravel:
                return axis + " is out of limits, and the long way is not admitted";
            case CandidateFault::OtherConfiguration: return "the great circle does not lead there";
            case CandidateFault::LimitOnPath: return axis + " on the way is out of limits";
        }
        return {};
    }

    // ---------------------------------------------------------------- JSON

    void put_head(JsonWriter& json) const {
        json.key("machine").value(machine_.name);
        json.key("length").rounded(job_.length, 6);
    }

    void put_axes(JsonWriter& json, const ChainPosition& position) const {
        json.key("axes").object([&] {
            for (const MachineAxis& axis : machine_.axes)
                json.key_of(axis.name).rounded(shown_unit(axis, value_of(axis, position)), 9);
        });
    }

    void put_outside(JsonWriter& json, const ChainPosition& position) const {
        json.key("outside").array([&] {
            for (const std::string& text : outside(position)) json.value(text);
        });
    }

    std::string forward_json(const ChainPosition& position, const machine::Pose& pose,
                             const Vec3& direction) const {
        std::string out;
        JsonWriter json(out);
        json.object([&] {
            put_head(json);
            put_axes(json, position);
            put_numbers(json.key("tip"), pose.tip);
            put_numbers(json.key("tool"), direction);
            json.key("rotation").array([&] {
                for (int i = 0; i < 3; ++i) put_numbers(json, pose.rotation.row(i).transpose());
            });
        });
        json.end_line();
        return out;
    }

    std::string backward_json(const machine::Solutions& solutions,
                              const std::vector<ChainPosition>& positions,
                              const Choice& end) const {
        std::string out;
        JsonWriter json(out);
        json.object([&] {
            put_head(json);
            put_numbers(json.key("tip"), target_);
            put_numbers(json.key("tool"), query_.rotation * chain_.tool_direction);
            json.key("solutions").array([&] {
                for (std::size_t i = 0; i < positions.size(); ++i)
                    put_solution(json, solutions[i], positions[i]);
            });
            put_choice(json, end);
        });
        json.end_line();
        return out;
    }

    void put_solution(JsonWriter& json, const machine::Solution& solution,
                      const ChainPosition& position) const {
        json.object([&] {
            json.key("configuration").value(solution.configuration);
            put_axes(json, position);
            json.key("pole").value(solution.is_pole);
            json.key("equator").value(solution.is_equator);
            put_outside(json, position);
        });
    }

    void put_choice(JsonWriter& json, const Choice& end) const {
        json.key("choice").object([&] {
            if (end) return put_end(json, *end);
            json.key("refused").array(
                [&] { json.value(refusal_text(end, 1)).value(refusal_text(end, 2)); });
        });
    }

    void put_end(JsonWriter& json, const machine::PathEnd& end) const {
        const ChainPosition position = standing(end.rotary);
        json.key("configuration").value(end.configuration);
        put_axes(json, position);
        json.key("mode").value(end.mode == machine::PathMode::Vector ? "vector" : "axis");
        json.key("long").value(end.is_long);
        json.key("pole_switch").value(end.switches_at_pole);
        json.key("sum_squares").rounded(end.sum_squares * std::pow(deg_from_rad(1), 2), 6);
        json.key("reason").value(reason_text(end));
        put_outside(json, position);
    }

    void report_reach(machine::ReachFault fault, const Vec3& direction) {
        auto message = session_.messages().report(diag::SolveUnreachable);
        message.arg(shown(direction.x()) + ' ' + shown(direction.y()) + ' ' + shown(direction.z()));
        if (fault != machine::ReachFault::OutsideReach) {
            message.note("with one rotary axis the tool reaches the directions of one cone only");
            return;
        }
        const machine::PoleAngleReach reach = machine::pole_angle_reach(chain_);
        message.note(fmt::format(
            "it stands {} deg from axis {}, and the machine reaches {} to {} deg",
            shown(deg_from_rad(machine::pole_angle_of(chain_, direction))), axis_name(machine::kR1),
            shown(deg_from_rad(reach.lower)), shown(deg_from_rad(reach.upper))));
    }

    Session& session_;
    const SolveJob& job_;
    const Machine& machine_;
    const Chain& chain_;
    Vec3 tip_;
    Vec3 target_ = Vec3::Zero();
    machine::PathQuery query_;
};

}  // namespace

Reply solve_machine(Session& session, const SolveJob& job) {
    const auto machine = machine_of(session, job.machine);
    if (!machine) return {session.status(), {}};
    if (!machine->kinematics) {
        session.messages().report(diag::MachineWithoutKinematics).arg(machine->name);
        return {session.status(), {}};
    }
    Solver solver(session, job, *machine);
    std::string text = job.axes.empty() ? solver.backward() : solver.forward();
    return {session.status(), std::move(text)};
}

}  // namespace kadr::driver
