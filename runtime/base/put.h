// put.h — formatted text behind a text. For rooms that link fmt.
#pragma once

#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace kadr {

template <typename... Arguments>
void put(std::string& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
}

}  // namespace kadr
