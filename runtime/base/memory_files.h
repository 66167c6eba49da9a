// memory_files.h — files that are nowhere but here: for tests, archives, a page.
#pragma once

#include <map>
#include <mutex>

#include "base/files.h"

namespace kadr {

/// A path is taken from the root, `a/../b` is `b`; a folder is there as long as it holds a file.
/// There are no links and no permissions. Threads may share it.
class MemoryFiles final : public Files {
  public:
    /// Puts a file there, or replaces it; of `-` what standard input has.
    void put(const std::string& path, std::string text);
    void remove(const std::string& path);
    /// What was written to standard output, in the order in which it was completed.
    std::string output() const;

    FileKind kind_of(const std::string& path) const override;
    std::vector<FolderEntry> list(const std::string& folder) const override;
    std::string real_path(const std::string& path) const override;
    std::optional<std::string> link_target(const std::string&) const override { return {}; }
    std::optional<Identity> identity_of(const std::string& path) const override;
    Result<std::string, ReadFault> read(const std::string& path,
                                        std::uint64_t most_bytes) const override;
    std::unique_ptr<FileReader> open(const std::string& path) const override;
    std::unique_ptr<FileWriter> create(const std::string& path) override;
    std::string why_unreadable(const std::string& path) const override;
    std::string why_unwritable(const std::string& path) const override;

  private:
    class Writer;
    /// A text that readers keep while a writer replaces it.
    using Text = std::shared_ptr<const std::string>;

    Text find(const std::string& path) const;

    mutable std::mutex mutex_;
    std::map<std::string, Text> texts_;  // by real path; standard input by `-`
    std::string output_;
};

/// Reads a text that is in memory.
class MemoryReader final : public FileReader {
  public:
    explicit MemoryReader(std::shared_ptr<const std::string> text) : text_(std::move(text)) {}
    std::size_t read(std::span<char> piece) override;
    bool seek(std::uint64_t offset) override;

  private:
    std::shared_ptr<const std::string> text_;
    std::size_t at_ = 0;
};

/// Absolute and without `..`, seen from the root.
std::string path_from_root(const std::string& path);

}  // namespace kadr
