// quoted.h — code in a message.
#pragma once

#include <string>
#include <string_view>

namespace kadr::nc {

/// `text` between backquotes.
inline std::string quoted(std::string_view text) {
    return std::string("`").append(text).append("`");
}

}  // namespace kadr::nc
