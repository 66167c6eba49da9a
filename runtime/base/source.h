// source.h — texts and locations in them.
//
// Every message, block, command and setpoint can point at the text that caused it. Locations are
// byte offsets; lines and columns are computed when somebody has to read them.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace kadr {

/// Index of a text in `Sources`.
struct FileId {
    std::uint32_t index = kNone;
    static constexpr std::uint32_t kNone = 0xffffffffu;
    bool is_valid() const { return index != kNone; }
    friend bool operator==(FileId, FileId) = default;
};

/// A piece of a text: first byte, past-last byte.
struct SourceRange {
    FileId file;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    friend bool operator==(const SourceRange&, const SourceRange&) = default;
};

/// Names a statement of the source program; an index into the table of statement ranges that the
/// checker makes (`sema::Code::statements`). Travels from the statement to the setpoint.
struct SourceId {
    std::uint32_t index = kNone;
    static constexpr std::uint32_t kNone = 0xffffffffu;
    bool is_valid() const { return index != kNone; }
    friend bool operator==(SourceId, SourceId) = default;
};

/// A location as a person reads it. Line and column count from 1; the column counts characters
/// (code points), tabs as one.
struct LineColumn {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// The texts of a run. Texts stay where they are once added, so views into them remain valid.
///
/// Several runs may share texts: those of a Shared one have indices that no run gives to its own,
/// so that what was made from them means the same in all. Runs that share them take turns.
class Sources {
  public:
    enum class Role : std::uint8_t { Own, Shared };

    /// Files are those of the disk.
    Sources();
    /// Files come from `files`, which outlive this.
    explicit Sources(const Files& files, Role role = Role::Own);
    /// The texts of `shared` are there, too; it outlives this.
    Sources(const Files& files, const Sources& shared);

    /// Where texts are read from.
    const Files& files() const { return *store_; }
    /// Whose texts are there as well; null: nobody's.
    const Sources* shared() const { return shared_; }

    /// Adds a text under the name that messages show. A leading byte order mark is dropped.
    FileId add(std::string name, std::string text);

    /// Reads a file; `-` is standard input. Nothing, if it cannot be read.
    std::optional<FileId> read(const std::string& path);

    std::string_view name(FileId file) const;
    std::string_view text(FileId file) const;
    std::string_view text(const SourceRange& range) const;
    LineColumn locate(FileId file, std::uint32_t byte) const;
    /// The line that holds the byte, without its line end.
    std::string_view line_at(FileId file, std::uint32_t byte) const;
    /// How many texts were added here.
    std::size_t size() const { return files_.size(); }
    /// The `i`-th that was added here, from 0.
    FileId nth(std::size_t i) const { return {first_ + static_cast<std::uint32_t>(i)}; }
    /// Forgets a text that nobody will ask for.
    void drop(FileId file);

  private:
    struct File {
        std::string name;
        std::string text;
        std::vector<std::uint32_t> line_starts;
    };
    static constexpr std::uint32_t kFirstShared = 0x40000000u;

    const File& at(FileId file) const;

    const Files* store_;
    const Sources* shared_ = nullptr;
    std::uint32_t first_ = 0;  // index of the text that was added first
    std::deque<File> files_;
};

}  // namespace kadr
