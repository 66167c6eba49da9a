// svg_text.h — the words of SVG that every drawing of ours needs.
#pragma once

#include <string>
#include <string_view>

#include "base/printable.h"
#include "base/put.h"

namespace kadr::plot {

inline constexpr const char* kInk = "#2d3138";
inline constexpr const char* kSoft = "#6d7480";
inline constexpr const char* kAlert = "#b3261e";
inline constexpr const char* kAlertGround = "#f9dcd9";

/// A text, the name of a file among others, as XML may hold it: without control characters.
inline std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else out += c;
    }
    return out;
}

/// Opens the document.
inline void put_start(std::string& out, double width, double height) {
    put(out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n",
        width, height);
}

/// The document's name, its letters and its paper.
inline void put_paper(std::string& out, std::string_view title) {
    put(out,
        "<title>{}</title>\n<style>text {{ font-family: \"Inter\", \"Segoe UI\", \"DejaVu Sans\", "
        "\"Liberation Sans\", Arial, sans-serif; }}</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#f7f8f9\"/>\n",
        escaped(title));
}

/// Title, what is below it, and in red what has to be noted; empty: nothing.
inline void put_title(std::string& out, std::string_view title, std::string_view subtitle,
                      std::string_view warning) {
    put(out, "<text x=\"28\" y=\"38\" font-size=\"20\" font-weight=\"600\" fill=\"{}\">{}</text>\n",
        kInk, escaped(title));
    put(out, "<text x=\"28\" y=\"58\" font-size=\"12.5\" fill=\"{}\">{}</text>\n", kSoft,
        escaped(subtitle));
    if (warning.empty()) return;
    put(out, "<text x=\"28\" y=\"76\" font-size=\"12.5\" fill=\"{}\">{}</text>\n", kAlert,
        escaped(warning));
}

}  // namespace kadr::plot
