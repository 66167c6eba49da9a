#include "machine/load_kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "machine/element_reader.h"
#include "machine/number_list.h"

namespace kadr::machine {

namespace {

// In the order of Side and of PathRule.
constexpr std::string_view kSides[] = {"table", "head"};
constexpr std::string_view kPathRules[] = {"1", "2", "3", "sinumerik", "fanuc", "squares"};
constexpr std::string_view kSigns[] = {"+", "-"};
constexpr std::string_view kYesNo[] = {"yes", "no"};

/// A path that is led through the pole leaves the programmed direction by up to this angle; beyond
/// some degrees that is another part.
constexpr double kGreatestPoleTolerance = rad_from_deg(5);

/// A direction with a shorter vector is none.
constexpr double kNoLength = 1e-6;

Vec3 vector_of(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }

class KinematicsReader {
  public:
    KinematicsReader(const XmlElement& element, std::span<const MachineAxis> axes,
                     DiagnosticSink& sink)
        : element_(element), reader_(element, sink), axes_(axes), sink_(sink) {}

    std::optional<Kinematics> read() {
        read_attributes();
        for (const XmlElement& child : element_.children) {
            if (child.name == "rotary") read_rotary(child);
            if (child.name == "tool_rotation") read_tool_rotation(child);
        }
        read_swivel_reference();
        read_vectors();
        check_linear_axes();
        if (!is_sound_) return std::nullopt;
        const auto chain = prepare(kinematics_.chain);
        if (!chain) {
            report_chain(chain.error());
            return std::nullopt;
        }
        kinematics_.chain = *chain;
        return kinematics_;
    }

  private:
    Chain& chain() { return kinematics_.chain; }

    /// The location and the row of a mistake that makes the chain useless.
    template <typename Row>
    auto refuse(const Row& row, const SourceRange& location) {
        is_sound_ = false;
        return sink_.report(row, location);
    }

    void read_attributes() {
        kinematics_.rule =
            static_cast<PathRule>(reader_.choice("path_choice", kPathRules).value_or(1));
        kinematics_.pole_tolerance =
            reader_.magnitude("pole_tolerance", QuantityKind::Angle).value_or(0);
        if (kinematics_.pole_tolerance > kGreatestPoleTolerance) {
            refuse(diag::KinematicsPoleTolerance, reader_.location("pole_tolerance"))
                .arg(reader_.text("pole_tolerance"))
                .arg(deg_from_rad(kGreatestPoleTolerance));
        }
        if (const auto direction = direction_of(reader_, "tool_direction"))
            chain().tool_direction = *direction;
        chain().compensates_parallel = reader_.choice("uvw_compensation", kYesNo).value_or(1) == 0;
        if (chain().compensates_parallel && !has(Axis::U) && !has(Axis::V) && !has(Axis::W))
            refuse(diag::KinematicsWithoutParallel, reader_.location("uvw_compensation"));
    }

    bool has(Axis axis) const {
        return std::ranges::find(axes_, axis, &MachineAxis::axis) != axes_.end();
    }

    /// Three numbers of any length, not all zero.
    std::optional<Vec3> direction_of(const ElementReader& reader, std::string_view attribute) {
        if (!reader.has(attribute)) return std::nullopt;
        const auto numbers = number_list<3>(reader.text(attribute), ' ');
        if (numbers && vector_of(*numbers).norm() > kNoLength)
            return Vec3(vector_of(*numbers).normalized());
        if (numbers) {
            refuse(diag::KinematicsNoDirection, reader.location(attribute)).arg(attribute);
        } else {
            refuse(diag::KinematicsTriple, reader.location(attribute))
                .arg(shown_value(reader.text(attribute)))
                .arg("");
        }
        return std::nullopt;
    }

