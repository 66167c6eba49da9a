// json_writer.h — the one place that knows how JSON is spelled: commas, quotes, escapes, numbers.
//
// Appends to a text of the caller, value by value, and keeps nothing but whether a comma comes
// next: a line of `--commands` allocates nothing once its text is warm.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

/// The name of a member that is known while compiling; that it needs no escape is seen then, and
/// all that stands around it is put there.
class JsonName {
  public:
    template <std::size_t N>
    consteval JsonName(const char (&name)[N]) : JsonName(std::string_view(name, N - 1)) {}
    explicit consteval JsonName(std::string_view name) {
        if (name.size() + 4 > text_.size()) name_is_too_long_or_needs_an_escape();
        for (const char c : {',', '"'}) text_[size_++] = c;
        for (const char c : name) {
            if (c < ' ' || c > '~' || c == '"' || c == '\\') name_is_too_long_or_needs_an_escape();
            text_[size_++] = c;
        }
        for (const char c : {'"', ':'}) text_[size_++] = c;
    }
    /// `,"name":`
    constexpr std::string_view behind_comma() const { return {text_.data(), size_}; }

  private:
    // No constant: a name that calls it does not compile.
    static void name_is_too_long_or_needs_an_escape() {}

    std::array<char, 31> text_{};
    std::uint8_t size_ = 0;
};

enum class JsonStyle : std::uint8_t {
    Compact,
    Lines,   // each member on a line of its own: an object of plain values that people read
    Script,  // within a `<script>` of a page, which no `<` of a text may end
};

/// Every value comes behind a key or in an array; commas come by themselves.
class JsonWriter {
  public:
    /// Appends to `out`, which outlives the writer.
    explicit JsonWriter(std::string& out, JsonStyle style = JsonStyle::Compact)
        : out_(out), style_(style) {}

    /// An object whose members `members` writes, each as a key and a value.
    template <std::invocable Members>
    JsonWriter& object(const Members& members) {
        open('{');
        members();
        return close('}');
    }
    template <std::invocable Elements>
    JsonWriter& array(const Elements& elements) {
        open('[');
        elements();
        return close(']');
    }
    /// Ends a line of JSON Lines; another value may begin the next one.
    void end_line() {
        out_ += '\n';
        has_comma_ = false;
    }

    JsonWriter& key(const JsonName& name) {
        if (style_ == JsonStyle::Lines) begin_line();
        const std::size_t without_comma = has_comma_ ? 0 : 1;
        out_ += name.behind_comma().substr(without_comma);
        if (style_ == JsonStyle::Lines) out_ += ' ';
        has_comma_ = false;
        return *this;
    }
    /// A name that comes from a file or a program: of an axis, of a variable.
    JsonWriter& key_of(std::string_view name) {
        if (style_ == JsonStyle::Lines) begin_line();
        separate();
        append_text(name);
        out_ += ':';
        if (style_ == JsonStyle::Lines) out_ += ' ';
        has_comma_ = false;
        return *this;
    }

    JsonWriter& null() { return word("null"); }
    JsonWriter& value(std::same_as<bool> auto truth) { return word(truth ? "true" : "false"); }
    JsonWriter& value(std::integral auto count) requires(!std::same_as<decltype(count), bool> &&
                                                         !std::same_as<decltype(count), char>) {
        std::array<char, 24> text;
        const auto end = std::to_chars(text.data(), text.data() + text.size(), count);
        return word({text.data(), static_cast<std::size_t>(end.ptr - text.data())});
    }
    /// A text as a string. Malformed UTF-8 becomes the replacement character.
    JsonWriter& value(std::string_view text) {
        separate();
        append_text(text);
        return *this;
    }

    // Numbers; what is not finite JSON has no word for, and becomes null.

    /// The shortest text that reads back as the same number (numbers.h).
    JsonWriter& number(double value);
    /// Of the number that is rounded to `decimals` places, 0 to 22, likewise.
    JsonWriter& rounded(double value, int decimals);
    /// Nine decimals at most, and below a million no exponent: the quickest, for coordinates, on
    /// which frames leave noise.
    JsonWriter& coordinate(double value);
    /// The shortest text with an exponent below 1e-4 and from 1e16 on, the sign of a zero kept.
    JsonWriter& general(double value);

  private:
    void separate() {
        if (has_comma_) out_ += ',';
        has_comma_ = true;
    }
    void begin_line() {
        out_ += has_comma_ ? ",\n " : "\n ";
        has_comma_ = false;
    }
    JsonWriter& word(std::string_view text) {
        separate();
        out_ += text;
        return *this;
    }
    void open(char bracket) {
        separate();
        out_ += bracket;
        has_comma_ = false;
    }
    JsonWriter& close(char bracket) {
        if (has_comma_ && style_ == JsonStyle::Lines) out_ += '\n';
        out_ += bracket;
        has_comma_ = true;
        return *this;
    }
    void append_text(std::string_view text);

    std::string& out_;
    JsonStyle style_;
    bool has_comma_ = false;  // in front of what comes next
};

}  // namespace kadr
