// xml_tree.h — a small XML file as elements and attributes with their places.
//
// The only door to pugixml in this room. Places are byte ranges, so that every message about a
// machine file can point at the attribute it means.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "base/source.h"

namespace kadr::machine {

struct XmlAttribute {
    std::string name;
    std::string value;  // entities replaced
    SourceRange name_range;
    SourceRange value_range;  // between the quotes
};

struct XmlElement {
    std::string name;
    SourceRange range;                     // of the name in the start tag
    std::vector<XmlAttribute> attributes;  // in the order of the file, doubled ones too
    std::vector<XmlElement> children;
    SourceRange stray_text;  // the first text between the children; not valid if there is none

    const XmlAttribute* find(std::string_view attribute) const;
};

/// Where the text stops to be XML.
struct XmlFault {
    SourceRange range;
    std::string what;  // in words
};

/// The root element of a text.
Result<XmlElement, XmlFault> parse_xml(FileId file, std::string_view text);

}  // namespace kadr::machine
