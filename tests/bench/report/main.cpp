// SPDX-License-Identifier: GPL-3.0-or-later
// Writes performance.md and its plot from one run of the benchmarks:
//     toile_bench_report RUN.json FOLDER
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "core/base/file.h"
#include "tests/bench/report/growth_plot.h"
#include "tests/bench/report/performance_page.h"

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
    if (const auto written = toile::writeFile(path, text); !written) {
        throw std::runtime_error(sentence(written.error()));
    }
    std::printf("wrote %s\n", path.string().c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s RUN.json FOLDER\n", argv[0]);
        return 2;
    }
    try {
        const auto text = toile::readFile(argv[1]);
        if (!text) {
            throw std::runtime_error(sentence(text.error()));
        }
        const auto run = toile::bench::readRun(*text);
        const std::filesystem::path docs = argv[2];
        write(docs / "performance.md", toile::bench::performancePage(run));
        write(docs / "images" / "performance-growth.svg", toile::bench::growthPlot(run));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
