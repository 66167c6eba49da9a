#include "tests/common/process.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// A file of this process that vanishes with it; pipes could fill up and block, files do not.
class ScratchFile {
  public:
    explicit ScratchFile(const std::string& content = "") {
        std::array<char, 32> name{"/tmp/kadr-test-XXXXXX"};
        descriptor_ = ::mkstemp(name.data());
        path_ = name.data();
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~ScratchFile() {
        ::close(descriptor_);
        ::unlink(path_.c_str());
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    const std::string& path() const { return path_; }
    std::string content() const {
        std::ifstream in(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

  private:
    int descriptor_ = -1;
    std::string path_;
};

void redirect(const std::string& path, int flags, int descriptor) {
    const int file = ::open(path.c_str(), flags);
    if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
    ::close(file);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input,
                          int limit_seconds) {
    const ScratchFile in(input);
    const ScratchFile out;
    const ScratchFile err;
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    if (child == 0) {
        redirect(in.path(), O_RDONLY, 0);
        redirect(out.path(), O_WRONLY, 1);
        redirect(err.path(), O_WRONLY, 2);
        ::alarm(static_cast<unsigned>(limit_seconds));
        std::vector<char*> argv;
        argv.reserve(arguments.size() + 1);
        for (const std::string& argument : arguments)
            argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    ProcessResult result;
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.max_rss_kib = usage.ru_maxrss;
    result.out = out.content();
    result.err = err.content();
    return result;
}
