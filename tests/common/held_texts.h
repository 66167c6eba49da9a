// held_texts.h — a text that two controls are held to stands once.
//
// Where a control has no expected text of its own, that of the control holds whose dialect its own
// extends: the texts of SINUMERIK hold for AxiOMA, too, until one differs.
#pragma once

#include <filesystem>
#include <functional>
#include <regex>
#include <string>

#include "base/disk_files.h"
#include "base/text.h"

namespace golden {

/// The control whose dialect a shipped one extends; empty: none.
inline std::string base_of(const std::string& control) {
    static const std::regex pattern("<dialect [^>]*extends=\"([^\"]+)\"");
    const std::string text =
        kadr::read_file(std::string(KADR_ROOT) + "/dialects/" + control + ".xml").value_or("");
    std::smatch found;
    return std::regex_search(text, found, pattern) ? found[1].str() : "";
}

/// The file of a control, whether it is there or not.
using FileOf = std::function<std::filesystem::path(const std::string& control)>;

/// The file that a control is held to: its own, or that of the nearest control that it extends and
/// that has one. Its own where none is there.
inline std::filesystem::path held_file(const std::string& control, const FileOf& file_of) {
    for (std::string name = control; !name.empty(); name = base_of(name))
        if (std::filesystem::exists(file_of(name))) return file_of(name);
    return file_of(control);
}

/// Whether a text of its own says what the control would be held to without it.
inline bool stands_twice(const std::string& control, const FileOf& file_of) {
    const std::string base = base_of(control);
    if (base.empty() || !std::filesystem::exists(file_of(control))) return false;
    const auto other = kadr::read_file(held_file(base, file_of).string());
    return other && kadr::read_file(file_of(control).string()) == other;
}

/// Notes a text that has changed: in the file of the control, or nowhere where that which it
/// extends has the same one.
///
/// returns  false if the file could not be written
inline bool keep_text(const std::string& control, const std::string& text, const FileOf& file_of) {
    std::filesystem::create_directories(file_of(control).parent_path());
    if (!kadr::write_file_whole(file_of(control).string(), text)) return false;
    if (stands_twice(control, file_of)) std::filesystem::remove(file_of(control));
    return true;
}

}  // namespace golden
