#include "driver/share.h"

#include <cstdlib>
#include <filesystem>

namespace kadr::driver {

Share share_below(const std::string& root, const Files& files) {
    const std::filesystem::path base(root);
    Share share;
    share.dialects = {(base / "dialects").string()};
    share.languages = {(base / "dialects" / "languages").string()};
    const bool is_source_tree = files.is_folder((base / "runtime" / "machines").string());
    share.machines = {
        (is_source_tree ? base / "runtime" / "machines" : base / "machines").string()};
    share.library = (base / "stdlib").string();
    // Bundled when Kadr is built, so that a source tree does not have it.
    share.page_template =
        is_source_tree ? KADR_PAGE_TEMPLATE : (base / "web" / "page.html").string();
    return share;
}

Share find_share(const Files& files) {
    if (const char* chosen = std::getenv("KADR_SHARE"); chosen != nullptr && *chosen != '\0') {
        return share_below(chosen, files);
    }
    if (const auto program = files.link_target("/proc/self/exe")) {
        const auto installed =
            std::filesystem::path(*program).parent_path().parent_path() / "share" / "kadr";
        if (files.is_folder((installed / "dialects").string()))
            return share_below(installed.string(), files);
    }
    return share_below(KADR_SHARE_ROOT, files);
}

}  // namespace kadr::driver
