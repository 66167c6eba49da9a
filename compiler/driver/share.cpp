#include "driver/share.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace kadr::driver {

namespace {

bool is_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

}  // namespace

Share share_below(const std::string& root) {
    const std::filesystem::path base(root);
    Share share;
    share.dialects = {(base / "dialects").string()};
    share.languages = {(base / "dialects" / "languages").string()};
    const bool is_source_tree = is_folder(base / "runtime" / "machines");
    share.machines = {
        (is_source_tree ? base / "runtime" / "machines" : base / "machines").string()};
    share.library = (base / "stdlib").string();
    // Bundled when Kadr is built, so that a source tree does not have it.
    share.page_template =
        is_source_tree ? KADR_PAGE_TEMPLATE : (base / "web" / "page.html").string();
    return share;
}

Share find_share() {
    if (const char* chosen = std::getenv("KADR_SHARE"); chosen != nullptr && *chosen != '\0') {
        return share_below(chosen);
    }
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        const auto installed = program.parent_path().parent_path() / "share" / "kadr";
        if (is_folder(installed / "dialects")) return share_below(installed.string());
    }
    return share_below(KADR_SHARE_ROOT);
}

}  // namespace kadr::driver
