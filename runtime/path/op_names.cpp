#include "path/op_names.h"

namespace kadr::path {

std::string_view op_name(Op op) {
    switch (op) {
        case Op::Rapid: return "rapid";
        case Op::Line: return "line";
        case Op::Arc: return "arc";
        case Op::Spline: return "spline";
        case Op::Involute: return "involute";
        case Op::Parametric: return "curve";
        case Op::Thread: return "thread";
        case Op::Probe: return "probe";
        case Op::Dwell: return "dwell";
        case Op::Spindle: return "spindle";
        case Op::OtherSpindle: return "other_spindle";
        case Op::SpeedLimit: return "speed_limit";
        case Op::Tool: return "tool";
        case Op::ToolLength: return "tool_length";
        case Op::Coolant: return "coolant";
        case Op::Function: return "function";
        case Op::Stop: return "stop";
        case Op::OptionalStop: return "optional_stop";
        case Op::Message: return "message";
        case Op::End: return "end";
        case Op::ScannerOn: return "scanner_on";
        case Op::ScannerOff: return "scanner_off";
        case Op::External: return "external";
    }
    return "";
}

std::optional<Op> find_op(std::string_view name) {
    for (Op op = Op::Rapid; op <= Op::External; op = static_cast<Op>(static_cast<int>(op) + 1)) {
        if (op_name(op) == name) return op;
    }
    return std::nullopt;
}

std::vector<std::string_view> op_names() {
    std::vector<std::string_view> names;
    for (Op op = Op::Rapid; op <= Op::External; op = static_cast<Op>(static_cast<int>(op) + 1))
        names.push_back(op_name(op));
    return names;
}

}  // namespace kadr::path
