// process.h — runs the kadr binary as its user does: arguments, standard input, exit status.
#pragma once

#include <string>
#include <vector>

struct ProcessResult {
    int status = -1;  // exit status; 128 + signal if it was killed
    std::string out;
    std::string err;
    double seconds = 0;    // wall time
    long max_rss_kib = 0;  // of the child
};

/// Runs a program to its end. `input` becomes its standard input. Killed after `limit_seconds`.
ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input = "",
                          int limit_seconds = 60);
