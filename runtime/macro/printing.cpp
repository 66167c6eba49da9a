// What a program prints: text and values with a fixed number of digits.
#include "macro/printing.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include "base/diagnostics/control.h"
#include "macro/program_base.h"

namespace kadr::macro {

namespace {

/// The sign, so many digits before the point and so many behind it. Digits in front that have no
/// place are cut off; zeros in front are blanks or nothing.
/// source: F 6.10
void append_printed(std::string& out, double value, const nc::PrintPiece& piece, bool pads) {
    const double step = std::pow(10.0, piece.decimals);
    const double counts = std::round(std::abs(value) * step);
    const double places = std::pow(10.0, piece.whole + piece.decimals);
    std::string digits = std::to_string(static_cast<std::uint64_t>(std::fmod(counts, places)));
    const auto least = static_cast<std::size_t>(piece.decimals + (piece.whole > 0 ? 1 : 0));
    if (digits.size() < least) digits.insert(0, least - digits.size(), '0');
    const auto width = static_cast<std::size_t>(piece.whole + piece.decimals);
    if (value < 0 && counts > 0) {
        out += '-';
    } else if (pads) {
        out += ' ';
    }
    if (pads && digits.size() < width) out.append(width - digits.size(), ' ');
    if (piece.decimals > 0)
        digits.insert(digits.size() - static_cast<std::size_t>(piece.decimals), 1, '.');
    out += digits;
}

/// The value without its decimal point as a whole number of 32 bits, the highest byte first;
/// nothing: it has no room there.
/// source: F 6.10 BPRNT; the bytes are those of the operator's manual (unsure: no vacant value)
std::optional<std::string> bytes_of(double value, int decimals) {
    const double counts = std::round(value * std::pow(10.0, decimals));
    if (!(std::abs(counts) <= 2147483647.0)) return std::nullopt;
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(counts));
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8)
        out += static_cast<char>(static_cast<unsigned char>(bits >> shift & 0xffU));
    return out;
}

}  // namespace

/// Printing waits for the blocks before it: what stands behind an alarm is never printed.
Outcome Printing::execute(CompiledLine& line, const nc::ControlStatement& statement) {
    if (run_.counts.given > 0) return Outcome::Wait;
    const bool is_bytes = statement.kind == nc::Statement::PrintBytes;
    if (statement.kind != nc::Statement::Print && !is_bytes) {
        is_open_ = statement.kind == nc::Statement::PrintOpen;
        return Outcome::Nothing;
    }
    if (!is_open_) return run_.fail(line, diag::PrinterClosed, statement.span);
    std::string text;
    for (const nc::PrintPiece& piece : statement.print) {
        if (!piece.value.is_given()) {
            text += piece.text;
            continue;
        }
        ControlValue value;
        const Outcome done = run_.evaluate(line, piece.value, value);
        if (!goes_on(done)) return done;
        if (is_bytes) {
            const auto bytes = bytes_of(value.number, piece.decimals);
            if (!bytes) return run_.fail(line, diag::NumberTooLarge, piece.value.span);
            text += *bytes;
        } else if (!value.is_vacant()) {
            append_printed(text, value.number, piece, run_.language.rules.print_pads);
        }
    }
    if (run_.options.printer != nullptr) run_.options.printer->line(text);
    return Outcome::Nothing;
}

}  // namespace kadr::macro
