#include "driver/program_locations.h"

#include <filesystem>
#include <string_view>

namespace kadr::driver {

namespace {

constexpr std::size_t kShownText = 48;  // characters of a statement

/// The first line of a statement, without the brace of its body, as far as it fits.
std::string first_line(std::string_view statement) {
    std::string text(statement.substr(0, statement.find('\n')));
    while (!text.empty() && (text.back() == ' ' || text.back() == '{' || text.back() == '\r'))
        text.pop_back();
    if (text.size() <= kShownText) return text;
    std::size_t cut = kShownText;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;
    return text.substr(0, cut) + "…";
}

std::string without_folder(const std::string& name) {
    return std::filesystem::path(name).filename().string();
}

}  // namespace

ProgramLocation ProgramLocations::find(std::uint32_t line, SourceId source) const {
    ProgramLocation location;
    location.statement = users_statement(line, source);
    if (location.statement.file.is_valid()) return location;
    if (macro::NcProgram::is_in_main_text(line)) {
        location.line = line;
        return location;
    }
    const TextLocation called = execution_.location_of(line);
    location.called = called.file + ':' + std::to_string(called.line);
    return location;
}

std::string ProgramLocations::key_of(const ProgramLocation& location) {
    if (location.statement.file.is_valid())
        return std::to_string(location.statement.file.index) + '@' +
               std::to_string(location.statement.begin);
    return location.called.empty() ? std::to_string(location.line) : location.called;
}

/// The statement outside of the library that led to the piece; none in ISO-7bit text.
SourceRange ProgramLocations::users_statement(std::uint32_t line, SourceId source) const {
    const SourceRange statement = execution_.statement(source);
    if (!statement.file.is_valid() || !is_in_library(statement)) return statement;
    const GeneratedText* generated = execution_.generated();
    const expand::BlockOrigin* calls =
        generated == nullptr ? nullptr : generated->calls_behind(line);
    if (calls == nullptr) return statement;
    for (auto call = calls->calls.rbegin(); call != calls->calls.rend(); ++call) {
        if (call->range.file.is_valid() && !is_in_library(call->range)) return call->range;
    }
    return statement;
}

bool ProgramLocations::is_in_library(const SourceRange& range) const {
    return session_.sources().name(range.file).starts_with(session_.share().library);
}

std::string ProgramLocations::name_of(const ProgramLocation& location) const {
    if (!location.called.empty()) return without_folder(location.called);
    if (!location.statement.file.is_valid())
        return without_folder(execution_.text_name() + ':' + std::to_string(location.line));
    return without_folder(session_.source_name(location.statement));
}

std::string ProgramLocations::text_of(const ProgramLocation& location) const {
    if (!location.called.empty() || !location.statement.file.is_valid()) return {};
    return first_line(session_.sources().text(location.statement));
}

}  // namespace kadr::driver
