// point_to_point.cpp — rapid motions from rest to rest against the least time there is: on their
// line, and for axes that go each by itself.
//
//   bench_point_to_point     prints the table as Markdown, with the CPU time of a plan
#include "bench/point_to_point.h"

#include <cstdio>
#include <vector>

#include "bench/cpu_time.h"

namespace {

using namespace kadr;
using bench::cpu_time;

/// One command, then the end.
class OneRapid final : public Stream<path::Command> {
  public:
    explicit OneRapid(const bench::Transfer& transfer) {
        command_.become(path::Op::Rapid);
        command_.motion().moved = kLinearXYZ;
        std::copy(transfer.delta.begin(), transfer.delta.end(), command_.motion().to.begin());
    }
    std::size_t pull(std::span<path::Command> out) override {
        if (is_over_ || out.empty()) return 0;
        is_over_ = true;
        out[0] = command_;
        return 1;
    }

  private:
    path::Command command_;
    bool is_over_ = false;
};

double planned_time(const bench::Transfer& transfer, const machine::Machine& machine) {
    DiagnosticList said;
    OneRapid rapid(transfer);
    motion::Planner planner(rapid, machine, {}, said);
    std::vector<motion::Segment> batch(8);
    while (planner.pull(batch) > 0) continue;
    return planner.totals().time;
}

struct Row {
    double mean_line = 0;
    double worst_line = 0;
    double mean_free = 0;
    double worst_free = 0;
    double plan = 0;  // s of CPU time each
};

Row row_of(std::size_t axes, int count) {
    bench::Transfers transfers(static_cast<std::uint32_t>(axes));
    Row row;
    for (int i = 0; i < count; ++i) {
        const bench::Transfer transfer = transfers.next(axes);
        const machine::Machine machine = bench::machine_for(transfer);
        const double before = cpu_time();
        const double time = planned_time(transfer, machine);
        row.plan += cpu_time() - before;
        const double line = time / bench::least_time_straight(transfer);
        const double free = time / bench::least_time_free(transfer);
        row.mean_line += line;
        row.mean_free += free;
        row.worst_line = std::max(row.worst_line, line);
        row.worst_free = std::max(row.worst_free, free);
    }
    row.mean_line /= count;
    row.mean_free /= count;
    row.plan /= count;
    return row;
}

}  // namespace

int main() {
    constexpr int kCount = 20'000;
    std::puts(
        "| axes | against the line's least time, mean | worst | against free axes, mean | worst | "
        "a plan |\n| --- | --- | --- | --- | --- | --- |");
    for (const std::size_t axes : {1u, 2u, 3u}) {
        const Row row = row_of(axes, kCount);
        std::printf("| %zu | %.9f | %.9f | %.3f | %.3f | %.1f µs |\n", axes, row.mean_line,
                    row.worst_line, row.mean_free, row.worst_free, row.plan * 1e6);
    }
}
