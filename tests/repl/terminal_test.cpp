// The prompt as its user has it: the program at a pseudo-terminal, and in a pipe.
#include <chrono>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace terminal_test {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kPatience{20};

/// `kadr repl` behind a pseudo-terminal, with a state folder of its own.
class Terminal {
  public:
    explicit Terminal(const fs::path& state) {
        winsize size{24, 80, 0, 0};
        pid_ = ::forkpty(&master_, nullptr, nullptr, &size);
        EXPECT_GE(pid_, 0) << "no pseudo-terminal";
        if (pid_ == 0) {
            ::setenv("XDG_STATE_HOME", state.c_str(), 1);
            ::setenv("TERM", "xterm", 1);
            ::execl(KADR_BINARY, "kadr", "repl", static_cast<char*>(nullptr));
            ::_exit(127);
        }
    }
    ~Terminal() {
        if (pid_ < 0) return;  // a kill of -1 would be one of every process
        ::close(master_);
        if (was_waited_) return;
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    void type(std::string_view text) {
        ASSERT_EQ(::write(master_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    /// Waits until the words have come since the last call; what came, or all that came in vain.
    std::string expect(std::string_view words) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (std::chrono::steady_clock::now() < end) {
            const std::size_t at = heard_.find(words);
            if (at != std::string::npos) {
                std::string before = heard_.substr(0, at + words.size());
                heard_.erase(0, at + words.size());
                return before;
            }
            pollfd ready{master_, POLLIN, 0};
            if (::poll(&ready, 1, 100) <= 0) continue;
            char buffer[4096];
            const ssize_t count = ::read(master_, buffer, sizeof buffer);
            if (count <= 0) break;
            heard_.append(buffer, static_cast<std::size_t>(count));
        }
        ADD_FAILURE() << "waited for: " << words << "\ncame: " << heard_;
        return heard_;
    }
    /// The program's exit status; -1: it did not end by itself.
    int status() {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        int status = 0;
        while (!was_waited_ && std::chrono::steady_clock::now() < end) {
            was_waited_ = ::waitpid(pid_, &status, WNOHANG) == pid_;
            if (!was_waited_) ::usleep(5'000);
        }
        return was_waited_ && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

  private:
    int master_ = -1;
    pid_t pid_ = -1;
    bool was_waited_ = false;
    std::string heard_;
};

class TerminalTest : public ::testing::Test {
  protected:
    void SetUp() override {
        state_ = fs::temp_directory_path() / ("kadr-state-" + std::to_string(::getpid()));
        fs::create_directories(state_);
    }
    void TearDown() override { fs::remove_all(state_); }

    fs::path state_;
};

TEST_F(TerminalTest, LinesHistoryAndTheEnd) {
    {
        Terminal terminal(state_);
        terminal.expect("kadr> ");
        terminal.type("G0 X12\n");
        terminal.expect("\nG0 X12");
        terminal.expect("kadr> ");
        terminal.type("\x04");  // Ctrl-D
        EXPECT_EQ(terminal.status(), 0);
    }
    EXPECT_NE(kadr::read_file((state_ / "kadr" / "history").string()).value_or("").find("G0"),
              std::string::npos);
    Terminal terminal(state_);
    terminal.expect("kadr> ");
    terminal.type("\x1b[A\n");  // the line of the conversation before
    terminal.expect("\nG0 X12");
}

TEST_F(TerminalTest, CompletionAndSeveralLines) {
    Terminal terminal(state_);
    terminal.expect("kadr> ");
    terminal.type(":dial\t\n");
    terminal.expect("\niso");
    terminal.expect("kadr> ");
    terminal.type("for (int i = 5; i < 7; i++) {\n");
    terminal.expect("... ");
    terminal.type("G0 X=i;\n");
    terminal.expect("... ");
    terminal.type("}\n");
    terminal.expect("X5\r\nX6\r\n");
}

TEST_F(TerminalTest, AHeadWaitsAndWhatWasTypedBecomesAProgram) {
    const std::string file = (state_ / "typed.kadr").string();
    {
        Terminal terminal(state_);
        terminal.expect("kadr> ");
        terminal.type("for (int i : 7..8)\n");
        terminal.expect("... ");
        terminal.type("G0 X=i;\n");
        terminal.expect("X7\r\nX8\r\n");
        terminal.expect("kadr> ");
        terminal.type("G0 Y=nothing\n");  // a mistake ends nothing, and is not kept
        terminal.expect("error[K2001]");
        terminal.expect("kadr> ");
        terminal.type("import cycles.drilling\n");
        terminal.expect("kadr> ");
        terminal.type("bore_st\t");
        terminal.expect("op");
        terminal.type("\x03");
        terminal.expect("kadr> ");
        terminal.type(":save " + file + "\n");
        terminal.expect("typed.kadr");
        terminal.expect("kadr> ");
        terminal.type("\x04");
        EXPECT_EQ(terminal.status(), 0);
    }
    const auto run = run_process({KADR_BINARY, "expand", file, "-d", "iso"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("X7\nX8\n"), std::string::npos) << run.out;
}

TEST_F(TerminalTest, StepsFromBlockToBlock) {
    Terminal terminal(state_);
    terminal.expect("kadr> ");
    terminal.type(":step\n");
    terminal.expect("block by block");
    terminal.type("{ G0 X3 Y4; G0 X5; }\n");
    // Each line with what it does; Enter for the next one, q ends it.
    terminal.expect("G17");
    terminal.expect("q end");
    terminal.type("\n");
    for (const char* done : {"rapid to X3.000 Y4.000", "rapid to X5.000"}) {
        terminal.expect(done);
        terminal.expect("q end");
        terminal.type("\n");
    }
    terminal.expect("kadr> ");
    terminal.type("{ G0 X6; G0 X7; }\n");
    terminal.expect("rapid to X6.000");
    terminal.expect("q end");
    terminal.type("q\n");
    const std::string rest = terminal.expect("kadr> ");
    EXPECT_EQ(rest.find("rapid to X7"), std::string::npos) << rest;
}

TEST_F(TerminalTest, CtrlCEndsALineAndALoop) {
    Terminal terminal(state_);
    terminal.expect("kadr> ");
    terminal.type("cycle half(\n");
    terminal.expect("... ");
    terminal.type("\x03");
    terminal.expect("kadr> ");
    // A line that is half typed is dropped, and so is the block that it stands in.
    terminal.type("100+");
    terminal.expect("100+");
    terminal.type("\x03");
    terminal.expect("kadr> ");
    terminal.type("5*5\n");
    terminal.expect("\n25");
    terminal.expect("kadr> ");
    terminal.type("for (int i = 0; i < 2; i++) {\n");
    terminal.expect("... ");
    terminal.type("G0 X=i");
    terminal.expect("G0 X=i");
    terminal.type("\x03");
    terminal.expect("kadr> ");
    terminal.type("3*9\n");
    terminal.expect("\n27");
    terminal.expect("kadr> ");
    terminal.type("int i = 0; while (true) { i++; }\n");
    ::usleep(300'000);
    terminal.type("\x03");
    terminal.expect("error[K");
    terminal.expect("kadr> ");
    terminal.type("6*7\n");
    terminal.expect("\n42");
}

TEST_F(TerminalTest, UndoAndPlot) {
    Terminal terminal(state_);
    terminal.expect("kadr> ");
    terminal.type("G1 X10 Y10 F500\n");
    terminal.expect("kadr> ");
    terminal.type("G0 X20\n");
    terminal.expect("kadr> ");
    terminal.type(":undo\n");
    terminal.expect("taken back: G0 X20;");
    terminal.type(":plot\n");
    terminal.expect("mm, Y 0");
}

TEST(Pipe, AScriptIsAnsweredAndAnErrorIsItsStatus) {
    const auto good = run_process({KADR_BINARY, "repl", "-d", "fanuc"}, "2*3\nG0 X5\n");
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_TRUE(good.out.starts_with("6\n")) << good.out;
    EXPECT_NE(good.out.find("X5."), std::string::npos) << good.out;
    EXPECT_EQ(good.out.find("kadr>"), std::string::npos) << good.out;
    const auto bad = run_process({KADR_BINARY, "repl"}, "G0 X=what\n1\n");
    EXPECT_EQ(bad.status, 1);
    EXPECT_NE(bad.out.find("\n1\n"), std::string::npos) << bad.out;
    EXPECT_EQ(run_process({KADR_BINARY, "repl"}, "for (;;) {\n").status, 1);
}

}  // namespace

}  // namespace terminal_test
