#include "driver/output.h"

#include "base/diagnostics/driver.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 16;  // bytes between two writes to the file

std::string shown_output(const std::string& name) { return name == "-" ? "standard output" : name; }

}  // namespace

std::unique_ptr<Output> Output::open(Files& files, const std::string& path, DiagnosticSink& sink,
                                     const OutputRules& rules) {
    std::unique_ptr<Output> output(new Output(path, rules));
    if (!output->require_no_source(sink)) return nullptr;
    output->file_ = files.create(path);
    if (output->file_ != nullptr) return output;
    const std::string why = files.why_unwritable(path);
    auto message = sink.report(diag::FileUnwritable);
    message.arg(shown_output(path));
    if (!why.empty()) message.note(why);
    return nullptr;
}

void Output::write(std::string_view text) {
    if (rules_.limit != nullptr && !rules_.limit->take(text.size())) return;
    buffer_ += text;
    if (buffer_.size() >= kBuffer) flush();
}

Done Output::require_no_source(DiagnosticSink& sink) const {
    if (rules_.inputs == nullptr || name_ == "-" || !rules_.inputs->was_read(name_)) return kDone;
    sink.report(diag::OutputIsSource).arg(name_);
    return kFailed;
}

void Output::flush() {
    file_->write(buffer_);
    buffer_.clear();
}

void Output::overwrite(std::size_t at, std::string_view text) {
    flush();
    file_->overwrite(at, text);
}

Done Output::commit(DiagnosticSink& sink) {
    if (!require_no_source(sink)) return kFailed;
    flush();
    if (file_->commit()) return kDone;
    const std::string why = file_->fault();
    auto message = sink.report(diag::FileUnwritable);
    message.arg(shown_output(name_));
    if (!why.empty()) message.note(why);
    return kFailed;
}

}  // namespace kadr::driver
