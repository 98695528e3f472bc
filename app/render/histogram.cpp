// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/histogram.h"

#include <algorithm>
#include <cmath>

namespace toile {

namespace {

void count(Histogram& histogram, const OverlayScale& scale, double value, double area) {
    if (scale.isBeyond(value)) {
        (value < scale.low ? histogram.below : histogram.above) += area;
        return;
    }
    const int bin = static_cast<int>(std::floor(scale.position(value) * kHistogramBins));
    histogram.bins[static_cast<std::size_t>(std::clamp(bin, 0, kHistogramBins - 1))] += area;
}

}  // namespace

double Histogram::tallest() const {
    return *std::ranges::max_element(bins);
}

Histogram overlayHistogram(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                           const OverlayScale& scale) {
    Histogram histogram;
    double total = 0;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const TriangleRun& run = scene.pieces[i].patternRun;
        const Eigen::Vector2d grain = grainVector(places, static_cast<int>(i));
        const std::size_t first = run.first, end = first + run.count;
        for (std::size_t face = first; face < end; ++face) {
            const double area = static_cast<double>(scene.faces[face].flatArea);
            total += area;
            const OverlaySample sample = sampleOf(scene.faces[face]);
            count(histogram, scale, overlayValue(overlay, sample, grain, scale), area);
        }
    }
    if (total > 0) {
        histogram.below /= total;
        histogram.above /= total;
        for (double& bin : histogram.bins) {
            bin /= total;
        }
    }
    return histogram;
}

}  // namespace toile
