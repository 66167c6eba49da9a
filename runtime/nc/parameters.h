// parameters.h — parameters by their names, where several functions share a line, and of cycles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

#include "nc/vocabulary.h"

namespace kadr::nc {

/// A name as a template has it: `"angle"`.
template <std::size_t size>
struct ParameterName {
    // NOLINTNEXTLINE(google-explicit-constructor): a literal is a name
    consteval ParameterName(const char (&literal)[size]) { std::ranges::copy(literal, text); }
    constexpr std::string_view view() const { return {text, size - 1}; }

    char text[size] = {};
};

/// The parameter of this name of functions that all have it at the same index:
/// `parameter_of_all<"angle", Function::SurfaceLead, Function::SurfaceTilt>()`. Else it does not
/// compile.
template <ParameterName name, Function first, Function... others>
consteval std::size_t parameter_of_all() {
    constexpr std::size_t kPlace = parameter_of<first>(name.view());
    static_assert(((parameter_of<others>(name.view()) == kPlace) && ...),
                  "these functions have it at different places");
    return kPlace;
}

/// Which of the parameters of a cycle has this name, if there is one.
template <typename Parameters>
std::optional<std::size_t> find_parameter(const Parameters& parameters, std::string_view name) {
    const auto found = std::ranges::find_if(
        parameters, [&](const auto& parameter) { return parameter.name == name; });
    if (found == std::ranges::end(parameters)) return std::nullopt;
    return static_cast<std::size_t>(found - std::ranges::begin(parameters));
}

}  // namespace kadr::nc
