// load_probe.cpp — <probe> of a machine file.
#include <array>
#include <string>
#include <string_view>

#include "base/diagnostics/machine.h"
#include "machine/element_reader.h"
#include "machine/probe.h"

namespace kadr::machine {

namespace {

constexpr std::string_view kAxes3[] = {"X", "Y", "Z"};
constexpr std::string_view kSides[] = {"below", "above"};
constexpr std::string_view kEnds[] = {"lowest", "center"};
constexpr std::int64_t kMostOffsets = 306;

path::Vec3 vector_of(const std::optional<std::array<double, 3>>& values) {
    return values ? path::Vec3((*values)[0], (*values)[1], (*values)[2]) : path::Vec3::Zero();
}

ProbeSolid read_plane(const ElementReader& reader) {
    ProbeSolid plane;
    plane.kind = ProbeSolid::Kind::Plane;
    plane.axis = reader.choice("axis", kAxes3).value_or(2);
    plane.at = reader.quantity("at", QuantityKind::Length).value_or(0);
    plane.is_above = reader.choice("material", kSides).value_or(0) == 1;
    return plane;
}

ProbeSolid read_block(const ElementReader& reader, DiagnosticSink& sink) {
    ProbeSolid block;
    const auto from = reader.triple("from", QuantityKind::Length);
    const auto to = reader.triple("to", QuantityKind::Length);
    block.from = vector_of(from).cwiseMin(vector_of(to));
    block.to = vector_of(from).cwiseMax(vector_of(to));
    for (std::size_t i = 0; from && to && i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if (block.from[at] < block.to[at]) continue;
        sink.report(diag::ProbeBlockFlat, reader.location("to")).arg(kAxes3[i]);
    }
    return block;
}

ProbeSolid read_boss(const ElementReader& reader) {
    ProbeSolid boss;
    boss.kind = ProbeSolid::Kind::Boss;
    boss.from = vector_of(reader.triple("center", QuantityKind::Length));
    boss.radius = reader.positive("diameter", QuantityKind::Length).value_or(1) / 2;
    if (const auto height = reader.positive("height", QuantityKind::Length)) boss.height = *height;
    return boss;
}

ProbeBore read_bore(const ElementReader& reader) {
    ProbeBore bore;
    bore.center = vector_of(reader.triple("center", QuantityKind::Length));
    bore.radius = reader.positive("diameter", QuantityKind::Length).value_or(1) / 2;
    if (const auto depth = reader.positive("depth", QuantityKind::Length)) bore.depth = *depth;
    return bore;
}

}  // namespace

ProbeScene read_probe(const XmlElement& element, DiagnosticSink& sink) {
    const ElementReader reader(element, sink);
    ProbeScene scene;
    scene.radius = reader.magnitude("radius", QuantityKind::Length);
    scene.is_center_given = reader.choice("length_to", kEnds).value_or(0) == 1;
    if (reader.has("offset")) scene.offset = reader.whole("offset", 1, kMostOffsets).value_or(0);
    scene.error = vector_of(reader.triple("error", QuantityKind::Length));
    for (const XmlElement& child : element.children) {
        const ElementReader of(child, sink);
        if (child.name == "plane") scene.solids.push_back(read_plane(of));
        if (child.name == "block") scene.solids.push_back(read_block(of, sink));
        if (child.name == "boss") scene.solids.push_back(read_boss(of));
        if (child.name == "bore") scene.bores.push_back(read_bore(of));
    }
    if (scene.solids.empty() && scene.bores.empty())
        sink.report(diag::ProbeMeetsNothing, element.range);
    return scene;
}

}  // namespace kadr::machine
