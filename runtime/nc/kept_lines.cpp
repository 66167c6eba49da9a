#include "nc/kept_lines.h"

#include <algorithm>
#include <utility>

#include "nc/head_words.h"

namespace kadr::nc {

namespace {

constexpr std::size_t kChunk = 1024;  // lines, at least, that are forgotten together

/// The word of the line that `is_wanted` accepts; else the first word, else the whole line.
template <typename IsWanted>
Span find_word(const DialectTables& tables, std::string_view line, IsWanted is_wanted) {
    ControlLine compiled;
    // The words behind the head of a program are where they stand, the head itself is none.
    std::string words(line);
    const std::size_t head = words_behind_head(tables, line);
    if (head != std::string_view::npos) std::fill_n(words.begin(), head, ' ');
    line = words;
    // A line with a fault has the words until there.
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

std::vector<TextLocation> locations_of(const CallSite* nearest) {
    std::vector<TextLocation> locations;
    for (const CallSite* call = nearest; call != nullptr; call = call->from.get())
        locations.push_back(call->location);
    return locations;
}

/// Buffers go round: once warm, nothing is allocated.
void KeptLines::clear() {
    if (most_earlier_ > 0 && now_.lines.size() < kChunk) {
        batch_ = now_.lines.size();
        return;
    }
    batch_ = 0;
    if (most_earlier_ > 0) {
        count_earlier_ += now_.lines.size();
        earlier_.push_back(std::exchange(now_, {}));
    }
    if (!earlier_.empty() && count_earlier_ - earlier_.front().lines.size() >= most_earlier_) {
        count_earlier_ -= earlier_.front().lines.size();
        now_ = std::move(earlier_.front());
        earlier_.pop_front();
    }
    now_.lines.clear();
    now_.text.clear();
}

/// The line of the latest batch, the first of several with this id; else of an earlier one.
KeptLines::Found KeptLines::find(std::uint32_t id) const {
    for (std::size_t i = batch_; i < now_.lines.size(); ++i) {
        const Line& line = now_.lines[i];
        if (line.id == id)
            return {&line, std::string_view(now_.text).substr(line.offset, line.length)};
    }
    return find_earlier(id);
}

/// The latest one before the batch.
KeptLines::Found KeptLines::find_earlier(std::uint32_t id) const {
    const auto find_in = [id](const Chunk& chunk, std::size_t count) -> Found {
        while (count > 0) {
            const Line& line = chunk.lines[--count];
            if (line.id == id)
                return {&line, std::string_view(chunk.text).substr(line.offset, line.length)};
        }
        return {};
    };
    Found found = find_in(now_, batch_);
    for (auto chunk = earlier_.rbegin(); found.line == nullptr && chunk != earlier_.rend(); ++chunk)
        found = find_in(*chunk, chunk->lines.size());
    return found;
}

template <typename IsWanted>
TextLocation KeptLines::word_location(const Block& block, IsWanted is_wanted) const {
    const Found kept = find(block.line);
    if (kept.line == nullptr) return reader_.location({}, block.line, {});
    const std::string& file =
        kept.line->file != nullptr ? *kept.line->file : reader_.bounds().text().name;
    return location_in_line(file, kept.text, kept.line->number,
                            find_word(reader_.tables(), kept.text, is_wanted));
}

std::vector<TextLocation> KeptLines::calls(const Block& block) const {
    const Found kept = find(block.line);
    return kept.line == nullptr ? std::vector<TextLocation>()
                                : locations_of(kept.line->calls.get());
}

TextLocation KeptLines::location(const Block& block) const {
    return word_location(block, [](const GivenWord&) { return true; });
}

TextLocation KeptLines::location(const Block& block, Slot slot) const {
    const DialectTables& tables = reader_.tables();
    return word_location(block, [&](const GivenWord& word) {
        return tables.addresses[word.address].slot == static_cast<int>(slot);
    });
}

TextLocation KeptLines::location(const Block& block, Function function) const {
    const DialectTables& tables = reader_.tables();
    return word_location(block, [&](const GivenWord& word) {
        const Address& head = tables.addresses[word.address];
        const CodeStart* code =
            word.is_known ? tables.find_code(word.address, word.number) : nullptr;
        const std::vector<FormId>& forms = code != nullptr ? code->forms : head.forms;
        return std::ranges::any_of(
            forms, [&](FormId id) { return tables.forms[id].function == function; });
    });
}

}  // namespace kadr::nc
