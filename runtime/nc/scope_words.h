// scope_words.h — words beside the type of a declaration, as a dialect writes them (`scope_words`).
#pragma once

#include <string_view>

namespace kadr::nc {

/// The word itself: `APR` of `APR=`, `LLI` of `LLI..`, `ULI` of `..ULI`.
constexpr std::string_view scope_word(std::string_view form) {
    if (form.starts_with("..")) form.remove_prefix(2);
    if (form.ends_with("..")) form.remove_suffix(2);
    if (form.ends_with('=')) form.remove_suffix(1);
    return form;
}

}  // namespace kadr::nc
