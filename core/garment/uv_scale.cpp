// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/garment/corner_uv.h"
#include "core/garment/split.h"

namespace toile {

std::optional<UvScale> measureUvScale(const PolygonSoup& soup, const Triangulation& triangles) {
    if (soup.cornerUvs.empty()) {
        return std::nullopt;
    }
    std::vector<double> ratios;
    int uncovered = 0;
    CornerUvs uvs(soup);
    for (int t = 0; t < triangles.F.rows(); ++t) {
        const int face = triangles.sourceFace[t];
        for (int k = 0; k < 3; ++k) {
            const int v = triangles.F(t, k);
            const int w = triangles.F(t, (k + 1) % 3);
            const int a = uvs.at(face, v);
            const int b = uvs.at(face, w);
            const double flat = a < 0 || b < 0 ? 0.0 : (soup.uvs[a] - soup.uvs[b]).norm();
            const double ratio = (soup.positions[v] - soup.positions[w]).norm() / flat;
            if (std::isfinite(ratio) && ratio > 0) {
                ratios.push_back(ratio);
            } else {
                ++uncovered;  // no uv, or an edge without length
            }
        }
    }
    if (ratios.empty()) {
        return std::nullopt;
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    const double median = *middle;
    const auto close = std::count_if(ratios.begin(), ratios.end(), [median](double ratio) {
        return std::abs(ratio / median - 1) <= kIsometricBand;
    });
    return UvScale{median,
                   static_cast<double>(close) / (static_cast<double>(ratios.size()) + uncovered)};
}

}  // namespace toile