    /// The rotary axis of the file that a joint names; each of them once.
    void read_axis(const ElementReader& reader, RotaryJoint& joint) {
        const std::string name = reader.text("axis");
        const auto axis = std::ranges::find(axes_, name, &MachineAxis::name);
        if (axis == axes_.end() || !axis->is_rotary) {
            std::string known;
            for (const MachineAxis& other : axes_) {
                if (other.is_rotary) known.append(known.empty() ? "" : ", ").append(other.name);
            }
            auto message = refuse(diag::KinematicsAxis, reader.location("axis"));
            message.arg(name);
            message.note(known.empty() ? "the file describes no rotary axis"
                                       : "the file describes " + known);
            return;
        }
        for (const XmlElement* other : seen_) {
            if (other->find("axis")->value != name) continue;
            refuse(diag::MachineTwice, reader.location("axis"))
                .arg("axis " + name + " of the chain")
                .note(other->find("axis")->value_range, "the first description");
            return;
        }
        seen_.push_back(&reader.element());
        joint.axis = axis->axis;
    }

    void read_rotary(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        if (joints_.size() == 2) {
            refuse(diag::KinematicsThirdRotary, element.range);
            return;
        }
        RotaryJoint& joint = chain().joints[joints_.size()];
        joints_.push_back(&element);
        joint.is_present = true;
        // What is missing has been reported by the check of the shape.
        if (!reader.has("axis") || !reader.has("on") || !reader.has("direction")) is_sound_ = false;
        if (reader.has("axis")) read_axis(reader, joint);
        const auto side = reader.choice("on", kSides);
        if (!side) is_sound_ = false;
        joint.side = static_cast<ChainSide>(side.value_or(0));
        if (const auto direction = direction_of(reader, "direction")) joint.direction = *direction;
        joint.sign = reader.choice("sign", kSigns).value_or(0) == 0 ? 1 : -1;
        if (!reader.has("point")) return;
        if (const auto point = reader.triple("point", QuantityKind::Length))
            joint.point = vector_of(*point);
        else is_sound_ = false;
    }

    void read_tool_rotation(const XmlElement& element) {
        const ElementReader reader(element, sink_);
        RotaryJoint& joint = chain().joints[kPsi];
        if (joint.is_present) {
            refuse(diag::MachineTwice, element.range).arg("the rotation of the tool");
            return;
        }
        spin_ = &element;
        joint.is_present = true;
        joint.side = ChainSide::Head;
        joint.direction = chain().tool_direction;
        if (reader.has("axis")) read_axis(reader, joint);
        joint.sign = reader.choice("sign", kSigns).value_or(0) == 0 ? 1 : -1;
    }

    /// The axis that tells two solutions apart is R1 or R2: both have the same third one.
    void read_swivel_reference() {
        if (!reader_.has("swivel_reference")) return;
        const std::string name = reader_.text("swivel_reference");
        const auto named = std::ranges::find_if(joints_, [&](const XmlElement* joint) {
            const XmlAttribute* axis = joint->find("axis");
            return axis != nullptr && axis->value == name;
        });
        if (named != joints_.end()) {
            kinematics_.swivel_reference = static_cast<std::size_t>(named - joints_.begin());
            return;
        }
        auto message =
            refuse(diag::KinematicsSwivelReference, reader_.location("swivel_reference"));
        message.arg(name);
        for (const XmlElement* joint : joints_)
            message.note(joint->range, "axis " + axis_text(*joint));
    }

    /// The axes lie by points, or by the vectors between them; not by both, and not by neither.
    void read_vectors() {
        const bool has_vectors = reader_.has("l1") || reader_.has("l2");
        for (const XmlElement* joint : joints_) {
            const XmlAttribute* point = joint->find("point");
            if (has_vectors && point != nullptr) {
                refuse(diag::KinematicsTwoPlaces, point->value_range)
                    .note(reader_.location(reader_.has("l1") ? "l1" : "l2"), "the vectors");
            } else if (!has_vectors && point == nullptr) {
                refuse(diag::KinematicsNoPlace, joint->range).arg(axis_text(*joint));
            }
        }
        if (!has_vectors) {
            if (reader_.has("start"))
                refuse(diag::KinematicsHalfVectors, reader_.location("start"))
                    .arg("start")
                    .arg("l2");
            return;
        }
        AxisVectors vectors;
        // With one rotary axis the vector from it to the tool is L2 alone.
        if (joints_.size() == 2 && reader_.has("l1") != reader_.has("l2")) {
            const char* there = reader_.has("l1") ? "l1" : "l2";
            refuse(diag::KinematicsHalfVectors, reader_.location(there))
                .arg(there)
                .arg(reader_.has("l1") ? "l2" : "l1");
        }
        read_vector("l1", vectors.first_to_second);
        read_vector("l2", vectors.second_to_tool);
        read_vector("start", vectors.start);
        place_by_vectors(chain(), vectors);
    }

