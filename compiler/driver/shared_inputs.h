// shared_inputs.h — what many checks have in common: dialects, keyword languages, machines and the
// trees of files that programs import.
//
// Each is made once and kept as long as its files are what they were; who asks again gets the same
// one, and pays no more than the reading of those files. A prompt and a language server keep one;
// a command makes one for itself.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/source.h"
#include "driver/asked_files.h"
#include "driver/share.h"
#include "machine/described_machine.h"
#include "machine/tool_library.h"
#include "nc/dialect.h"
#include "nc/dialect_on_machine.h"
#include "syntax/parse.h"

namespace kadr::driver {

/// A text of the shared sources, as long as somebody needs it.
class SharedText {
  public:
    SharedText(Sources& sources, FileId file) : sources_(&sources), file_(file) {}
    SharedText(SharedText&& other) noexcept
        : sources_(std::exchange(other.sources_, nullptr)), file_(other.file_) {}
    SharedText& operator=(SharedText&&) = delete;
    ~SharedText() {
        if (sources_ != nullptr) sources_->drop(file_);
    }
    FileId file() const { return file_; }

  private:
    Sources* sources_;
    FileId file_;
};

/// What a loader made, with all that it depends on. No value: the files have mistakes.
template <typename T>
struct Loaded {
    std::optional<T> value;
    std::vector<Diagnostic> messages;  // reported whenever somebody asks for it
    std::vector<SharedText> texts;     // that were read, in that order
    std::vector<FileAnswer> answers;   // … and where they were looked for
};
template <typename T>
using SharedLoad = std::shared_ptr<const Loaded<T>>;

/// The words that a source is written in: keywords of its language, words of its input dialect.
/// Null where they cannot be loaded, which is reported.
struct SourceWords {
    std::shared_ptr<const syntax::KeywordTable> keywords;
    std::shared_ptr<const nc::Dialect> dialect;
    explicit operator bool() const { return keywords != nullptr && dialect != nullptr; }
    friend bool operator==(const SourceWords&, const SourceWords&) = default;
};

/// A file that programs import. A tree holds for the words that it was parsed with.
struct SharedTree {
    std::string content;  // of the file, byte by byte
    SharedText text;
    SourceWords words;
    std::optional<syntax::Ast> ast;    // nothing: it has not been parsed yet
    std::vector<Diagnostic> messages;  // of the parser; reported whenever somebody uses it
};

/// Commands that share it take turns: one at a time loads.
class SharedInputs {
  public:
    /// `files` outlives it.
    SharedInputs(Files& files, Share share);

    Files& files() { return files_; }
    const Share& share() const { return share_; }
    /// The texts of what is kept.
    const Sources& sources() const { return sources_; }
    /// Sources for one command, in which those texts are, too.
    Sources new_sources() const { return {files_, sources_}; }

    /// By name or file, as a control has it on machines of this kind.
    SharedLoad<nc::Dialect> dialect(nc::MachineKind kind, const std::string& name_or_file);
    SharedLoad<syntax::KeywordTable> keywords(const std::string& name_or_file);
    SharedLoad<machine::DescribedMachine> machine(const std::string& name_or_file);
    /// A tool library: XML by the ending of its name, else a table.
    SharedLoad<machine::ToolLibrary> tools(const std::string& file);

    /// The file at `path` with this content, as the last one who asked left it.
    std::shared_ptr<SharedTree> tree(const std::string& path, std::string content);
    /// … for somebody whose words are others: to be parsed anew.
    std::shared_ptr<SharedTree> new_tree(const std::string& path, std::string content);

    /// How often a loader or the parser has worked, for tests and figures.
    std::size_t loads() const { return loads_; }
    void count_parse() { ++loads_; }

  private:
    template <typename T, typename Load>
    SharedLoad<T> load(SharedLoad<T>& kept, const Load& load);

    Files& files_;
    Share share_;
    AskedFiles asked_;
    Sources sources_;
    std::map<std::pair<nc::MachineKind, std::string>, SharedLoad<nc::Dialect>> dialects_;
    std::map<std::string, SharedLoad<syntax::KeywordTable>> keywords_;
    std::map<std::string, SharedLoad<machine::DescribedMachine>> machines_;
    std::map<std::string, SharedLoad<machine::ToolLibrary>> tools_;
    std::map<std::string, std::shared_ptr<SharedTree>> trees_;  // by path
    std::size_t loads_ = 0;
};

}  // namespace kadr::driver
