// laser.cpp — the 14 files of the paper's Table 2, as point sets of our own: both algorithms, their
// times beside the paper's.
//
//   bench_laser          prints the table as Markdown, with the CPU time of the synchronised plan
#include <cstdio>
#include <string>

#include "bench/cpu_time.h"
#include "bench/laser_points.h"

int main() {
    using namespace kadr::bench;
    std::puts(
        "| file | points | stop, paper | stop, ours | ratio | synchronised, paper | synchronised, "
        "ours | ratio | saved, paper | saved, ours |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    const double before = cpu_time();
    double points = 0;
    LaserTimes all;
    double paper_old = 0;
    double paper_new = 0;
    const auto row = [](const char* name, double count, double old_paper, double new_paper,
                        const LaserTimes& times) {
        std::printf(
            "| %s | %.0f | %.0f s | %.0f s | %.3f | %.0f s | %.0f s | %.3f | %.0f %% | %.0f %% |\n",
            name, count, old_paper, times.stopping, times.stopping / old_paper, new_paper,
            times.synchronised, times.synchronised / new_paper, 100 * (1 - new_paper / old_paper),
            100 * (1 - times.synchronised / times.stopping));
    };
    for (const LaserFile& file : kTable2) {
        const LaserTimes times = times_of(file);
        row(std::to_string(file.number).c_str(), file.points, file.paper_old, file.paper_new,
            times);
        points += file.points;
        paper_old += file.paper_old;
        paper_new += file.paper_new;
        all.stopping += times.stopping;
        all.synchronised += times.synchronised;
    }
    row("all", points, paper_old, paper_new, all);
    std::printf("\n%.0f points planned both ways in %.1f s of CPU time, %.0f µs a point\n", points,
                cpu_time() - before, (cpu_time() - before) / points * 1e6);
}
