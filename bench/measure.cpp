// measure.cpp — runs a program and tells what it cost: CPU time, elapsed time, greatest memory.
//
//   measure COMMAND [ARGUMENT]...      prints `cpu_s wall_s peak_kib status` to file descriptor 3
//
// A program of its own because the kernel counts the memory of the process that starts another to
// the other's peak: a Python that starts `kadr` would be what is measured.
#include <chrono>
#include <cstdio>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const pid_t child = vfork();
    if (child == 0) {
        execvp(argv[1], argv + 1);
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child) return 2;
    const std::chrono::duration<double> wall = Clock::now() - begin;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    const double cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    dprintf(3, "%.6f %.6f %ld %d\n", cpu, wall.count(), usage.ru_maxrss, code);
    return 0;
}
