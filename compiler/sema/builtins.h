// builtins.h — names that the language has by itself: functions, and members of its own values.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "sema/types.h"

namespace kadr::sema {

/// `sqrt`, `sin` … for proposals when a name is unknown.
std::span<const std::string_view> builtin_names();

/// What `position.` and `state.` have: `x`, `feed` …
std::span<const std::string_view> position_members();
std::vector<std::string_view> state_members();

/// Methods of arrays and texts.
std::span<const std::string_view> array_methods();
std::span<const std::string_view> text_methods();
/// What can be asked of a contour: `length`, `area` …
std::vector<std::string_view> contour_properties();

/// Everything that can stand behind the point of a value of this type, in no order.
std::vector<std::string_view> members_of(const TypeTable& types, Type type);

}  // namespace kadr::sema