    void read_vector(std::string_view attribute, Vec3& vector) {
        if (!reader_.has(attribute)) return;
        if (const auto value = reader_.triple(attribute, QuantityKind::Length))
            vector = vector_of(*value);
        else is_sound_ = false;
    }

    /// The tip is held by X, Y and Z; beside one rotary axis the one along it may be missing.
    void check_linear_axes() {
        chain().linear = 0;
        std::vector<Axis> missing;
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
            if (has(axis)) chain().linear |= bit(axis);
            else missing.push_back(axis);
        }
        if (missing.empty()) return;
        if (missing.size() == 1 && joints_.size() == 1) {
            const Vec3& along = chain().joints[kR1].direction;
            if (std::abs(along[static_cast<Eigen::Index>(index(missing[0]))]) > 1 - kNoLength)
                return;
        }
        refuse(diag::KinematicsLinear, element_.range).arg(kAxisNames[index(missing[0])]);
    }

    static std::string axis_text(const XmlElement& joint) {
        const XmlAttribute* axis = joint.find("axis");
        return axis == nullptr ? "" : axis->value;
    }

    SourceRange location_of(std::size_t joint, std::string_view attribute) const {
        return ElementReader(*joints_[joint], sink_).location(attribute);
    }

    void report_chain(ChainFault fault) {
        switch (fault) {
            case ChainFault::NoJoint: sink_.report(diag::KinematicsEmpty, element_.range); return;
            case ChainFault::TableBehindHead:
                sink_.report(diag::KinematicsOrder, location_of(kR2, "on"))
                    .arg(axis_text(*joints_[kR2]))
                    .arg(axis_text(*joints_[kR1]))
                    .note(location_of(kR1, "on"), "the axis on the head");
                return;
            case ChainFault::ParallelJoints:
                sink_.report(diag::KinematicsParallel, location_of(kR2, "direction"))
                    .arg(axis_text(*joints_[kR2]))
                    .arg(axis_text(*joints_[kR1]))
                    .note(location_of(kR1, "direction"), "the other axis");
                return;
            case ChainFault::SecondAlongTool:
                sink_.report(diag::KinematicsAlongTool, location_of(kR2, "direction"))
                    .arg(axis_text(*joints_[kR2]));
                return;
            case ChainFault::SpinWithoutPair:
                sink_.report(diag::KinematicsSpinAlone, spin_->range);
                return;
            // The direction is the tool's own, whatever the file gives.
            case ChainFault::SpinNotAlongTool: break;
        }
        KADR_ASSERT(false, "the rotation of the tool is about the tool");
    }

    const XmlElement& element_;
    ElementReader reader_;
    std::span<const MachineAxis> axes_;
    DiagnosticSink& sink_;
    Kinematics kinematics_;
    std::vector<const XmlElement*> joints_;  // <rotary>, R1 and R2
    std::vector<const XmlElement*> seen_;    // elements whose axis is known
    const XmlElement* spin_ = nullptr;
    bool is_sound_ = true;
};

}  // namespace

std::optional<Kinematics> read_kinematics(const XmlElement& element,
                                          std::span<const MachineAxis> axes, DiagnosticSink& sink) {
    return KinematicsReader(element, axes, sink).read();
}

}  // namespace kadr::machine
