// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/pipeline_tables.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/report/figures.h"

namespace toile::bench {
namespace {

/// Seconds and shares of the named counters of one benchmark.
std::vector<std::string> sharesOf(const Measurement& measurement,
                                  const std::vector<std::string>& stages) {
    double whole = 0;
    for (const std::string& stage : stages) {
        whole += measurement.counters.contains(stage) ? measurement.counters.at(stage) : 0;
    }
    std::vector<std::string> cells;
    for (const std::string& stage : stages) {
        const auto found = measurement.counters.find(stage);
        cells.push_back(found == measurement.counters.end()
                            ? "-"
                            : significant(found->second) + " (" + percent(found->second / whole) +
                                  ")");
    }
    return cells;
}

/// With what of the solve its own stages leave over.
Measurement withRest(Measurement measurement) {
    std::map<std::string, double>& counters = measurement.counters;
    double rest = counters["solve"];
    for (const char* stage : {"assemble", "order", "factorise", "substitute", "boundary"}) {
        rest -= counters[stage];
    }
    counters["rest"] = std::max(0.0, rest);
    return measurement;
}

}  // namespace

MarkdownTable endToEndTable(const Measurements& run) {
    const std::vector<std::string> stages{"read", "pieces", "seams", "solve", "measure", "write"};
    std::vector<std::string> heads{"garment", "whole"};
    heads.insert(heads.end(), stages.begin(), stages.end());
    MarkdownTable table(heads);
    const std::string prefix = "endToEnd/";
    for (const auto& [name, measurement] : run.all()) {
        if (name.starts_with(prefix)) {
            std::vector<std::string> row{name.substr(prefix.size()),
                                         significant(measurement.lowest())};
            const auto cells = sharesOf(measurement, stages);
            row.insert(row.end(), cells.begin(), cells.end());
            table.add(row);
        }
    }
    return table;
}

MarkdownTable stageTable(const Measurements& run) {
    const std::vector<std::pair<std::string, std::string>> stages{
        {"read", "reading the file"},
        {"pieces", "pieces: dividing, repairing, checking"},
        {"seams", "seams"},
        {"assemble", "assembling the Laplacian"},
        {"order", "ordering and symbolic factorisation"},
        {"factorise", "numeric factorisation"},
        {"substitute", "three back-substitutions"},
        {"boundary", "the boundary problem"},
        {"rest", "rest of `curvature`"},
        {"measure", "measuring"},
        {"write", "writing SVG, DXF, OBJ, JSON"}};
    MarkdownTable table({"stage", "panel", "head"});
    std::vector<std::string> names;
    for (const auto& [name, words] : stages) {
        names.push_back(name);
    }
    const Measurement* panel = run.find("endToEnd/panel/1000000/curvature");
    const Measurement* head = run.find("endToEnd/head/1000000/curvature");
    const auto cellsOf = [&](const Measurement* measurement) {
        return measurement != nullptr ? sharesOf(withRest(*measurement), names)
                                      : std::vector<std::string>(names.size(), "-");
    };
    if (panel != nullptr || head != nullptr) {
        const auto ofPanel = cellsOf(panel), ofHead = cellsOf(head);
        for (std::size_t k = 0; k < stages.size(); ++k) {
            table.add({stages[k].second, ofPanel[k], ofHead[k]});
        }
    }
    return table;
}

}  // namespace toile::bench
