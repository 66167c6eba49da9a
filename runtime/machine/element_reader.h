// element_reader.h — the attributes of one element, read with a message for every mistake.
//
// Knows XML elements and quantities; what the values mean for a machine is load.cpp's matter.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "base/xml.h"
#include "machine/quantity.h"

namespace kadr::machine {

/// Every question about an attribute answers nothing when the attribute is missing or wrong; what
/// is wrong has then been reported. What is missing is the matter of the file's shape.
class ElementReader {
  public:
    ElementReader(const XmlElement& element, DiagnosticSink& sink)
        : element_(element), sink_(sink) {}

    const XmlElement& element() const { return element_; }

    bool has(std::string_view attribute) const { return element_.find(attribute) != nullptr; }
    std::string text(std::string_view attribute) const;
    std::optional<double> quantity(std::string_view attribute, QuantityKind dimension) const;
    /// Three quantities with one unit behind them: `12.5 0 -40 mm`.
    std::optional<std::array<double, 3>> triple(std::string_view attribute,
                                                QuantityKind dimension) const;
    std::optional<Range> range(std::string_view attribute, QuantityKind dimension) const;
    /// Above zero, or zero and above.
    std::optional<double> positive(std::string_view attribute, QuantityKind dimension) const;
    std::optional<double> magnitude(std::string_view attribute, QuantityKind dimension) const;
    /// A share from nothing to the whole, 0 … 1.
    std::optional<double> share(std::string_view attribute) const;
    std::optional<std::int64_t> whole(std::string_view attribute, std::int64_t least,
                                      std::int64_t most) const;
    /// The index of the value in `words`.
    std::optional<std::size_t> choice(std::string_view attribute,
                                      std::span<const std::string_view> words) const;

    /// The location of the attribute's value; of the element if there is none.
    SourceRange location(std::string_view attribute) const;

  private:
    void report_quantity(const XmlAttribute& attribute, const QuantityError& error,
                         QuantityKind dimension, bool is_range) const;

    const XmlElement& element_;
    DiagnosticSink& sink_;
};

/// A proposal for a slip, as words for a fix; nothing if no candidate is near.
std::optional<std::string> proposal(std::string_view wrong,
                                    std::span<const std::string_view> candidates);

}  // namespace kadr::machine
