// forwarded_files.h — a store in front of another one, which answers all that it does not answer
// itself.
#pragma once

#include "base/files.h"

namespace kadr {

class ForwardedFiles : public Files {
  public:
    /// `below` outlives it.
    explicit ForwardedFiles(Files& below) : below_(below) {}

    FileKind kind_of(const std::string& path) const override { return below_.kind_of(path); }
    std::vector<FolderEntry> list(const std::string& folder) const override {
        return below_.list(folder);
    }
    std::string real_path(const std::string& path) const override { return below_.real_path(path); }
    std::optional<std::string> link_target(const std::string& path) const override {
        return below_.link_target(path);
    }
    std::optional<Identity> identity_of(const std::string& path) const override {
        return below_.identity_of(path);
    }
    Result<std::string, ReadFault> read(const std::string& path,
                                        std::uint64_t most_bytes) const override {
        return below_.read(path, most_bytes);
    }
    std::unique_ptr<FileReader> open(const std::string& path) const override {
        return below_.open(path);
    }
    std::unique_ptr<FileWriter> create(const std::string& path) override {
        return below_.create(path);
    }
    std::string why_unreadable(const std::string& path) const override {
        return below_.why_unreadable(path);
    }
    std::string why_unwritable(const std::string& path) const override {
        return below_.why_unwritable(path);
    }

  protected:
    const Files& below() const { return below_; }

  private:
    Files& below_;
};

}  // namespace kadr
