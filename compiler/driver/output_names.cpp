#include "driver/output_names.h"

#include "base/diagnostics/driver.h"

namespace kadr::driver {

namespace {

bool is_same_file(const Files& files, const std::string& a, const std::string& b) {
    if (a == b) return true;
    const auto identity = files.identity_of(a);
    // Neither need exist yet.
    return (identity && identity == files.identity_of(b)) ||
           files.real_path(a) == files.real_path(b);
}

/// Devices and pipes may be named as often as one likes: `/dev/null`.
bool is_device(const Files& files, const std::string& path) {
    const FileKind kind = files.kind_of(path);
    return kind == FileKind::Special || kind == FileKind::Folder;
}

}  // namespace

Done require_outputs_apart(const Files& files, const std::string& source,
                           std::span<const std::string> outputs, DiagnosticSink& sink) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (outputs[i].empty()) continue;
        if (source != "-" && outputs[i] != "-" && is_same_file(files, source, outputs[i])) {
            sink.report(diag::OutputIsSource).arg(outputs[i]);
            return kFailed;
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (outputs[k].empty() || is_device(files, outputs[i])) continue;
            if (!is_same_file(files, outputs[i], outputs[k])) continue;
            sink.report(diag::OutputTwice).arg(outputs[i]);
            return kFailed;
        }
    }
    return kDone;
}

}  // namespace kadr::driver
