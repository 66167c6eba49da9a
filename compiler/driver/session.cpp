#include "driver/session.h"

#include <optional>
#include <utility>

namespace kadr::driver {

namespace {

constexpr const char* kStockMachine = "mill";

/// Loads on first use; a failure is remembered too, so that it is reported once.
template <typename T, typename Load>
const T* load_once(std::map<std::string, std::unique_ptr<T>>& loaded, const std::string& name,
                   const Load& load) {
    const auto known = loaded.find(name);
    if (known != loaded.end()) return known->second.get();
    std::optional<T> fresh = load();
    auto owned = fresh ? std::make_unique<T>(std::move(*fresh)) : nullptr;
    return loaded.emplace(name, std::move(owned)).first->second.get();
}

}  // namespace

Session::Session(Options options, Share share, Sources& sources, Messages& messages)
    : options_(std::move(options)),
      share_(std::move(share)),
      sources_(sources),
      messages_(messages) {}

const nc::Dialect* Session::dialect(const std::string& name_or_file) {
    return load_once(dialects_, name_or_file, [&] {
        return nc::load_dialect(name_or_file, share_.dialects, sources_, messages_);
    });
}

const nc::Dialect* Session::chosen_dialect(const std::string& otherwise) {
    const nc::Dialect* chosen = dialect(options_.dialect.empty() ? otherwise : options_.dialect);
    if (chosen == nullptr) mark_usage();
    return chosen;
}

const syntax::KeywordTable* Session::keywords(const std::string& name_or_file) {
    return load_once(keywords_, name_or_file, [&] {
        return syntax::load_keywords(name_or_file, share_.languages, sources_, messages_);
    });
}

const machine::Machine* Session::machine() {
    if (!machine_was_loaded_) {
        machine_was_loaded_ = true;
        const std::string& asked = options_.machine.empty() ? kStockMachine : options_.machine;
        std::optional<machine::Machine> fresh =
            machine::load_machine(asked, share_.machines, sources_, messages_);
        if (!fresh) mark_usage();
        if (fresh) machine_ = std::make_unique<machine::Machine>(std::move(*fresh));
    }
    return machine_.get();
}

std::string Session::output_name(FileId file) const {
    const std::string_view name = sources_.name(file);
    const std::string library = share_.library + '/';
    if (!name.starts_with(library)) return std::string(name);
    return "stdlib/" + std::string(name.substr(library.size()));
}

std::string Session::source_name(const SourceRange& range) const {
    if (!range.file.is_valid()) return {};
    return output_name(range.file) + ':' +
           std::to_string(sources_.locate(range.file, range.begin).line);
}

Status Session::status() const {
    if (is_usage_) return Status::Usage;
    if (messages_.errors() > 0) return Status::Failed;
    if (messages_.alarms() > 0) return Status::Alarm;
    return Status::Done;
}

}  // namespace kadr::driver
