#include "driver/shared_inputs.h"

#include <algorithm>

#include "base/diagnostics/driver.h"
#include "base/text.h"
#include "sema/tool_table.h"

namespace kadr::driver {

SharedInputs::SharedInputs(Files& files, Share share)
    : files_(files),
      share_(std::move(share)),
      asked_(files),
      sources_(asked_, Sources::Role::Shared) {}

/// What is kept, if its files are what they were; else what `load(sink)` makes of them now.
template <typename T, typename Load>
SharedLoad<T> SharedInputs::load(SharedLoad<T>& kept, const Load& load) {
    const auto is_so = [this](const FileAnswer& answer) { return is_still_so(answer, files_); };
    if (kept != nullptr && std::ranges::all_of(kept->answers, is_so)) return kept;
    ++loads_;
    const std::size_t first = sources_.size();
    (void)asked_.take_answers();
    DiagnosticList messages;
    auto fresh = std::make_shared<Loaded<T>>();
    fresh->value = load(messages);
    fresh->messages = messages.all();
    fresh->answers = asked_.take_answers();
    for (std::size_t i = first; i < sources_.size(); ++i)
        fresh->texts.emplace_back(sources_, sources_.nth(i));
    return kept = std::move(fresh);
}

SharedLoad<nc::Dialect> SharedInputs::dialect(nc::MachineKind kind,
                                              const std::string& name_or_file) {
    return load(dialects_[{kind, name_or_file}], [&](DiagnosticSink& sink) {
        return nc::load_dialect_for(kind, name_or_file, share_.dialects, sources_, sink);
    });
}

SharedLoad<syntax::KeywordTable> SharedInputs::keywords(const std::string& name_or_file) {
    return load(keywords_[name_or_file], [&](DiagnosticSink& sink) {
        return syntax::load_keywords(name_or_file, share_.languages, sources_, sink);
    });
}

SharedLoad<machine::DescribedMachine> SharedInputs::machine(const std::string& name_or_file) {
    return load(machines_[name_or_file], [&](DiagnosticSink& sink) {
        return machine::load_described_machine(name_or_file, share_.machines, sources_, sink);
    });
}

SharedLoad<machine::ToolLibrary> SharedInputs::tools(const std::string& file) {
    return load(tools_[file], [&](DiagnosticSink& sink) -> std::optional<machine::ToolLibrary> {
        const auto text = sources_.read(file);
        if (!text) {
            sink.report(diag::FileUnreadable).arg(file);
            return std::nullopt;
        }
        return upper_ascii(file).ends_with(".XML")
                   ? machine::load_tool_library(*text, sources_, sink)
                   : sema::read_tool_table(*text, sources_, sink);
    });
}

std::shared_ptr<SharedTree> SharedInputs::tree(const std::string& path, std::string content) {
    const auto known = trees_.find(path);
    if (known != trees_.end() && known->second->content == content) return known->second;
    return new_tree(path, std::move(content));
}

std::shared_ptr<SharedTree> SharedInputs::new_tree(const std::string& path, std::string content) {
    SharedText text(sources_, sources_.add(path, content));
    return trees_[path] = std::make_shared<SharedTree>(
               SharedTree{std::move(content), std::move(text), {}, std::nullopt, {}});
}

}  // namespace kadr::driver
