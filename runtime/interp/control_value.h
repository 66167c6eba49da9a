// control_value.h — values and variables of the control's own language.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nc/control_line.h"

namespace kadr::interp {

/// A value while it is worked out. A text is an index into the texts of who holds the value.
struct Value {
    enum class Kind : std::uint8_t { Vacant, Real, Int, Bool, Char, Text };
    double number = 0;
    std::uint32_t text = 0;
    Kind kind = Kind::Vacant;

    static Value of(double number, nc::ValueType type) {
        return {number, 0, static_cast<Kind>(static_cast<std::uint8_t>(type) + 1)};
    }
    static Value real(double number) { return {number, 0, Kind::Real}; }
    static Value truth(bool is_true) { return {is_true ? 1.0 : 0.0, 0, Kind::Bool}; }
    bool is_text() const { return kind == Kind::Text; }
    bool is_vacant() const { return kind == Kind::Vacant; }
    /// Whole by its type.
    bool is_whole() const { return kind >= Kind::Int && kind <= Kind::Char; }
};

/// Variables side by side; one that was never set is vacant.
struct Store {
    std::vector<Value> values;
    std::vector<std::string> texts;  // of the text variables among them, one for each slot

    void grow(std::size_t count) { values.resize(std::max(values.size(), count)); }
    void set_text(std::uint32_t slot, std::string_view text) {
        texts.resize(std::max<std::size_t>(texts.size(), slot + std::size_t{1}));
        texts[slot] = text;
        values[slot] = {0, slot, Value::Kind::Text};
    }
};

/// What a level of the program has of its own; a call may bring a new one.
struct Level {
    Level() = default;
    Level(const Level&) = delete;  // others refer to its variables
    Level& operator=(const Level&) = delete;

    Store locals;                // those of the language, then each single value that was declared
    Store elements;              // of the arrays and the texts that were declared
    nc::SymbolTable symbols;     // `slot` counts in the store of the symbol
    std::vector<Store*> stores;  // of the symbols; of a parameter by reference the caller's
};

}  // namespace kadr::interp
