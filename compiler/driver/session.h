// session.h — what one command has for itself: options, its texts, its sink, what it may read and
// write; and its view of what commands share.
//
// The command line makes one for a command; the prompt and the language server one for each input
// or check, upon the same shared inputs. Nothing here prints: messages go to the sink, results to
// outputs.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "base/diagnostic.h"
#include "base/done.h"
#include "base/file_access.h"
#include "base/source.h"
#include "driver/deadline.h"
#include "driver/messages.h"
#include "driver/options.h"
#include "driver/output.h"
#include "driver/share.h"
#include "driver/shared_inputs.h"
#include "machine/described_machine.h"
#include "machine/machine.h"
#include "nc/dialect.h"
#include "nc/inspect.h"
#include "syntax/parse.h"

namespace kadr::driver {

/// How far a long command has come; reported every few thousand blocks.
struct Progress {
    std::uint64_t blocks = 0;
    std::uint64_t setpoints = 0;
    double time = 0;  // s of machine time
};

class Session {
  public:
    /// All references outlive the session. `sources` are new ones of the inputs.
    Session(Options options, SharedInputs& inputs, Sources& sources, Messages& messages);

    const Options& options() const { return options_; }
    SharedInputs& inputs() { return inputs_; }
    const Share& share() const { return inputs_.share(); }
    Sources& sources() { return sources_; }
    const Sources& sources() const { return sources_; }
    Messages& messages() { return messages_; }
    /// Where texts come from, and where results go.
    Files& files() const { return inputs_.files(); }
    /// Which of them may be read, and which were.
    FileAccess& access() { return access_; }
    const FileAccess& access() const { return access_; }
    /// How long the command may compute, from its beginning on.
    const Deadline& deadline() const { return deadline_; }
    /// For all outputs of the command.
    OutputRules output_rules() { return {&access_, &output_limit_}; }
    const OutputLimit& output_limit() const { return output_limit_; }
    /// The outputs are no larger than they may be; if they are, it is reported once. Asked by one
    /// thread.
    Done require_output_room();

    /// The name of a file in outputs: as the user wrote it; below the standard library it begins
    /// with `stdlib/`, so that outputs are the same on every computer.
    std::string output_name(FileId file) const;
    /// A statement in outputs: "part.kadr:34"; empty for an invalid range.
    std::string source_name(const SourceRange& range) const;

    /// A dialect by name or file; each is loaded once. Null, with messages, if it has mistakes.
    /// `location`: where a source names it, for the message that there is none; invalid: nowhere.
    const nc::Dialect* dialect(const std::string& name_or_file, const SourceRange& location = {}) {
        return kept_dialect(name_or_file, location).get();
    }
    /// … for somebody who keeps it longer than the session.
    std::shared_ptr<const nc::Dialect> kept_dialect(const std::string& name_or_file,
                                                    const SourceRange& location);
    /// A dialect that is looked at for its mistakes, which go to `found`; nothing in it, if its
    /// files may not be read.
    nc::InspectedDialect inspect_dialect(const std::string& name_or_file, DiagnosticSink& found);
    /// A machine that the user names; nothing, with messages, if it has mistakes. `option`: where
    /// it is asked for, for the message that there is none.
    std::optional<machine::DescribedMachine> load_machine(const std::string& name_or_file,
                                                          std::string_view option = {});
    /// A keyword language by name or file, likewise.
    const syntax::KeywordTable* keywords(const std::string& name_or_file,
                                         const SourceRange& location = {}) {
        return kept_keywords(name_or_file, location).get();
    }
    std::shared_ptr<const syntax::KeywordTable> kept_keywords(const std::string& name_or_file,
                                                              const SourceRange& location);
    /// The dialect of the options or, if they name none, `otherwise`. A failure is wrong usage.
    const nc::Dialect* chosen_dialect(const std::string& otherwise);
    /// The stock machine for the dialect of the options: a lathe for the control of a lathe.
    std::string stock_machine();
    /// The machine of the options, or the stock one, with the tools of the library; null, with
    /// messages, if it has mistakes.
    const machine::Machine* machine();
    /// The tool library of the options, else the one that the machine of the options names; null:
    /// none is named, or, with messages, it has mistakes.
    const machine::ToolLibrary* tools();
    /// A program imports the library in this file; that of the options would stand in for it, that
    /// of a machine stands back. Not done: reported.
    Done import_tools(const std::string& file, const SourceRange& location);
    /// What it gives to programs; behind `machine`, which has loaded it.
    const machine::MachineData& machine_data() const {
        static const machine::MachineData none;
        return machine_ == nullptr ? none : machine_->data;
    }

    /// Called now and then while a long command works.
    void set_progress(std::function<void(const Progress&)> progress) {
        progress_ = std::move(progress);
    }
    void report(const Progress& progress) const {
        if (progress_) progress_(progress);
    }

    /// Notes that the user asked for something that is not there: a file that cannot be read or
    /// written, an unknown control. It has been reported.
    void mark_usage() { is_usage_ = true; }
    /// How what was done so far ended, by the messages that came.
    Status status() const;

  private:
    bool is_of_share(const std::string& name) const;
    void equip_machine();
    Done admit(const std::string& file, const std::string& beside, const SourceRange& location);
    Done admit_since(std::size_t first, const std::string& beside);
    template <typename T>
    std::shared_ptr<const T> admit_load(const SharedLoad<T>& load, const std::string& beside,
                                        const SourceRange& location, std::string_view option);

    Options options_;
    SharedInputs& inputs_;
    Sources& sources_;
    Messages& messages_;
    FileAccess access_;
    Deadline deadline_;
    OutputLimit output_limit_;
    // Each is looked for once; null: it has mistakes, which have been reported.
    std::map<std::string, std::shared_ptr<const nc::Dialect>> dialects_;
    std::map<std::string, std::shared_ptr<const syntax::KeywordTable>> keywords_;
    std::shared_ptr<const machine::DescribedMachine> bare_machine_;  // as its file has it
    std::shared_ptr<const machine::DescribedMachine> machine_;  // with the tools of the library
    std::shared_ptr<const machine::ToolLibrary> tools_;
    bool machine_was_loaded_ = false;
    bool tools_were_loaded_ = false;
    std::string imported_tools_;  // the file that a program has named
    bool is_usage_ = false;
    std::function<void(const Progress&)> progress_;
};

}  // namespace kadr::driver
