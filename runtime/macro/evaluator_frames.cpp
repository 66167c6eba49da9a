// evaluator_frames.cpp — functions of axes and of frames.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/text.h"
#include "machine/machine.h"
#include "macro/evaluator.h"

namespace kadr::macro {

using nc::Operation;

Done Evaluator::axis_function(Operation operation, ControlValue* a) {
    switch (operation) {
        case Operation::ToAxis:
            return a->axis() ? kDone : fail(diag::AxisExpected, {std::string(kind_name(*a))});
        case Operation::AxisNumber: {
            auto axis = a->axis();
            // Where no value is an axis, its name is a number below 0.
            if (!axis && a->is_number() && a->number < 0 &&
                a->number >= -static_cast<double>(kAxes))
                axis = static_cast<Axis>(std::llround(-a->number) - 1);
            if (!axis) return fail(diag::AxisExpected, {std::string(kind_name(*a))});
            const auto number = variables_.axis_number(*axis);
            if (!number)
                return fail(diag::AxisNameUnknown, {std::string(kAxisNames[index(*axis)])});
            *a = ControlValue::of(static_cast<double>(*number), nc::ValueType::Int);
            return kDone;
        }
        case Operation::SpindleAxis: {
            const double number = a->number;
            if (!a->is_number()) return fail(diag::IndexType, {std::string(kind_name(*a))});
            const bool is_there = number == std::floor(number) && number >= 0 &&
                                  number <= machine::kMostSpindles &&
                                  variables_.has_spindle(static_cast<std::int64_t>(number));
            if (!is_there) return fail(diag::SpindleMissing, {format_shortest(number)});
            *a = ControlValue::spindle_of(number == 0 ? 1 : number);
            return kDone;
        }
        case Operation::SpindleNumber:
            if (a->kind != ControlValue::Kind::Axis)
                return fail(diag::AxisExpected, {std::string(kind_name(*a))});
            if (!a->spindle())
                return fail(diag::SpindleMissing,
                            {a->axis() ? "of the axis " + std::string(kAxisNames[index(*a->axis())])
                                       : "of no axis"});
            *a = ControlValue::of(static_cast<double>(*a->spindle()), nc::ValueType::Int);
            return kDone;
        case Operation::ModuloValue: {
            const auto axis = a->axis();
            if (!axis) return fail(diag::AxisExpected, {std::string(kind_name(*a))});
            if (!a[1].is_number())
                return fail(diag::TypesDiffer, {"a calculation", std::string(kind_name(a[1]))});
            if (!is_rotary(*axis)) return real(*a, a[1].number);
            constexpr double kTurn = 360;
            const double rest = std::fmod(a[1].number, kTurn);
            return real(*a, rest < 0 ? rest + kTurn : rest);
        }
        case Operation::TextOfAxis:
            if (a->spindle()) {
                *a = keep_text("S" + std::to_string(*a->spindle()));
                return kDone;
            }
            if (!a->axis()) return fail(diag::AxisExpected, {std::string(kind_name(*a))});
            *a = keep_text(std::string(kAxisNames[index(*a->axis())]));
            return kDone;
        case Operation::AxisOfText: {
            if (!a->is_text())
                return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(*a))});
            const auto found = std::ranges::find(kAxisNames, upper_ascii(text(*a)));
            if (found == kAxisNames.end())
                return fail(diag::AxisNameUnknown, {std::string(text(*a))});
            *a = ControlValue::of(-1.0 - static_cast<double>(found - kAxisNames.begin()),
                                  nc::ValueType::Axis);
            return kDone;
        }
        default:
            *a = ControlValue::truth(a->is_number() && a->number >= 1 && a->number <= 3);
            return kDone;
    }
}

