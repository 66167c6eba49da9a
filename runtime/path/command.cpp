#include "path/command.h"

namespace kadr::path {

namespace {

/// A shape of which nothing is given. What holds nothing need not be made anew.
template <typename T>
void put_shape(Shape& shape) {
    if (auto* same = std::get_if<T>(&shape)) *same = T{};
    else shape.emplace<T>();
}

/// A boxed one is there from the beginning.
template <typename T>
void put_boxed_shape(Shape& shape) {
    if (auto* same = std::get_if<Boxed<T>>(&shape)) *same = T{};
    else shape.emplace<Boxed<T>>(T{});
}

}  // namespace

void Motion::become(Op op) {
    switch (op) {
        case Op::Rapid: return put_shape<RapidShape>(shape);
        case Op::Line: return put_shape<LineShape>(shape);
        case Op::Arc: return put_shape<ArcShape>(shape);
        case Op::Spline: return put_boxed_shape<SplineShape>(shape);
        case Op::Involute: return put_shape<InvoluteShape>(shape);
        case Op::Parametric: return put_boxed_shape<CurveShape>(shape);
        case Op::Thread: return put_shape<ThreadShape>(shape);
        case Op::Probe: return put_shape<ProbeShape>(shape);
        default: KADR_ASSERT(is_motion(op), "a motion stays one");
    }
}

const OrientDetails& Motion::orientation() const {
    static const OrientDetails kNone;
    return orient_details ? *orient_details : kNone;
}

const VirtualAxes& Motion::virtual_axes() const {
    static const VirtualAxes kNone;
    return virtual_system ? *virtual_system : kNone;
}

Mark::Mark(Op op) : op_(op) {
    KADR_ASSERT(op == Op::Stop || op == Op::OptionalStop || op == Op::End || op == Op::ScannerOn ||
                    op == Op::ScannerOff,
                "a mark says no more than its name");
}

void Command::become(Op op) {
    switch (op) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Spline:
        case Op::Involute:
        case Op::Parametric:
        case Op::Thread:
        case Op::Probe:
            if (!is_motion()) what_.emplace<Motion>();
            return motion().become(op);
        case Op::Dwell: what_.emplace<Dwell>(); return;
        case Op::Spindle: what_.emplace<Spindle>(); return;
        case Op::OtherSpindle: what_.emplace<Spindle>().is_master = false; return;
        case Op::SpeedLimit: what_.emplace<SpeedLimit>(); return;
        case Op::Tool: what_.emplace<ToolChange>(); return;
        case Op::ToolLength: what_.emplace<ToolLength>(); return;
        case Op::Coolant: what_.emplace<Coolant>(); return;
        case Op::Function: what_.emplace<MFunction>(); return;
        case Op::Message: what_.emplace<Message>(); return;
        case Op::External: what_.emplace<External>(); return;
        case Op::Stop:
        case Op::OptionalStop:
        case Op::End:
        case Op::ScannerOn:
        case Op::ScannerOff: what_.emplace<Mark>(op); return;
    }
}

Op Command::other_op() const {
    return std::visit([](const auto& what) { return what.op(); }, what_);
}

}  // namespace kadr::path
