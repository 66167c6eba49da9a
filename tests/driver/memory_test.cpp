// Everything from memory: no file of the disk is read or written. An editor's texts, what checks
// share, and how a check is cancelled.
#include <atomic>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/memory_files.h"
#include "base/overlay_files.h"
#include "driver/check.h"
#include "driver/expand.h"
#include "driver/program.h"
#include "driver/run.h"
#include "driver/session.h"
#include "tests/common/inputs.h"

namespace kadr::memory_test {

namespace {

namespace fs = std::filesystem;
using driver::SharedInputs;
using driver::Status;

// A root that no disk has.
const std::string kShare = "/no-disk/kadr";
const std::string kWork = "/no-disk/work";

/// What Kadr needs, below `kShare`.
void put_share(MemoryFiles& files) {
    for (const char* folder : {"dialects", "runtime/machines", "stdlib"}) {
        const fs::path root = fs::path(KADR_ROOT) / folder;
        for (const auto& entry : fs::recursive_directory_iterator(root)) {
            if (!entry.is_regular_file()) continue;
            const fs::path below = fs::relative(entry.path(), KADR_ROOT);
            files.put(kShare + '/' + below.string(), read_file(entry.path().string()).value());
        }
    }
}

/// One command with its own texts and messages.
class Command {
  public:
    explicit Command(SharedInputs& inputs, const std::string& dialect = {},
                     const std::atomic<bool>* stop = nullptr)
        : sources_(inputs.new_sources()),
          session_(options_of(dialect, stop), inputs, sources_, messages_) {}

    driver::Session& session() { return session_; }
    const std::string& heard() const { return heard_; }

    Status check(const std::string& file) {
        const std::string names[] = {file};
        return driver::check(session_, names);
    }

    Status expand(const std::string& source, const std::string& output = "-") {
        driver::ExpandJob job;
        job.source = source;
        job.output = output;
        return driver::expand(session_, job);
    }
    Status run(const std::string& source, const std::map<std::string, std::string>& outputs) {
        driver::RunJob job;
        job.source = source;
        job.outputs.insert(outputs.begin(), outputs.end());
        return driver::run(session_, job);
    }

  private:
    static driver::Options options_of(const std::string& dialect, const std::atomic<bool>* stop) {
        driver::Options options;
        options.dialect = dialect;
        options.stop = stop;
        return options;
    }

    Sources sources_;
    std::string heard_;
    driver::Messages messages_{sources_, {}, [this](std::string_view text) { heard_ += text; }};
    driver::Session session_;
};

class Memory : public ::testing::Test {
  protected:
    void SetUp() override {
        put_share(files_);
        files_.put(kWork + "/own.kadr", "cycle hop(length to) { G0 Z=to; }\n");
        files_.put(kWork + "/holes.csv", "x,y\n10,20\n30,40\n");
        files_.put(kWork + "/part.kadr", kPart);
        inputs_.emplace(files_, driver::share_below(kShare, files_));
    }

    static constexpr const char* kPart =
        "import own;\n"
        "import cycles.drilling;\n"
        "struct Hole { length x; length y; }\n"
        "program part() {\n"
        "  T1 M6; S2000 M3; G0 X0 Y0 Z10;\n"
        "  F200;\n"
        "  for (Hole hole : table<Hole>(\"holes.csv\")) {\n"
        "    G0 X=hole.x Y=hole.y;\n"
        "    drill(to: -5mm, retract: 2mm);\n"
        "  }\n"
        "  hop(to: 50mm);\n"
        "}\n";

    std::string text_of(const std::string& file) const {
        const auto text = files_.read(file, Files::kMostBytes);
        return text ? *text : "(there is no " + file + ')';
    }