/// Axes and their values in turn; lengths in mm.
Done Evaluator::pairs(Operation operation, const ControlValue* a, int count,
                      std::vector<control::AxisAndValue>& out) {
    const bool is_distance =
        operation == Operation::FrameShift || operation == Operation::FrameFine;
    for (int i = 0; i + 1 < count; i += 2) {
        const auto axis = a[i].axis();
        if (!axis) return fail(diag::AxisExpected, {std::string(kind_name(a[i]))});
        if (!a[i + 1].is_number()) {
            return fail(diag::TypesDiffer,
                        {"a component of a frame", std::string(kind_name(a[i + 1]))});
        }
        out.push_back({*axis, a[i + 1].number * (is_distance ? variables_.axis_unit(*axis) : 1)});
        if (!is_distance && index(*axis) >= 3) {
            return fail(diag::IsoNotSupported,
                        {"a rotation or a scale of an axis besides X, Y and Z"});
        }
    }
    return kDone;
}

Done Evaluator::frame_function(Operation operation, ControlValue* a, int count) {
    if (operation == Operation::Chain || operation == Operation::FrameInverse) {
        for (int i = 0; i < count; ++i) {
            if (!a[i].is_frame())
                return fail(diag::TypesDiffer, {"a frame", std::string(kind_name(a[i]))});
        }
        *a = keep_frame(operation == Operation::Chain ? chain(*frame(a[0]), *frame(a[1]))
                                                      : inverse(*frame(a[0])));
        return kDone;
    }
    if (operation == Operation::FrameMirror) {
        AxisMask axes = 0;
        for (int i = 0; i < count; ++i) {
            if (!a[i].axis()) return fail(diag::AxisExpected, {std::string(kind_name(a[i]))});
            axes = static_cast<AxisMask>(axes | bit(*a[i].axis()));
        }
        *a = keep_frame(control::mirror_frame(axes));
        return kDone;
    }
    if (operation == Operation::FrameInPlane) return plane_rotation(a);
    std::vector<control::AxisAndValue> given;
    if (!pairs(operation, a, count, given)) return kFailed;
    switch (operation) {
        case Operation::FrameShift: *a = keep_frame(control::shift_frame(given)); return kDone;
        case Operation::FrameFine: *a = keep_frame(control::fine_frame(given)); return kDone;
        case Operation::FrameRotation:
            *a = keep_frame(control::rotation_frame(given));
            return kDone;
        case Operation::FrameSolid:
            if (given.size() > 2) return fail(diag::SolidAngles, {std::to_string(given.size())});
            if (given.size() == 2 && given[0].axis == given[1].axis)
                return fail(diag::SolidAngles, {"of one axis"});
            *a = keep_frame(control::solid_frame(given));
            return kDone;
        default: break;
    }
    for (const control::AxisAndValue& one : given)
        if (one.value == 0) return fail(diag::ScaleInvalid, {"0"});
    *a = keep_frame(control::scale_frame(given));
    return kDone;
}

/// Its first operand is the axis across the plane, or the number of the plane.
Done Evaluator::plane_rotation(ControlValue* a) {
    std::optional<Axis> across = a[0].axis();
    if (!across) {
        if (!a[0].is_number()) return fail(diag::AxisExpected, {std::string(kind_name(a[0]))});
        static constexpr std::array kAcross = {Axis::Z, Axis::Y, Axis::X};
        const double plane = a[0].number;
        if (plane == 0) {
            double axis = 0;
            if (!answer(variables_.system(nc::SystemQuantity::NormalAxis, 0, 0, axis)))
                return kFailed;
            across = ControlValue::of(axis, nc::ValueType::Axis).axis();
        } else if (plane == 1 || plane == 2 || plane == 3) {
            across = kAcross[static_cast<std::size_t>(plane) - 1];
        }
    }
    if (!across)
        return fail(diag::ArgumentRange,
                    {variables_.word_of(operation_), format_shortest(a[0].number)});
    if (!a[1].is_number())
        return fail(diag::TypesDiffer, {"a component of a frame", std::string(kind_name(a[1]))});
    if (index(*across) >= 3)
        return fail(diag::IsoNotSupported, {"a rotation or a scale of an axis besides X, Y and Z"});
    const control::AxisAndValue angle{*across, a[1].number};
    *a = keep_frame(control::rotation_frame({&angle, 1}));
    return kDone;
}

}  // namespace kadr::macro
