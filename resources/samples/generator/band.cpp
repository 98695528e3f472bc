// SPDX-License-Identifier: GPL-3.0-or-later
#include "band.h"

#include <utility>

namespace toile::samples {

Piece makeBand(std::string name, const Band& band) {
    using Direction = Outline::Direction;
    const std::vector<Vec3> lowerPoints = joinSeams(band.seams);
    const PointCurve lower(lowerPoints, PointCurve::Ends::Open);
    const double span = lower.length();
    const double width = band.width;
    // Layout: x along the band from the centre front, y up.
    const Surface surface = [&](Vec2 p) {
        return lower(p.x / span) + (p.y / width) * band.rise(p.x / span);
    };

    const auto alongFlat = [&](Vec2 from, Vec2 to) {
        const FlatCurve flat = line(from, to);
        const SpaceCurve space = [=](double t) { return surface(flat(t)); };
        return std::pair{sampleSeam(space, band.edge), flat};
    };
    const auto [back, backFlat] = alongFlat({span, 0.0}, {span, width});
    const auto [upper, upperFlat] = alongFlat({span, width}, {0.0, width});
    const auto [front, frontFlat] = alongFlat({0.0, 0.0}, {0.0, width});

    const auto foldAt = [&](BandFold side) {
        return band.fold == side ? Outline::Fold::Yes : Outline::Fold::No;
    };
    Outline outline;
    const double steps = static_cast<double>(lowerPoints.size() - 1);
    double start = 0.0;
    for (const SeamRun& run : band.seams) {
        const double end = start + span * static_cast<double>(run.seam->points.size() - 1) / steps;
        const Vec2 from{run.reversed ? end : start, 0.0};
        const Vec2 to{run.reversed ? start : end, 0.0};
        outline.addByLength(*run.seam, line(from, to),
                            run.reversed ? Direction::Reversed : Direction::Forward);
        start = end;
    }
    outline.add(back, backFlat, Direction::Forward, foldAt(BandFold::Back));
    outline.add(upper, upperFlat);
    outline.add(front, frontFlat, Direction::Reversed, foldAt(BandFold::Front));
    outline.close();
    return unfoldPiece(std::move(name), meshPatch(outline, surface, band.edge));
}

}  // namespace toile::samples
