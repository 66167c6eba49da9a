#include "path/curve_registry.h"

#include <algorithm>

#include "base/assert.h"

namespace kadr::path {

namespace {

/// In a function: registrations run before `main`, in an order that nobody knows.
std::vector<const CurveKind*>& kinds() {
    static std::vector<const CurveKind*> all;
    return all;
}

}  // namespace

void register_curve(const CurveKind& kind) {
    KADR_ASSERT(find_curve(kind.name) == nullptr, "two kinds of curve have one name");
    KADR_ASSERT(kind.make != nullptr && kind.at != nullptr, "a kind of curve lacks its functions");
    std::vector<const CurveKind*>& all = kinds();
    const auto behind =
        std::ranges::find_if(all, [&](const CurveKind* known) { return known->name > kind.name; });
    all.insert(behind, &kind);
}

const CurveKind* find_curve(std::string_view name) {
    const std::vector<const CurveKind*>& all = kinds();
    const auto found = std::ranges::find(all, name, &CurveKind::name);
    return found == all.end() ? nullptr : *found;
}

std::vector<std::string_view> curve_names() {
    std::vector<std::string_view> names;
    for (const CurveKind* kind : kinds()) names.push_back(kind->name);
    return names;
}

}  // namespace kadr::path
