// parts.h — the whole parts that are expanded and executed for every control.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/held_texts.h"

namespace golden {

namespace fs = std::filesystem;

inline const std::vector<std::string> kDialects = {"sinumerik", "fanuc", "axioma"};

/// A control of examples/dialects, and the parts for a mill that it has no words for. Neither has
/// splines: a part made of them moves along their lines.
struct MadeControl {
    std::string_view name;
    std::vector<std::string_view> cannot_say;
};
inline const std::vector<MadeControl> kMadeControls = {
    {"haas", {"frames", "plate", "orientation", "probe"}},
    {"heidenhain-iso",
     {"housing", "hole_positions", "cycle_tap", "frames", "plate", "orientation", "probe"}},
};

/// A Kadr program and the machine that it is made for.
struct Part {
    fs::path source;
    std::string machine;
    /// A FANUC lathe roughs it by its own cycle, in other strokes than the library (what both
    /// leave, tests/stdlib/turning_test.cpp holds).
    bool has_own_strokes = false;
    std::string name() const { return source.stem().string(); }
    /// The controls that it is written for: a lathe may have one of its own kind, too.
    std::vector<std::string> dialects() const {
        std::vector<std::string> names = kDialects;
        if (machine == "lathe") names.emplace_back("fanuc-lathe");
        return names;
    }
};

/// The machine that the head comment of a program runs it on: `-m lathe`, or with five axes.
inline std::string machine_of(const std::string& text) {
    for (const char* machine : {"lathe", "trunnion-ac"})
        if (text.find(std::string("-m ") + machine) != std::string::npos) return machine;
    return "mill";
}

/// Programs of a folder.
inline std::vector<Part> parts_of(const fs::path& folder) {
    std::vector<Part> parts;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".kadr") continue;
        const std::string text = kadr::read_file(entry.path()).value_or("");
        const bool has_own_strokes = text.find("in strokes of its own") != std::string::npos;
        parts.push_back({entry.path(), machine_of(text), has_own_strokes});
    }
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.source < b.source; });
    return parts;
}

inline std::vector<Part> all_parts() {
    std::vector<Part> parts = parts_of(fs::path(KADR_ROOT) / "examples");
    const std::vector<Part> languages = parts_of(fs::path(KADR_ROOT) / "examples/languages");
    parts.insert(parts.end(), languages.begin(), languages.end());
    const std::vector<Part> cycles = parts_of(fs::path(KADR_ROOT) / "tests/golden/cycles");
    parts.insert(parts.end(), cycles.begin(), cycles.end());
    return parts;
}

/// Where the text of a part for a control stands: tests/golden/texts/PART.CONTROL.txt.
inline auto files_of(const std::string& part) {
    return [part](const std::string& control) {
        return fs::path(KADR_ROOT) / "tests/golden/texts" / (part + '.' + control + ".txt");
    };
}

/// The texts of all parts that are written for a control, each its own or that of the control that
/// it extends.
inline std::vector<fs::path> texts_for(const std::string& control) {
    std::vector<fs::path> files;
    for (const Part& part : all_parts()) {
        const std::vector<std::string> dialects = part.dialects();
        if (std::ranges::find(dialects, control) != dialects.end())
            files.push_back(held_file(control, files_of(part.name())));
    }
    std::sort(files.begin(), files.end());
    return files;
}

template <typename Info>
std::string name_of(const Info& info) {
    std::string name =
        info.param.source.parent_path().filename().string() + "_" + info.param.name();
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

}  // namespace golden
