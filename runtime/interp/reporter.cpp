// reporter.cpp — where a message points, and how the control names its alarm.
#include "interp/reporter.h"

#include <algorithm>

#include "base/text.h"
#include "nc/tables.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;

DiagnosticBuilder Reporter::report(const DiagnosticRow& row, const Block& block) {
    TextLocation location = locations_ != nullptr ? locations_->location(block)
                                                  : TextLocation{{}, block.line, 1, 1, {}};
    DiagnosticBuilder builder = report(row, std::move(location));
    if (block.is_of_cycle())
        builder.note("inside the cycle `" + std::string(block.context->cycle) + "`");
    return note_calls(std::move(builder), block);
}

DiagnosticBuilder Reporter::report(const DiagnosticRow& row, const Block& block, Slot slot) {
    if (locations_ == nullptr || block.is_of_cycle()) return report(row, block);
    return note_calls(report(row, locations_->location(block, slot)), block);
}

DiagnosticBuilder Reporter::report(const DiagnosticRow& row, const Block& block,
                                   Function function) {
    if (locations_ == nullptr || block.is_of_cycle()) return report(row, block);
    return note_calls(report(row, locations_->location(block, function)), block);
}

namespace {

/// Characters of a text; columns count them, not bytes.
std::string characters(std::string_view text, std::size_t first, std::size_t count) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
    std::string found;
    std::size_t at = 0;
    for (const char c : text) {
        at += begins(c) ? 1 : 0;
        if (at > first && at <= first + count) found += c;
    }
    return found;
}

/// Where an argument stands in a call, `TRAORI(1,0,0,1)`: bytes. All of the call if it has no such
/// argument.
std::string_view argument_in(std::string_view call, std::size_t argument) {
    std::size_t begin = call.find('(');
    int depth = 0;
    for (std::size_t at = begin; at < call.size(); ++at) {
        if (call[at] == '(') ++depth;
        if (call[at] == ')') --depth;
        const bool ends = (call[at] == ',' && depth == 1) || depth == 0;
        if (!ends) continue;
        if (argument == 0) {
            while (begin + 1 < at && call[begin + 1] == ' ') ++begin;
            while (at > begin + 2 && call[at - 1] == ' ') --at;
            return call.substr(begin + 1, at - begin - 1);
        }
        begin = at;
        --argument;
    }
    return call;
}

}  // namespace

DiagnosticBuilder Reporter::report(const DiagnosticRow& row, const Block& block, Function function,
                                   std::size_t argument) {
    if (locations_ == nullptr || block.is_of_cycle()) return report(row, block);
    TextLocation location = locations_->location(block, function);
    const std::string call = characters(location.text, location.column - 1, location.length);
    const std::string_view text = argument_in(call, argument);
    const auto before = static_cast<std::size_t>(text.data() - call.data());
    location.column +=
        static_cast<std::uint32_t>(count_code_points(std::string_view(call).substr(0, before)));
    location.length = static_cast<std::uint32_t>(std::max<std::size_t>(1, count_code_points(text)));
    return note_calls(report(row, std::move(location)), block);
}

std::string Reporter::word_of(const Block& block, Function function) const {
    const std::string name(nc::info(function).name);
    const bool is_given = block.motion == function || block.find(function) != nullptr;
    if (locations_ == nullptr || block.is_of_cycle() || !is_given) return name;
    const TextLocation location = locations_->location(block, function);
    const std::string word = characters(location.text, location.column - 1, location.length);
    return word.empty() ? name : word;
}

std::string Reporter::spelling_of(Function function) const {
    const nc::DialectTables& tables = dialect_.tables();
    for (const nc::FormId id : tables.forms_of[static_cast<std::size_t>(function)]) {
        const nc::Form& form = tables.forms[id];
        if (form.is_read && form.unsupported.empty()) return form.words[0].text;
    }
    return std::string(nc::info(function).name);
}

/// Adds where the program of the block was called.
DiagnosticBuilder Reporter::note_calls(DiagnosticBuilder builder, const Block& block) const {
    if (locations_ == nullptr) return builder;
    for (TextLocation& location : locations_->calls(block))
        builder.note(std::move(location), "called here");
    return builder;
}

DiagnosticBuilder Reporter::report(const DiagnosticRow& row, TextLocation location) {
    if (row.severity == Severity::Alarm) stop();
    DiagnosticBuilder builder = sink_->report(row, std::move(location));
    if (std::optional<nc::AlarmText> alarm = dialect_.alarm(row)) {
        builder.alarm(std::move(alarm->number), std::move(alarm->text));
    }
    return builder;
}

Reporter::Silence::Silence(Reporter& reporter, Locations locations)
    : reporter_(reporter), sink_(reporter.sink_), locations_(reporter.locations_) {
    reporter.sink_ = &nobody_;
    if (locations == Locations::Hidden) reporter.locations_ = nullptr;
}

Reporter::Silence::~Silence() {
    reporter_.sink_ = sink_;
    reporter_.locations_ = locations_;
}

}  // namespace kadr::interp
