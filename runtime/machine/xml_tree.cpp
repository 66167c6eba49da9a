#include "machine/xml_tree.h"

#include <algorithm>
#include <optional>

#include <pugixml.hpp>

namespace kadr::machine {

namespace {

SourceRange range_of(FileId file, std::size_t begin, std::size_t end) {
    return {file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Finds the attributes of the start tag whose name begins at `begin`. pugixml keeps no places of
/// attributes; the text is well-formed here, so a plain scan over names and quotes is enough.
std::vector<XmlAttribute> scan_attributes(FileId file, std::string_view text, std::size_t begin,
                                          const pugi::xml_node& node) {
    std::vector<XmlAttribute> attributes;
    std::size_t at = begin + std::string_view(node.name()).size();
    for (pugi::xml_attribute attribute : node.attributes()) {
        while (at < text.size() && is_space(text[at])) ++at;
        const std::size_t name = at;
        while (at < text.size() && text[at] != '=' && !is_space(text[at])) ++at;
        const std::size_t name_end = at;
        const std::size_t quote = text.find_first_of("\"'", at);
        if (quote == std::string_view::npos) break;
        const std::size_t close = text.find(text[quote], quote + 1);
        if (close == std::string_view::npos) break;
        attributes.push_back({attribute.name(), attribute.value(), range_of(file, name, name_end),
                              range_of(file, quote + 1, close)});
        at = close + 1;
    }
    return attributes;
}

// Machine files are three elements deep; the limit keeps a hostile file from eating the stack.
constexpr int kDeepest = 64;

XmlElement copy_element(FileId file, std::string_view text, const pugi::xml_node& node, int depth) {
    XmlElement element;
    element.name = node.name();
    const auto begin = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
    element.range = range_of(file, begin, begin + element.name.size());
    element.attributes = scan_attributes(file, text, begin, node);
    for (const pugi::xml_node& child : node.children()) {
        if (child.type() == pugi::node_element) {
            if (depth == kDeepest) continue;
            element.children.push_back(copy_element(file, text, child, depth + 1));
        } else if (!element.stray_text.file.is_valid() &&
                   (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)) {
            const auto place =
                static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, child.offset_debug()));
            element.stray_text = range_of(file, place, std::min(place + 1, text.size()));
        }
    }
    return element;
}

}  // namespace

const XmlAttribute* XmlElement::find(std::string_view attribute) const {
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const XmlAttribute& a) { return a.name == attribute; });
    return found == attributes.end() ? nullptr : &*found;
}

Result<XmlElement, XmlFault> parse_xml(FileId file, std::string_view text) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(text.data(), text.size(),
                             pugi::parse_default | pugi::parse_trim_pcdata, pugi::encoding_utf8);
    if (!parsed) {
        // What holds no element at all is wrong from its first byte, not from its last.
        const bool is_no_xml = parsed.status == pugi::status_no_document_element;
        const auto at = std::min(
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, is_no_xml ? 0 : parsed.offset)),
            text.size());
        return XmlFault{range_of(file, at, std::min(at + 1, text.size())), parsed.description()};
    }
    const pugi::xml_node root = document.document_element();
    if (!root) return XmlFault{range_of(file, 0, 0), "no element"};
    return copy_element(file, text, root, 0);
}

}  // namespace kadr::machine
