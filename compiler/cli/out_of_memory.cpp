#include "cli/out_of_memory.h"

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include <unistd.h>

#include "base/diagnostics/driver.h"
#include "base/render.h"
#include "driver/options.h"

namespace kadr::cli {

namespace {

/// The message for a program, made while there is memory; null: it is for a person. A handler of
/// the runtime can reach nothing but a global.
std::atomic<const std::string*> json_message{nullptr};

std::string rendered_json() {
    Diagnostic diagnostic;
    diagnostic.row = &diag::OutOfMemory;
    return render_json(diagnostic, Sources()) + '\n';
}

void write(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

[[noreturn]] void on_terminate() {
    if (const std::exception_ptr thrown = std::current_exception()) {
        try {
            std::rethrow_exception(thrown);
        } catch (const std::bad_alloc&) {
            ::_exit(report_out_of_memory());
        } catch (const std::length_error&) {
            ::_exit(report_out_of_memory());
        } catch (...) {
            // Ours throws nothing else: a broken promise, which is to be seen as one.
        }
    }
    std::abort();
}

}  // namespace

void end_without_memory() { std::set_terminate(on_terminate); }

void say_out_of_memory_as(driver::MessageFormat format) {
    if (format != driver::MessageFormat::Json) return;
    static const std::string message = rendered_json();
    json_message = &message;
}

int report_out_of_memory() {
    if (const std::string* const json = json_message) {
        write(*json);
    } else {
        const DiagnosticRow& row = diag::OutOfMemory;
        write("error[");
        write(row.code);
        write("]: ");
        write(row.message);
        write("\n");
    }
    return static_cast<int>(driver::Status::Failed);
}

}  // namespace kadr::cli
