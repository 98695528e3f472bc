// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/solve_tables.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/bench/report/bars.h"
#include "tests/bench/report/cells.h"
#include "tests/bench/report/figures.h"

namespace toile::bench {
namespace {

/// Every generated piece and every garment from a file, as the benchmarks' names have them.
std::vector<std::string> allPieces() {
    std::vector<std::string> pieces;
    for (const std::string surface : kSurfaces) {
        for (const std::string size : kSizes) {
            pieces.push_back(surface + "/" + size);
        }
    }
    pieces.insert(pieces.end(), {"dress", "face", "mannequin-devil"});
    return pieces;
}

}  // namespace

MarkdownTable floorTable(const Measurements& run) {
    std::vector<std::string> candidates;  // in order of name
    for (const auto& [name, measurement] : run.all()) {
        if (name.starts_with("floor/")) {
            const std::string candidate = name.substr(name.rfind('/') + 1);
            if (std::find(candidates.begin(), candidates.end(), candidate) == candidates.end()) {
                candidates.push_back(candidate);
            }
        }
    }
    std::vector<std::string> heads{"piece"};
    heads.insert(heads.end(), candidates.begin(), candidates.end());
    heads.push_back("the floor");
    MarkdownTable table(heads);
    for (const std::string& piece : allPieces()) {
        const auto floor = run.floorOf(piece);
        if (!floor) {
            continue;
        }
        std::vector<std::string> row{piece};
        for (const std::string& candidate : candidates) {
            row.push_back(orDash(run.lowest("floor/" + piece + "/" + candidate), milliseconds));
        }
        row.push_back(floor->candidate);
        table.add(row);
    }
    return table;
}

MarkdownTable timeTable(const Measurements& run) {
    MarkdownTable table({"piece", "triangles", "floor", "`curvature`", "x floor", "`wang2005`",
                         "x floor", "`isometric`", "x `curvature`", "half-edges"});
    for (const std::string& piece : allPieces()) {
        const Measurement* curvature = run.find("curvature/" + piece);
        if (curvature == nullptr) {
            continue;
        }
        const auto floor = run.floorOf(piece);
        const auto timesFloor = [&](const std::string& method) {
            const auto time = run.lowest(method + "/" + piece);
            return floor && time ? significant(*time / floor->measurement->lowest()) : "-";
        };
        table.add({piece,
                   orDash(run.counter("curvature/" + piece, "triangles"),
                          [](double n) { return std::to_string(static_cast<long long>(n)); }),
                   timeCell(floor ? floor->measurement : nullptr), timeCell(curvature),
                   timesFloor("curvature"), timeCell(run.find("wang2005/" + piece)),
                   timesFloor("wang2005"), timeCell(run.find("isometric/" + piece)),
                   orDash(run.ratio("isometric/" + piece, "curvature/" + piece), significant),
                   timeCell(run.find("buildPiece/" + piece))});
    }
    return table;
}

MarkdownTable peerTable(const Measurements& run) {
    MarkdownTable table({"piece", "CGAL LSCM ms", "`curvature` ms", "x `curvature`", "CGAL ARAP ms",
                         "`isometric` ms", "x `isometric`", "energy of LSCM", "of ARAP",
                         "of `isometric`", "outline strayed, LSCM %", "ARAP %"});
    const auto percent = [](double part) -> std::string { return significant(100 * part); };
    for (const std::string& piece : allPieces()) {
        const std::string lscm = "cgalLscm/" + piece, arap = "cgalArap/" + piece;
        if (run.find(lscm) == nullptr && run.find(arap) == nullptr) {
            continue;
        }
        const std::string curvature = "curvature/" + piece;
        const std::string isometric = "isometric/" + piece;
        table.add({piece, wallCell(run.find(lscm)), wallCell(run.find(curvature)),
                   orDash(run.wallRatio(lscm, curvature), significant), wallCell(run.find(arap)),
                   wallCell(run.find(isometric)),
                   orDash(run.wallRatio(arap, isometric), significant),
                   orDash(run.counter(lscm, "energy"), significant),
                   orDash(run.counter(arap, "energy"), significant),
                   orDash(run.counter("isometric/" + piece, "energy"), significant),
                   orDash(run.counter(lscm, "strayed"), percent),
                   orDash(run.counter(arap, "strayed"), percent)});
    }
    return table;
}

}  // namespace toile::bench
