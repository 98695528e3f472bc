// SPDX-License-Identifier: GPL-3.0-or-later
#include "seam_line.h"

#include <algorithm>

namespace toile::samples {

SeamLine sampleSeam(const SpaceCurve& curve, double spacing) {
    constexpr int kFine = 2000;  // chords of the length table: far finer than any edge
    std::vector<double> lengths(kFine + 1, 0.0);
    Vec3 previous = curve(0.0);
    for (int k = 1; k <= kFine; ++k) {
        const Vec3 next = curve(static_cast<double>(k) / kFine);
        lengths[static_cast<std::size_t>(k)] =
            lengths[static_cast<std::size_t>(k - 1)] + length(next - previous);
        previous = next;
    }
    const double total = lengths.back();
    const int steps = std::max(1, static_cast<int>(std::lround(total / spacing)));

    SeamLine seam;
    std::size_t row = 0;
    for (int k = 0; k <= steps; ++k) {
        double t = static_cast<double>(k) / steps;
        if (k > 0 && k < steps) {
            const double along = total * t;
            while (lengths[row + 1] < along) {
                ++row;
            }
            const double part = (along - lengths[row]) / (lengths[row + 1] - lengths[row]);
            t = (static_cast<double>(row) + part) / kFine;
        }
        seam.parameters.push_back(t);
        seam.points.push_back(curve(t));
    }
    return seam;
}

std::vector<Vec3> joinSeams(const std::vector<SeamRun>& runs) {
    std::vector<Vec3> joined;
    for (const SeamRun& run : runs) {
        std::vector<Vec3> points = run.seam->points;
        if (run.reversed) {
            std::reverse(points.begin(), points.end());
        }
        const std::ptrdiff_t skip = joined.empty() ? 0 : 1;
        joined.insert(joined.end(), points.begin() + skip, points.end());
    }
    return joined;
}

}  // namespace toile::samples
