// dialect_chain.h — the files of a dialect, from the one that was asked for to what all of them
// extend, and which of them defines what.
//
// Found by reading the files alone, as an editor of dialects asks for it. Nothing is reported, and
// a file with mistakes tells what can be read of it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nc/dialect.h"

namespace kadr::nc {

struct ChainFile {
    FileId file;
    std::string path;
    std::string name;     // as it calls itself
    SourceRange extends;  // the value of the attribute; not valid: it extends nothing
};

/// Something that a file of the chain defines.
struct ChainEntry {
    enum class Kind : std::uint8_t {
        Word,          // that begins a spelling of a function or of a cycle: `G83`, `TRANS`
        Address,       // the head of words with values: `X`
        Rule,          // of the control
        LanguageRule,  // of its parametric language
        Operator,      // by its text, as the following
        Function,
        Variable,
        Statement,
        Call,         // a code or a name that calls a program
        Argument,     // a letter of a macro call
        Type,         // of variables
        Alarm,        // by the diagnostic
        Unsupported,  // a word that the control has and Kadr does not read
        Foreign,      // a word of other controls
        Passed,       // a word on which nothing depends
    };
    Kind kind = Kind::Word;
    std::string name;
    std::string of;        // of a Word: the function or the cycle that it spells
    SourceRange range;     // where the name stands
    std::size_t file = 0;  // index into DialectChain::files
    bool acts = true;      // no nearer file replaces it; of addresses all that is said adds up
};

struct DialectChain {
    std::vector<ChainFile> files;     // each extends the next one
    std::vector<ChainEntry> entries;  // by file, in its order
    bool is_whole = false;            // what the last file extends was found, or it extends nothing
};

/// The chain of a dialect, found as `load_dialect` finds it; the files are added to `sources`.
/// Without files: there is no such dialect.
DialectChain dialect_chain(const std::string& name_or_file, const SearchPath& folders,
                           Sources& sources);

/// The file to which the value of `extends` at this byte leads; null: there is none, or something
/// else stands there.
const ChainFile* extended_at(const DialectChain& chain, FileId file, std::uint32_t byte);

/// All entries of a name, those that act first, then by file.
std::vector<const ChainEntry*> entries_of(const DialectChain& chain, ChainEntry::Kind kind,
                                          std::string_view name);

}  // namespace kadr::nc
