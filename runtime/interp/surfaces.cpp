// surfaces.cpp — milling with the end of a cutter: which cutter it is, and how the surface lies
// that a block's normals give (S 5.3, 7.3).
#include <numbers>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/mill_shape.h"
#include "interp/radius_compensation.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "machine/kinematics.h"
#include "machine/orientation.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Vec3;

/// The cutter that acts, as it touches surfaces; nothing where it touches none, or it was reported.
std::optional<Cutter3d> RadiusCompensation::mill_shape_now(const Block& block) {
    if (!comp_.is_face_milling_acting()) return std::nullopt;
    const std::int64_t number = comp_offset().value_or(0);
    const auto found =
        mill_shape(tool_offsets_, number, extra_.radius + channel_.tool.sum_offset(4));
    if (!found) {
        reporter_.report(diag::CompFaceTool, block, function_of(comp_.side))
            .arg(found.error() == MillShapeFault::EdgeTooLarge
                     ? "its edge is rounded with more than its radius, or with less than nothing"
                     : "its flank is inclined by 90 degrees and more, or inwards");
        return std::nullopt;
    }
    if (!found->is_known && number != 0 && reported_.first_time(RunNotice::ToolShape))
        reporter_.report(diag::CompFaceShape, block, function_of(comp_.side))
            .arg(tool_offsets_.type(number));
    Cutter3d cutter;
    cutter.contact.kind = path::ContactKind::Face;
    cutter.contact.radius = found->radius;
    cutter.contact.depth = found->edge;
    cutter.contact.allowance = comp_.allowance;
    cutter.flank = found->flank;
    return cutter;
}

/// Where the tool is programmed to keep its direction, nothing may change it.
Done RadiusCompensation::require_constant_tool(const Block& block) {
    const bool is_constant = comp_.acting == CompKind::FaceMillingInFrame ||
                             comp_.acting == CompKind::FaceMillingInPlane;
    if (!is_constant || !orienting_.is_on) return kDone;
    reporter_.report(diag::CompFaceTurned, block, function_of(comp_.side));
    return kFailed;
}

Done RadiusCompensation::lay_surface(const Block& block, const ToolWords& tool) {
    const auto normals = channel_.tool_motion.normals_of(block, tool);
    if (!normals) return kFailed;
    const auto arc = machine::great_circle((*normals)[0], (*normals)[1]);
    if (!arc) {
        reporter_.report(diag::CompFaceNormal, block, Function::SurfaceNormal)
            .arg("at the end of the block it points the other way than at its start");
        return kFailed;
    }
    surface_ = {};
    surface_.kind = path::ContactKind::Face;
    surface_.guide = (*normals)[0];
    surface_.axis = arc->axis;
    surface_.turn = arc->turn;
    // Where the tool is led by the surface too, that is still to be asked where the block before
    // ended.
    if (!orienting_.keeps_lead_tilt_to_surface()) orienting_.normal = (*normals)[1];
    return kDone;
}

/// A code by which the side of the cutter is compensated stands inside the tool centre point
/// control, which ends after it. F 4.4.
Done RadiusCompensation::require_tcp_for_peripheral_comp(const Block& block, Function function) {
    if (orienting_.has_length) return kDone;
    reporter_.report(diag::SideCompAlone, block, function);
    return kFailed;
}

Done RadiusCompensation::require_no_peripheral_arc(const Block& block) {
    const bool is_on = comp_.is_on() && comp_.is_peripheral_code;
    if (!is_on || !is_arc(modal_.motion)) return kDone;
    const machine::Chain& chain = machine_.kinematics->chain;
    bool changes_orientation = false;
    bool turns_table = false;
    for (const machine::RotaryJoint& joint : chain.joints) {
        changes_orientation |= joint.is_present && joint.side == machine::ChainSide::Head;
        turns_table |= joint.is_present && joint.side == machine::ChainSide::Table;
    }
    if (!changes_orientation || !turns_table) return kDone;
    reporter_.report(diag::SideCompArc, block, modal_.motion);
    return kFailed;
}

}  // namespace kadr::interp
