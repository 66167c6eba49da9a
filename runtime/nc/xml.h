// xml.h — an XML file as flat elements with their places; the one door to the XML library.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"

namespace kadr::nc {

struct XmlAttribute {
    std::string name;
    std::string value;
    SourceRange range;  // of the name in the file
};

struct XmlElement {
    std::string name;
    std::string text;   // character data of the element itself, as it stands
    SourceRange range;  // of the name in the start tag
    std::vector<XmlAttribute> attributes;
    std::vector<XmlElement> children;

    const XmlAttribute* find(std::string_view attribute) const {
        for (const XmlAttribute& a : attributes) {
            if (a.name == attribute) return &a;
        }
        return nullptr;
    }
};

/// The root element, or nothing if the text is not well-formed; that is reported with its place.
std::optional<XmlElement> parse_xml(FileId file, const Sources& sources, DiagnosticSink& sink);

}  // namespace kadr::nc
