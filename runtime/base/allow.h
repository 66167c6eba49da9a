// allow.h — the comment that silences a warning: `// kadr: allow K2501 it is kept for the setter`.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace kadr {

/// What a comment allows.
struct Allowance {
    bool is_one = false;                  // the comment begins with `kadr:`
    bool is_well_formed = false;          // … and goes on with `allow` and at least one code
    std::vector<std::string_view> codes;  // of the messages, in the order of the comment

    bool contains(std::string_view code) const {
        return is_well_formed && std::find(codes.begin(), codes.end(), code) != codes.end();
    }
};

/// Reads a comment, without its `//`: `kadr: allow K2501, K2502 why`. The codes are separated by
/// blanks or commas; the first word that is no code begins the reason.
Allowance allowed_codes(std::string_view comment);

/// Whether a line of ISO-7bit text has the comment that allows a code: `(KADR: ALLOW K5973 WHY)` or
/// `; kadr: allow K5973 why`. Letters may be of either case, for controls that have one only.
bool iso_line_allows(std::string_view line, std::string_view code);

}  // namespace kadr
