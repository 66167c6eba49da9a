#include "nc/kept_lines.h"

#include <algorithm>

namespace kadr::nc {

namespace {

/// The word of the line that `is_wanted` accepts; else the first word, else the whole line.
template <typename IsWanted>
Span find_word(const DialectTables& tables, std::string_view line, IsWanted is_wanted) {
    ControlLine compiled;
    if (tables.language.is_present) {
        (void)compile_line(tables, SymbolTable(), line, compiled);
    } else {
        (void)lex_line(tables, line, compiled.words);
    }
    const LexedLine& lexed = compiled.words;
    for (std::size_t i = 0; i < lexed.words.size(); ++i) {
        if (is_wanted(lexed.words[i])) return lexed.spans[i];
    }
    if (!lexed.spans.empty()) return lexed.spans[0];
    return {0, static_cast<std::uint32_t>(line.size())};
}

}  // namespace

template <typename IsWanted>
LinePlace KeptLines::place_word(const Block& block, IsWanted is_wanted) const {
    const auto kept = find(block);
    if (kept == lines_.end()) return reader_.place({}, block.line, {});
    const std::string_view line = std::string_view(text_).substr(kept->offset, kept->length);
    const std::string& file = kept->file != nullptr ? *kept->file : reader_.text().name;
    return LineReader::place(file, line, kept->number,
                             find_word(reader_.tables(), line, is_wanted));
}

std::vector<KeptLines::Line>::const_iterator KeptLines::find(const Block& block) const {
    return std::ranges::find(lines_, block.line, &Line::id);
}

std::vector<LinePlace> KeptLines::calls(const Block& block) const {
    std::vector<LinePlace> places;
    const auto kept = find(block);
    if (kept == lines_.end()) return places;
    for (const CallSite* call = kept->calls.get(); call != nullptr; call = call->from.get())
        places.push_back(call->place);
    return places;
}

LinePlace KeptLines::place(const Block& block) const {
    return place_word(block, [](const GivenWord&) { return true; });
}

LinePlace KeptLines::place(const Block& block, Slot slot) const {
    const DialectTables& tables = reader_.tables();
    return place_word(block, [&](const GivenWord& word) {
        return tables.addresses[word.address].slot == static_cast<int>(slot);
    });
}

LinePlace KeptLines::place(const Block& block, Function function) const {
    const DialectTables& tables = reader_.tables();
    return place_word(block, [&](const GivenWord& word) {
        const Address& head = tables.addresses[word.address];
        const Code* code = word.is_known ? tables.find_code(word.address, word.number) : nullptr;
        const std::vector<FormId>& forms = code != nullptr ? code->forms : head.forms;
        return std::ranges::any_of(
            forms, [&](FormId id) { return tables.forms[id].function == function; });
    });
}

}  // namespace kadr::nc
