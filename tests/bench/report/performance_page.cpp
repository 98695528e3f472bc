// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/performance_page.h"

#include <string>
#include <vector>

#include "tests/bench/report/bars.h"
#include "tests/bench/report/cells.h"
#include "tests/bench/report/figures.h"
#include "tests/bench/report/markdown.h"
#include "tests/bench/report/pipeline_tables.h"
#include "tests/bench/report/solve_tables.h"

namespace toile::bench {
namespace {

constexpr const char* kHead = R"(# Performance

This page compares the time of flattening with its lower bound, one sparse Cholesky factorisation: the
*floor*. `tests/bench/report` writes the page from one run of the benchmarks
([development](development.md#benchmarks)):

```sh
tests/bench/run.sh
```

Times are processor time, the lowest of several repetitions taken in turns; next to CGAL, and where
files, whole programs or numbers of threads are measured, wall-clock time. The middle one (median)
is in brackets: far apart, the machine was busy. Ratios compare the lowest times. A piece is
flattened on one core.

The two surfaces are generated (`tests/bench/bench_meshes.h`): the *panel* is the front of a shirt
in soft folds, the *head* a closed-up form with horns that is open at the neck only. `dress` is a
garment of several pieces, flattened one after the other; `face` and `mannequin-devil` are disks.

)";

constexpr const char* kFloor = R"(## The floor

Assembling the interior cotangent Laplacian, ordering it, factorising it symbolically and
numerically, and three back-substitutions (`wang2005` needs two), by CHOLMOD called straight, with
one thread. The floor of a piece is the fastest candidate; the last column is its name. `amd` and
`metis` are CHOLMOD's orderings; *relaxed* supernodes are merged more freely than by default.
Milliseconds.

)";

constexpr const char* kTimes = R"(## From a piece in memory to flat positions

Milliseconds, and how many times the floor. *Half-edges*: from arrays to a checked piece with its
half-edges, which the flattening does without.

)";

constexpr const char* kPeers = R"(## Next to CGAL

CGAL's least squares conformal map (its default solver, Eigen's `SimplicialLDLT`) and its
as-rigid-as-possible map (default solver, Eigen's `SparseLU`; lambda 1000, its default; 50 iterations,
all of them done, as its tolerance is set to 0), on a `Surface_mesh` over
`Simple_cartesian<double>`. Wall-clock time, what one waits for: CGAL works on one core. The energy
is the symmetric Dirichlet energy / 4 (1 where isometric), with the result scaled so that its outline
is as long as in 3D; a dash says that triangles are flipped or collapsed, so that it is infinite.
Both outlines are free and stray from their lengths in 3D, by so much in the root mean square; those
of `isometric` are exact, which costs a little energy on a nearly flat piece.

)";

constexpr const char* kEndToEnd = R"(## From file to files

In one process: an OBJ file is read, divided into pieces, repaired and checked, its seams are found,
it is flattened and measured, and SVG, DXF, OBJ and the JSON report are written. The whole in
seconds of wall-clock time; the stages in seconds of processor time, and their shares.

)";

constexpr const char* kStages = R"(## Where a million triangles spend their time

The same way by `curvature`, with the solve taken apart; seconds of processor time. *Rest* is what
`flatten` does beside the stages that are measured alone: angles, flux, setting the piece upright,
looking for crossings.

)";

std::string section(const std::string& head, const MarkdownTable& table) {
    return table.empty() ? "" : head + table.text();
}

std::string machineTable(const Measurements& run) {
    MarkdownTable table({"", "measured with"});
    for (const std::string key : {"date", "processor", "cores", "memory", "compiler", "CHOLMOD",
                                  "SuiteSparse", "BLAS", "Eigen", "OpenMesh", "CGAL", "Toile"}) {
        const auto found = run.machine.find(key);
        if (found != run.machine.end()) {
            table.add({key, found->second});
        }
    }
    return table.text();
}

std::string barTable(const Measurements& run) {
    MarkdownTable table({"To reach", "bound", "measured", ""});
    int kept = 0;
    const std::vector<Bar> bars = barsOf(run);
    for (const Bar& bar : bars) {
        const std::string unit = bar.unit.empty() ? "" : " " + bar.unit;
        table.add({bar.what,
                   (bar.atLeast ? "at least " : "at most ") + significant(bar.bound) + unit,
                   significant(bar.measured) + unit, bar.kept() ? "kept" : "**not kept**"});
        kept += bar.kept() ? 1 : 0;
    }
    return section("## To reach\n\n" + std::to_string(kept) + " of " + std::to_string(bars.size()) +
                       " are kept.\n\n",
                   table);
}

