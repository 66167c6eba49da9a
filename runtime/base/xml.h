// xml.h — an XML file as elements and attributes with their locations; the one door to the library.
//
// Dialects, machines and keyword languages are such files. What their elements mean is the matter
// of the rooms that read them; that a file is XML, that its outermost element is the right one, and
// that nothing in it is misspelt, doubled or left out, is reported here, in the same words for all.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"

namespace kadr {

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
    std::string text;        // of the element itself, outer blanks dropped, entities replaced
    SourceRange text_range;  // of its first piece, in the file; not valid if there is none

    /// The first attribute of this name; nullptr if there is none.
    const XmlAttribute* find(std::string_view attribute) const;
};

/// One of several words of an attribute.
struct XmlWord {
    std::string text;
    SourceRange range;  // of the word; of the whole value where entities stand in it
};

/// The words of a value, between blanks.
std::vector<XmlWord> words_of(const XmlAttribute& attribute);

/// An attribute that an element may have.
struct XmlAttributeRule {
    enum class Use : std::uint8_t {
        Optional,
        Needed,  // it must be there
        Filled,  // it must be there and not be empty
    };
    std::string_view name;
    Use use;
    constexpr XmlAttributeRule(const char* name_, Use use_ = Use::Optional)  // a row may be a name
        : name(name_), use(use_) {}
};

/// What an element may hold. An element of one name holds the same wherever it stands.
struct XmlRule {
    enum class Text : std::uint8_t { None, Allowed };
    std::string_view element;
    std::vector<XmlAttributeRule> attributes;
    std::vector<std::string_view> children;
    Text text = Text::None;
};

/// What a file of one kind may hold.
struct XmlShape {
    std::string_view kind;           // as a message names it: "a dialect file"
    std::span<const XmlRule> rules;  // the first one is the outermost element's
};

/// The outermost element of a kept text. Nothing, with one message, if the text is not XML or
/// begins with another element than the shape's. pugixml lets pass what XML forbids (a second
/// outermost element, text beside it, an unknown entity); here all of that is a mistake, and so are
/// elements nested deeper than 64, which no file of ours needs and no stack should hold.
std::optional<XmlElement> parse_xml(FileId file, const Sources& sources, const XmlShape& shape,
                                    DiagnosticSink& sink);

/// The attributes of the outermost element's tag by their names, whatever stands behind it. Empty
/// if the file cannot be read; of a broken tag what stands before the break.
std::map<std::string, std::string> first_tag(const std::string& path, const Files& files);

/// An element and everything below it is as the shape is: every element and attribute known,
/// nothing doubled, nothing missing, no stray text. Reports each mistake at its location, with the
/// name that may have been meant. Attributes of XML itself (`xmlns`, `xsi:…`) pass.
Done check_xml(const XmlElement& element, const XmlShape& shape, DiagnosticSink& sink);

/// The element without what is below it and does not fit the shape: unknown elements, and those
/// that lack an attribute which they need. For looking at the rest of a file with mistakes.
XmlElement sound_part(const XmlElement& element, const XmlShape& shape);

/// Whether the element itself has the attributes that the shape demands.
bool has_needed_attributes(const XmlElement& element, const XmlShape& shape);

/// A value that is too long for one line of a message is cut.
std::string shown_value(std::string_view value);

}  // namespace kadr
