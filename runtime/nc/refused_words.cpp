#include "nc/refused_words.h"

#include <algorithm>

#include "base/text.h"
#include "nc/letters.h"

namespace kadr::nc {

bool is_program_call(const DialectTables& tables, std::string_view written) {
    constexpr std::string_view kDigits = "{digits}";
    return std::ranges::any_of(tables.language.calls.calls, [&](const CallForm& form) {
        const std::string_view code = form.code;
        if (!code.ends_with(kDigits)) return false;
        const std::size_t letters = code.size() - kDigits.size();
        return written.size() > letters &&
               upper_ascii(written.substr(0, letters)) == code.substr(0, letters) &&
               std::ranges::all_of(written.substr(letters), is_digit);
    });
}

bool takes_axis(const DialectTables& tables, const std::string& name) {
    return std::ranges::any_of(kAxisNames, [&](std::string_view axis) {
        const AddressId word = tables.find_address(name + '[' + std::string(axis) + ']');
        return word != kNoAddress && tables.addresses[word].kind == Address::Kind::Value;
    });
}

bool is_spindle_name(std::string_view index) {
    if (index.starts_with("SPI(")) return true;
    return index.size() > 1 && index[0] == 'S' && std::ranges::all_of(index.substr(1), is_digit);
}

std::string why_no_axis(const DialectTables& tables, const std::string& index) {
    const AddressId other = tables.find_address(index);
    if (other != kNoAddress && !tables.addresses[other].doc.empty())
        return "it is another word (" + tables.addresses[other].doc + ')';
    if (index.find_first_not_of("0123456789") == std::string::npos)
        return "an axis is given by its name";
    const bool is_computed = index.find_first_of("($[") != std::string::npos;
    if (is_computed) return "an axis that is worked out is not read here yet";
    return "no axis has this name, and a variable is not read here yet";
}

}  // namespace kadr::nc
