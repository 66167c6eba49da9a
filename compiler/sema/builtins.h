// builtins.h — names of the functions that the language has by itself.
#pragma once

#include <span>
#include <string_view>

namespace kadr::sema {

/// `sqrt`, `sin` … for proposals when a name is unknown.
std::span<const std::string_view> builtin_names();

}  // namespace kadr::sema
