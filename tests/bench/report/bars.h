// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// The pieces that speed is measured on: two surfaces, generated in four sizes.
inline constexpr const char* kSurfaces[] = {"panel", "head"};
inline constexpr const char* kSizes[] = {"3000", "45000", "500000", "1000000"};

/// The stages that are measured over the length of the outline, in the order of the pipeline, and
/// its vertices.
inline constexpr const char* kOutlineStages[] = {
    "load",    "seams",     "circle",    "newton", "slcp",      "bending", "barrier",
    "lengths", "curvature", "isometric", "rims",   "crossings", "measure", "sheet",
    "check",   "svg",       "dxf",       "obj",    "json"};
inline constexpr const char* kOutlineSizes[] = {"2000", "20000", "200000"};

/// Something that is to be reached, and what was measured.
struct Bar {
    std::string what;  ///< "curvature / floor, panel/45000"
    double measured;
    double bound;
    bool atLeast = false;  ///< the bound is a lower one
    std::string unit{};    ///< empty for a ratio

    bool kept() const { return atLeast ? measured >= bound : measured <= bound; }
};

/// Every bar for which this run has the figures, in the order of the page.
std::vector<Bar> barsOf(const Measurements& run);

/// p of cost ~ n^p for one benchmark on one surface ("curvature", "panel"), between 45 000 and a
/// million triangles; the floor's for "floor".
std::optional<double> growthExponent(const Measurements& run, const std::string& what,
                                     const std::string& surface);

/// How many times the time per vertex of one stage grows from the last but one of these sizes to
/// the largest: about 1 where the stage is linear, 10 where it is quadratic.
std::optional<double> timePerVertexGrowth(const Measurements& run, const std::string& stage);

/// The bar in one line, for a terminal: "curvature / floor, panel/45000: 1.71, at most 1.25: NOT
/// kept".
std::string line(const Bar& bar);

}  // namespace toile::bench
