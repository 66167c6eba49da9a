#include "driver/output_names.h"

#include <filesystem>
#include <system_error>

#include "base/diagnostics/driver.h"

namespace kadr::driver {

namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
    if (a == b) return true;
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    // Neither need exist yet.
    return fs::weakly_canonical(fs::absolute(a, error), error) ==
           fs::weakly_canonical(fs::absolute(b, error), error);
}

/// Devices and pipes may be named as often as one likes: `/dev/null`.
bool is_device(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

Done require_outputs_apart(const std::string& source, std::span<const std::string> outputs,
                           DiagnosticSink& sink) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (outputs[i].empty()) continue;
        if (source != "-" && outputs[i] != "-" && is_same_file(source, outputs[i])) {
            sink.report(diag::OutputIsSource).arg(outputs[i]);
            return kFailed;
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (outputs[k].empty() || is_device(outputs[i])) continue;
            if (!is_same_file(outputs[i], outputs[k])) continue;
            sink.report(diag::OutputTwice).arg(outputs[i]);
            return kFailed;
        }
    }
    return kDone;
}

}  // namespace kadr::driver