std::string growthSection(const Measurements& run) {
    MarkdownTable table({"exponent p of n^p, 45 000 to 1 000 000", "panel", "head"});
    for (const std::string what : {"floor", "curvature", "wang2005", "isometric"}) {
        const auto panel = growthExponent(run, what, "panel");
        const auto head = growthExponent(run, what, "head");
        if (panel || head) {
            table.add({what, orDash(panel, significant), orDash(head, significant)});
        }
    }
    return "## Growth\n\n![Seconds over triangles, both axes "
           "logarithmic](images/performance-growth.svg)\n\n" +
           table.text();
}

/// Benchmarks whose names begin so, with their times and one counter.
std::string plainTable(const Measurements& run, const std::string& head,
                       const std::vector<std::string>& prefixes, const std::string& counter = {},
                       const std::string& unit = {}) {
    std::vector<std::string> heads{"", "ms"};
    if (!counter.empty()) {
        heads.push_back(unit);
    }
    MarkdownTable table(heads);
    for (const std::string& prefix : prefixes) {
        for (const auto& [name, measurement] : run.all()) {
            if (name.starts_with(prefix)) {
                std::vector<std::string> row{name, timeCell(&measurement)};
                if (!counter.empty()) {
                    row.push_back(orDash(run.counter(name, counter), significant));
                }
                table.add(row);
            }
        }
    }
    return section(head, table);
}

/// Time per vertex of each stage.
std::string outlineTable(const Measurements& run) {
    std::vector<std::string> heads{"stage, ns per vertex"};
    for (const std::string size : kOutlineSizes) {
        heads.push_back(size);
    }
    heads.push_back("growth");
    MarkdownTable table(heads);
    for (const std::string stage : kOutlineStages) {
        std::vector<std::string> row{stage};
        for (const std::string size : kOutlineSizes) {
            const auto time = run.lowest("outline/" + stage + "/" + size);
            row.push_back(time ? significant(1e9 * *time / std::stod(size)) : "-");
        }
        const auto growth = timePerVertexGrowth(run, stage);
        row.push_back(orDash(growth, significant));
        if (growth) {
            table.add(row);
        }
    }
    return section(
        "## Over the length of the outline\n\nTwo strips sewn to each other along a side, of so "
        "many vertices each, all of them on the outline (`rims`: a ring, half of them on the rim "
        "of its hole). Nanoseconds of processor time per vertex; the last column is the largest "
        "over the one before: about 1 where a stage is linear, 10 where it is quadratic.\n\n",
        table);
}

std::string resolveTable(const Measurements& run) {
    MarkdownTable table({"edit", "again ms", "cold ms", "again / cold"});
    const std::string prefix = "resolve";
    for (const auto& [name, measurement] : run.all()) {
        if (name.starts_with(prefix)) {
            const std::string cold = "cold" + name.substr(prefix.size());
            table.add({name.substr(prefix.size()), timeCell(&measurement), timeCell(run.find(cold)),
                       orDash(run.ratio(name, cold), significant)});
        }
    }
    return section(
        "## After a small edit\n\nFlattening again with what the last flattening left, next to "
        "flattening from nothing.\n\n",
        table);
}

}  // namespace

std::string performancePage(const Measurements& run) {
    return kHead + machineTable(run) + barTable(run) + section(kTimes, timeTable(run)) +
           growthSection(run) + section(kFloor, floorTable(run)) + section(kPeers, peerTable(run)) +
           section(kStages, stageTable(run)) + section(kEndToEnd, endToEndTable(run)) +
           resolveTable(run) + outlineTable(run) +
           plainTable(run,
                      "## Reading and writing\n\nReading a garment of 218 000 triangles with UV "
                      "map,\n15 MB of OBJ, in three ways; writing a million triangles.\n\n",
                      {"plainScan", "toileReader", "openMeshReader", "write/"}) +
           plainTable(run,
                      "## Preparing a scan\n\nMaking a sheet of the scan of a dress, 58 771 "
                      "triangles, which stay or are made\nanew with edges of so many "
                      "millimetres; wall-clock time.\n\n",
                      {"prepare/"}, "triangles", "triangles after") +
           plainTable(run,
                      "## Proposing cuts\n\nTailors' cuts for a shirt of one skin, and what each "
                      "is worth; wall-clock time.\n\n",
                      {"tailor/"}, "triangles", "triangles") +
           plainTable(run,
                      "## A garment's pieces side by side\n\n`dress.obj`, wall-clock time; both "
                      "write the same bytes.\n\n",
                      {"garment/"}) +
           plainTable(
               run,
               "## Memory\n\nThe most that `toile flatten` holds at a time, from OBJ to SVG, "
               "DXF, OBJ and JSON, and the wall-clock time of the whole program.\n\n",
               {"memory/"}, "peakMiB", "peak MiB") +
           plainTable(run,
                      "## Traps\n\nThe floor with AMD and supernodes once more, with CHOLMOD and "
                      "OpenBLAS left to open the threads they like; wall-clock time.\n\n",
                      {"trap/"});
}

}  // namespace toile::bench
