#include "driver/format.h"

#include <algorithm>
#include <memory>

#include "base/diagnostics/driver.h"
#include "driver/execution.h"
#include "driver/file_text.h"
#include "driver/modules.h"
#include "driver/output.h"
#include "syntax/format.h"

namespace kadr::driver {

namespace {

/// The first line that differs, without its end; both texts differ somewhere.
SourceRange first_difference(FileId file, std::string_view old, std::string_view wanted) {
    const auto [at, other] = std::mismatch(old.begin(), old.end(), wanted.begin(), wanted.end());
    const auto index = static_cast<std::size_t>(at - old.begin());
    std::size_t begin = index == 0 ? std::string_view::npos : old.rfind('\n', index - 1);
    begin = begin == std::string_view::npos ? 0 : begin + 1;
    const std::size_t end = std::min(old.find('\n', index), old.size());
    return {file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

void replace(Session& session, const std::string& source, std::string_view text) {
    const auto output = Output::open(session.files(), source, session.messages());
    if (output == nullptr) return session.mark_usage();
    output->write(text);
    if (!output->commit(session.messages())) session.mark_usage();
}

void format_one(Session& session, const std::string& source, FormatMode mode) {
    auto text = open_source(session, source);
    if (!text) return;
    if (source != "-" && !is_kadr_name(source)) {
        session.messages().report(diag::NotFormattable).arg(source);
        return session.mark_usage();
    }
    const FileId file = keep_source(session, source, *text);
    const SourceWords words = words_of(session, file);
    if (!words) return;
    const auto wanted = syntax::format(session.sources(), file, *words.keywords, *words.dialect,
                                       session.messages());
    if (!wanted) return;
    const std::string_view old = session.sources().text(file);
    if (mode == FormatMode::Check) {
        if (*wanted == old) return;
        session.messages().report(diag::LayoutDiffers, first_difference(file, old, *wanted));
    } else if (*wanted != old || source == "-") {
        replace(session, source, *wanted);
    }
}

}  // namespace

Status format(Session& session, std::span<const std::string> sources, FormatMode mode) {
    for (const std::string& source : sources) format_one(session, source, mode);
    return session.status();
}

}  // namespace kadr::driver
