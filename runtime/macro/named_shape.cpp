#include "macro/named_shape.h"

#include <cmath>

#include "nc/parameters.h"

namespace kadr::macro {

std::vector<std::string> parts_of_contour(std::string_view text) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(':'), text.size());
        if (end > 0) parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

NamedContour contour_named_by(const nc::Block& block, const nc::CycleInfo& cycle) {
    NamedContour contour{parts_of_contour(block.text), ContourSource::Program};
    if (!names_contour(cycle)) {
        if (contour.parts.size() == 2) contour.kind = ContourSource::Labels;
        return contour;
    }
    const nc::Invocation* const call = block.find(nc::Function::Cycle);
    const auto kind = nc::find_parameter(cycle.parameters, "kind");
    if (call == nullptr || !kind) return contour;
    const std::int64_t number = std::llround(block.argument(*call, *kind, -1));
    contour.kind = static_cast<ContourSource>(std::max<std::int64_t>(number, 0));
    return contour;
}

NamedContour with_labels(NamedContour contour) {
    if (contour.kind != ContourSource::Named || contour.parts.empty()) return contour;
    const std::string name = contour.parts[0];
    contour.parts = {std::string(kContourBegin) + name, std::string(kContourEnd) + name};
    return contour;
}

}  // namespace kadr::macro
