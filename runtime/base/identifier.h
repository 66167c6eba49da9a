// identifier.h — what names in programs are made of.
#pragma once

namespace kadr {

/// Whether a byte belongs to an identifier: ASCII letters and digits, `_`, every byte of a letter
/// beyond ASCII.
constexpr bool is_name_part(char c) {
    return (c & 0x80) != 0 || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z');
}

}  // namespace kadr
