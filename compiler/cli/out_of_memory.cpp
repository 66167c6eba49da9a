#include "cli/out_of_memory.h"

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include <unistd.h>

#include "base/diagnostics/driver.h"
#include "driver/options.h"

namespace kadr::cli {

namespace {

/// A handler of the runtime can reach nothing but a global.
std::atomic<bool> says_json{false};

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
    says_json = format == driver::MessageFormat::Json;
}

int report_out_of_memory() {
    const bool json = says_json;
    const DiagnosticRow& row = diag::OutOfMemory;
    write(json ? R"({"file":"","severity":"error","code":")" : "error[");
    write(row.code);
    write(json ? R"(","message":")" : "]: ");
    write(row.message);
    write(json ? "\",\"notes\":[],\"fixes\":[]}\n" : "\n");
    return static_cast<int>(driver::Status::Failed);
}

}  // namespace kadr::cli