    MemoryFiles files_;
    std::optional<SharedInputs> inputs_;
};

TEST_F(Memory, ExpandsToATextThatItThenRuns) {
    Command expanding(*inputs_, "fanuc");
    ASSERT_EQ(expanding.expand(kWork + "/part.kadr", kWork + "/part.nc"), Status::Done)
        << expanding.heard();
    const std::string text = text_of(kWork + "/part.nc");
    EXPECT_NE(text.find("X30. Y40."), std::string::npos) << text;
    EXPECT_NE(text.find("G81"), std::string::npos) << text;

    Command running(*inputs_, "fanuc");
    ASSERT_EQ(running.run(kWork + "/part.nc",
                          {{"--commands", kWork + "/commands.jsonl"}, {"--summary", "json"}}),
              Status::Done)
        << running.heard();
    EXPECT_NE(text_of(kWork + "/commands.jsonl").find("\"X\":30,\"Y\":40"), std::string::npos);
    EXPECT_NE(files_.output().find("\"time_s\""), std::string::npos) << files_.output();
    EXPECT_FALSE(fs::exists("/no-disk"));
}

TEST_F(Memory, HasTheMessagesOfADisk) {
    files_.put(kWork + "/wrong.kadr", "import cycles.driling;\nprogram p() { G0 X=wdth; }\n");
    Command checking(*inputs_);
    EXPECT_EQ(checking.check(kWork + "/wrong.kadr"), Status::Failed);
    EXPECT_NE(checking.heard().find("there is a module `cycles.drilling`"), std::string::npos)
        << checking.heard();
    Command missing(*inputs_);
    EXPECT_EQ(missing.check(kWork + "/nowhere.kadr"), Status::Usage);
    EXPECT_NE(missing.heard().find("there is no such file"), std::string::npos) << missing.heard();
    // Nothing of the disk can be named either: the store is the only door.
    Command disk(*inputs_);
    EXPECT_EQ(disk.check(KADR_ROOT "/examples/face.kadr"), Status::Usage);
}

TEST_F(Memory, ReadsStandardInputAndCallsProgramsBeside) {
    files_.put(kWork + "/main.mpf", "G0 X1\nHOP(7)\nM30\n");
    files_.put(kWork + "/HOP.SPF", "PROC HOP(REAL TO)\nG0 Z=TO\nM17\n");
    Command calling(*inputs_, "sinumerik");
    ASSERT_EQ(calling.run(kWork + "/main.mpf", {{"--commands", "-"}}), Status::Done)
        << calling.heard();
    EXPECT_NE(files_.output().find("\"Z\":7"), std::string::npos) << files_.output();

    files_.put("-", "program p() { G0 X77; }\n");
    Command typed(*inputs_, "fanuc");
    ASSERT_EQ(typed.expand("-"), Status::Done) << typed.heard();
    EXPECT_NE(files_.output().find("X77."), std::string::npos) << files_.output();
}

TEST_F(Memory, AnEditorsTextsLieOverTheFiles) {
    OverlayFiles editor(files_);
    SharedInputs inputs(editor, driver::share_below(kShare, editor));
    const std::string part = kWork + "/part.kadr";
    Command saved(inputs);
    EXPECT_EQ(saved.check(part), Status::Done) << saved.heard();
    // The imported file is being edited; the name reaches it by another path.
    editor.put(kWork + "/sub/../own.kadr", "cycle hop(length up) { G0 Z=up; }\n");
    Command edited(inputs);
    EXPECT_EQ(edited.check(part), Status::Failed);
    EXPECT_NE(edited.heard().find("`hop` has no parameter `to`"), std::string::npos)
        << edited.heard();
    // A file that is not there yet.
    editor.put(kWork + "/new.kadr", "import own;\nprogram p() { hop(up: 3mm); }\n");
    Command fresh(inputs);
    EXPECT_EQ(fresh.check(kWork + "/new.kadr"), Status::Done) << fresh.heard();
    editor.remove(kWork + "/own.kadr");
    Command closed(inputs);
    EXPECT_EQ(closed.check(part), Status::Done) << closed.heard();
}

// ---------------------------------------------------------------- what checks share

TEST_F(Memory, ACheckAgainLoadsNothingButItsOwnText) {
    const std::string part = kWork + "/part.kadr";
    Command first(*inputs_);
    ASSERT_EQ(first.check(part), Status::Done) << first.heard();
    const std::size_t loads = inputs_->loads();
    EXPECT_GT(loads, 5U);  // a dialect, a language, a machine, the prelude, what it imports, itself
    Command second(*inputs_);
    ASSERT_EQ(second.check(part), Status::Done) << second.heard();
    EXPECT_EQ(inputs_->loads(), loads + 1);
    // One imported file is another: it is parsed, and the program itself.
    files_.put(kWork + "/own.kadr", "cycle hop(length to) { G0 Z=to + 1mm; }\n");
    Command third(*inputs_);
    ASSERT_EQ(third.check(part), Status::Done) << third.heard();
    EXPECT_EQ(inputs_->loads(), loads + 3);
    EXPECT_EQ(first.heard() + second.heard() + third.heard(), "");
}

TEST_F(Memory, WarningsOfWhatIsSharedComeInEachCheck) {
    files_.put(kWork + "/own.kadr", "cycle hop(length to) { int unused = 1; G0 Z=to }\n");
    Command first(*inputs_);
    Command second(*inputs_);
    EXPECT_EQ(first.check(kWork + "/part.kadr"), Status::Failed);
    EXPECT_EQ(second.check(kWork + "/part.kadr"), Status::Failed);
    EXPECT_NE(first.heard().find("own.kadr:1:"), std::string::npos) << first.heard();
    EXPECT_EQ(first.heard(), second.heard());
}

TEST_F(Memory, ADialectIsLoadedAgainWhenOneOfItsFilesChanges) {
    const std::string own = kWork + "/shop.xml";
    const std::string text =
        "<dialect name=\"shop\" title=\"Shop\" suffix=\"nc\" extends=\"fanuc\"/>";
    files_.put(own, text);
    const auto title = [&] {
        Command command(*inputs_, own);
        const nc::Dialect* dialect = command.session().dialect(own);
        return dialect == nullptr ? command.heard() : std::string(dialect->title());
    };
    EXPECT_EQ(title(), "Shop");
    const std::size_t loads = inputs_->loads();
    EXPECT_EQ(title(), "Shop");
    EXPECT_EQ(inputs_->loads(), loads);
    files_.put(own, "<dialect name=\"shop\" title=\"Hall 2\" suffix=\"nc\" extends=\"fanuc\"/>");
    EXPECT_EQ(title(), "Hall 2");
    // A mistake in what it extends is found, and mended, too.
    const std::string base = kShare + "/dialects/fanuc.xml";
    const std::string sound = text_of(base);
    files_.put(base, "<dialect");
    EXPECT_NE(title().find("fanuc.xml:1:"), std::string::npos) << title();
    files_.put(base, sound);
    EXPECT_EQ(title(), "Hall 2");
    // A file that stands in front of the one that was found.
    files_.put(kWork + "/fanuc.xml",
               "<dialect name=\"fanuc\" title=\"F\" suffix=\"nc\" extends=\"nonesuch\"/>");
    EXPECT_NE(title().find("nonesuch"), std::string::npos) << title();
}

TEST_F(Memory, WhatOneSessionHoldsOutlivesAChange) {
    Command holding(*inputs_);
    const auto held = driver::load_program(
        holding.session(), holding.session().sources().add(kWork + "/part.kadr", kPart));
    ASSERT_TRUE(held) << holding.heard();
    files_.put(kWork + "/own.kadr", "cycle hop(length up) { G0 Z=up; }\n");
    Command other(*inputs_);
    EXPECT_EQ(other.check(kWork + "/part.kadr"), Status::Failed);
    // Its trees and texts are what they were.
    std::size_t found = 0;
    for (const SourceRange& range : held->code->statements)
        found += holding.session().sources().text(range).find("Z=to") != std::string_view::npos;
    EXPECT_GT(found, 0U);
}

// ---------------------------------------------------------------- cancelled

TEST_F(Memory, ACheckThatNobodyWantsAnyMoreEnds) {
    // By itself it would make 20 million blocks.
    files_.put(kWork + "/endless.kadr", "program p() { while (true) { G0 X1; G0 X2; } }\n");
    std::atomic<bool> stop{false};
    Command checking(*inputs_, "", &stop);
    std::thread other([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop = true;
    });
    const Status status = checking.check(kWork + "/endless.kadr");
    other.join();
    EXPECT_EQ(status, Status::Failed);
    EXPECT_NE(checking.heard().find("[K3410]"), std::string::npos) << checking.heard();
    EXPECT_EQ(checking.heard().find("[K3403]"), std::string::npos) << checking.heard();
}

TEST_F(Memory, ACancelledCommandWritesNothing) {
    files_.put(kWork + "/loop.nc", "O1\nWHILE[1EQ1]DO1\nG0X1.\nG0X2.\nEND1\nM30\n");
    std::atomic<bool> stop{true};
    Command running(*inputs_, "fanuc", &stop);
    EXPECT_NE(running.run(kWork + "/loop.nc", {{"--commands", kWork + "/commands.jsonl"}}),
              Status::Done);
    EXPECT_NE(running.heard().find("[K3410]"), std::string::npos) << running.heard();

    // Before anything of it was parsed: nothing of the half is kept for the next.
    Command parsing(*inputs_, "", &stop);
    EXPECT_EQ(parsing.check(kWork + "/part.kadr"), Status::Failed);
    stop = false;
    Command again(*inputs_);
    EXPECT_EQ(again.check(kWork + "/part.kadr"), Status::Done) << again.heard();
}

}  // namespace

}  // namespace kadr::memory_test
