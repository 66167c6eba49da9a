// load_attributes.h — what the attributes of a dialect file hold, with a message for every mistake.
//
// Knows XML and the vocabulary, not what a value is for: the loaders of load_parts.h know that.
#pragma once

#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/xml.h"
#include "nc/dialect_on_machine.h"
#include "nc/tables.h"
#include "nc/vocabulary.h"

namespace kadr::nc {

using Names = std::vector<std::string_view>;

/// An attribute that the shape of the file demands.
const XmlAttribute& needed(const XmlElement& element, std::string_view name);

/// `1..6` or `0`, whole numbers.
bool read_range(std::string_view text, Constraint& out);

/// Reads attributes. A `read_…` leaves `out` as it is when the attribute is not there or is wrong;
/// what is wrong has then been reported, and `has_failed` is true.
class Attributes {
  public:
    explicit Attributes(DiagnosticSink& sink, MachineKind kind = MachineKind::Mill)
        : sink_(sink), kind_(kind) {}

    bool has_failed() const { return failed_; }
    void fail() { failed_ = true; }
    DiagnosticSink& sink() { return sink_; }
    MachineKind kind() const { return kind_; }

    /// A number that is not negative.
    template <typename T>
    void read_number(const XmlElement& element, std::string_view name, T& out) {
        const XmlAttribute* attribute = element.find(name);
        if (attribute == nullptr) return;
        const std::string& text = attribute->value;
        T value{};
        const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
        if (result.ec != std::errc() || result.ptr != text.data() + text.size() || value < T{0}) {
            return bad_value(*attribute, "a number is expected");
        }
        out = value;
    }
    /// `yes` or `no`.
    void read_flag(const XmlElement& element, std::string_view name, bool& out);
    /// The index of the value among the choices.
    std::optional<std::size_t> choice(const XmlElement& element, std::string_view name,
                                      const Names& choices);
    static void read_text(const XmlElement& element, std::string_view name, std::string& out);
    /// Functions of the vocabulary, by their names.
    void read_functions(const XmlElement& element, std::string_view name,
                        std::vector<Function>& out);
    /// `none` is a function too: accepted, without effect.
    std::optional<Function> function_named(const XmlWord& word);

    void bad_value(const XmlAttribute& attribute, std::string_view why);
    void bad_word(const XmlWord& word, std::string_view attribute, std::string_view why);
    /// The same, with the name that may have been meant.
    void bad_name(const XmlWord& word, std::string_view attribute, const Names& names,
                  std::string_view why);

  private:
    DiagnosticSink& sink_;
    const MachineKind kind_;  // for which the file is loaded
    bool failed_ = false;
};

}  // namespace kadr::nc
