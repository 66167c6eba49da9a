// control_value.h — values and variables of the control's own language.
#pragma once

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "control/control_frame.h"
#include "nc/control_line.h"

namespace kadr::macro {

/// A value while it is worked out. A text, or a frame, is an index into those of who holds the
/// value; an axis is below zero: −1 X, −2 Y …
struct ControlValue {
    enum class Kind : std::uint8_t { Vacant, Real, Int, Bool, Char, Text, Axis, Frame };
    double number = 0;
    std::uint32_t text = 0;
    Kind kind = Kind::Vacant;

    static ControlValue of(double number, nc::ValueType type) {
        return {number, 0, static_cast<Kind>(static_cast<std::uint8_t>(type) + 1)};
    }
    static ControlValue real(double number) { return {number, 0, Kind::Real}; }
    static ControlValue truth(bool is_true) { return {is_true ? 1.0 : 0.0, 0, Kind::Bool}; }
    bool is_text() const { return kind == Kind::Text; }
    bool is_frame() const { return kind == Kind::Frame; }
    /// Neither a text nor an axis nor a frame.
    bool is_number() const { return kind <= Kind::Char; }
    /// The axis that it is; nothing: none was ever set, or it is something else.
    std::optional<Axis> axis() const {
        const bool is_axis = number < 0 && number >= -static_cast<double>(kAxes);
        if (kind != Kind::Axis || !is_axis) return std::nullopt;
        return static_cast<Axis>(static_cast<int>(-number) - 1);
    }
    /// A spindle that stands where axes do; far below the names of axes.
    static constexpr double kSpindles = -1000;
    static ControlValue spindle_of(double of) { return {kSpindles - of, 0, Kind::Axis}; }
    std::optional<std::int64_t> spindle() const {
        if (kind != Kind::Axis || !(number < kSpindles)) return std::nullopt;
        return static_cast<std::int64_t>(kSpindles - number);
    }
    /// Of a Char: what stands for its code in a text.
    std::string character() const {
        std::string out;
        append_code_point(out, static_cast<char32_t>(number));
        return out;
    }
    bool is_vacant() const { return kind == Kind::Vacant; }
    /// Whole by its type.
    bool is_whole() const { return kind >= Kind::Int && kind <= Kind::Char; }
};

/// "a number", "a text", "an axis", "a frame": for messages.
inline std::string_view kind_name(const ControlValue& value) {
    switch (value.kind) {
        case ControlValue::Kind::Text: return "a text";
        case ControlValue::Kind::Axis:
            return value.axis() || value.spindle() ? "an axis" : "an axis without a value";
        case ControlValue::Kind::Frame: return "a frame";
        default: return "a number";
    }
}

/// What a value refers to, if it is a text or a frame.
struct Content {
    std::string_view text;
    const control::ControlFrame* frame = nullptr;
};

/// Variables side by side; one that was never set is vacant.
struct Store {
    std::vector<ControlValue> values;
    std::vector<std::string> texts;  // of the text variables among them, one for each slot
    std::vector<control::ControlFrame> frames;  // … of those that are frames

    void grow(std::size_t count) { values.resize(std::max(values.size(), count)); }
    Content content(const ControlValue& value) const {
        return {value.is_text() ? std::string_view(texts[value.text]) : std::string_view(),
                value.is_frame() ? &frames[value.text] : nullptr};
    }
    void set_text(std::uint32_t slot, std::string_view text) {
        texts.resize(std::max<std::size_t>(texts.size(), slot + std::size_t{1}));
        texts[slot] = text;
        values[slot] = {0, slot, ControlValue::Kind::Text};
    }
    void set_frame(std::uint32_t slot, const control::ControlFrame& frame) {
        frames.resize(std::max<std::size_t>(frames.size(), slot + std::size_t{1}));
        frames[slot] = frame;
        values[slot] = {0, slot, ControlValue::Kind::Frame};
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
    /// Which parameters the call of the program has given, as many as a procedure may have; S 8.8.
    std::bitset<127> given;
};

}  // namespace kadr::macro
