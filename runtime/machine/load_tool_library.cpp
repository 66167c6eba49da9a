// load_tool_library.cpp — a tool library from its XML file.
#include <span>

#include "base/units.h"
#include "base/xml.h"
#include "machine/counting_sink.h"
#include "machine/element_reader.h"
#include "machine/tool_library.h"

namespace kadr::machine {

namespace {

constexpr auto Filled = XmlAttributeRule::Use::Filled;

/// What a tool library may hold; mirrors tools.xsd.
const XmlShape& library_shape() {
    static const std::vector<XmlRule> rules = {
        {"tools", {"title"}, {"tool"}},
        {"tool",
         {{"number", Filled},
          {"name", Filled},
          {"kind", Filled},
          "d",
          "r",
          "length",
          "flutes",
          "tip_angle",
          "pitch",
          "holder"},
         {"cutting"}},
        {"cutting", {"material", "vc", "fz", "f"}, {}},
    };
    static const XmlShape shape = {"a tool library", rules};
    return shape;
}

void read_tool(const XmlElement& element, ToolLibraryBuilder& builder, DiagnosticSink& sink) {
    const ElementReader reader(element, sink);
    ToolEntry entry;
    LibraryTool& tool = entry.tool;
    tool.range = element.range;
    // What is missing has been reported by the check of the shape.
    if (!reader.has("number") || !reader.has("name") || !reader.has("kind")) return;
    entry.number = reader.whole("number", 1, 99'999'999);
    if (!entry.number) return;
    tool.name = reader.text("name");
    entry.kind = reader.text("kind");
    tool.diameter = reader.positive("d", QuantityKind::Length);
    tool.corner_radius = reader.magnitude("r", QuantityKind::Length);
    tool.length = reader.quantity("length", QuantityKind::Length);
    if (reader.has("flutes")) tool.flutes = reader.whole("flutes", 1, 1000);
    if (const auto angle = reader.positive("tip_angle", QuantityKind::Angle))
        tool.tip_angle = deg_from_rad(*angle);
    tool.pitch = reader.positive("pitch", QuantityKind::Length);
    tool.holder = reader.text("holder");
    entry.number_at = reader.location("number");
    entry.name_at = reader.location("name");
    entry.kind_at = reader.location("kind");
    entry.diameter_at = reader.location("d");
    entry.corner_at = reader.location("r");
    entry.flutes_at = reader.location("flutes");
    entry.tip_at = reader.location("tip_angle");
    builder.add(std::move(entry));
    for (const XmlElement& child : element.children) {
        if (child.name != "cutting") continue;
        const ElementReader cuts(child, sink);
        CuttingData cutting;
        cutting.material = cuts.text("material");
        cutting.cutting_speed = cuts.positive("vc", QuantityKind::Velocity);
        cutting.feed_per_tooth = cuts.positive("fz", QuantityKind::Length);
        cutting.feed_per_turn = cuts.positive("f", QuantityKind::Length);
        builder.add_cutting(std::move(cutting), child.range);
    }
}

}  // namespace

std::optional<ToolLibrary> load_tool_library(FileId file, const Sources& sources,
                                             DiagnosticSink& sink) {
    const auto root = parse_xml(file, sources, library_shape(), sink);
    if (!root) return std::nullopt;
    CountingSink counting(sink);
    const Done has_shape = check_xml(*root, library_shape(), counting);
    ToolLibraryBuilder builder(counting);
    for (const XmlElement& child : root->children)
        if (child.name == "tool") read_tool(child, builder, counting);
    if (!has_shape || counting.has_errors()) return std::nullopt;
    return builder.take(std::string(sources.name(file)));
}

}  // namespace kadr::machine
