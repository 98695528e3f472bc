// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "garments.h"

namespace toile::samples {

namespace {

constexpr double kEdge = 8.0;
constexpr double kHalfWidth = 82.0;  // of the head opening
constexpr double kHalfLength = 99.0;
constexpr double kHeight = 122.0;
constexpr double kOpeningHeight = 1640.0;  // above the floor
constexpr double kFullness = 0.09;         // bulge between opening and crown
constexpr double kGore = 60.0;             // degrees
constexpr double kPeakEnd = 70.0;          // degrees from the centre front
constexpr double kPeakLength = 70.0;       // at the centre front

/// The crown: ellipses over an upright profile, cut into six gores by planes through the axis.
/// Layout of a gore: y is the way up along the profile, x the way around from its middle.
class Crown {
public:
    Crown() {
        Vec2 previous = profile(0.0);
        for (int k = 1; k <= kFine; ++k) {
            const Vec2 next = profile(0.5 * kPi * k / kFine);
            lengths_.push_back(lengths_.back() + length(next - previous));
            previous = next;
        }
    }

    /// `turn` from the centre front to the wearer's left, `rise` from the opening (0) to the
    /// button (90 degrees); radians.
    Vec3 at(double turn, double rise) const {
        const Vec2 p = profile(rise);
        const double out = p.x / kMeanRadius;
        return {kHalfWidth * out * std::sin(turn), kOpeningHeight + p.y,
                kHalfLength * out * std::cos(turn)};
    }

    Vec2 toFlat(double turnFromMiddle, double rise) const {
        const double along = rise / (0.5 * kPi) * kFine;
        const int k = std::min(static_cast<int>(along), kFine - 1);
        const double low = lengths_[static_cast<std::size_t>(k)];
        const double high = lengths_[static_cast<std::size_t>(k) + 1];
        return {turnFromMiddle * profile(rise).x, low + (along - k) * (high - low)};
    }

    Vec3 fromFlat(double middle, Vec2 p) const {
        const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, p.y);
        const double low = *(above - 1);
        const double part = (p.y - low) / (*above - low);
        const double row = static_cast<double>(above - 1 - lengths_.begin()) + part;
        const double rise = 0.5 * kPi * row / kFine;
        return at(middle + p.x / std::max(profile(rise).x, 1e-9), rise);
    }

private:
    static constexpr int kFine = 4000;
    static constexpr double kMeanRadius = 0.5 * (kHalfWidth + kHalfLength);

    static Vec2 profile(double rise) {
        const double diagonal = std::sin(2.0 * rise);
        const double bulge = 1.0 + kFullness * diagonal * diagonal;
        const double out = rise < 0.5 * kPi ? std::cos(rise) : 0.0;
        return {kMeanRadius * out * bulge, kHeight * std::sin(rise) * bulge};
    }

    std::vector<double> lengths_{0.0};
};

/// Seam from the opening to the button at `degrees`.
SeamLine sampleRib(const Crown& crown, double degrees) {
    return sampleSeam([&](double t) { return crown.at(radians(degrees), 0.5 * kPi * t); }, kEdge);
}

SeamLine sampleOpening(const Crown& crown, double from, double to) {
    return sampleSeam([&](double t) { return crown.at(radians(from + t * (to - from)), 0.0); },
                      kEdge);
}

Piece makeGore(const Crown& crown, std::string name, double start,
               const std::vector<double>& openingStops, const std::vector<SeamLine>& opening,
               const SeamLine& first, const SeamLine& last) {
    const double middle = start + 0.5 * kGore;
    const auto flat = [&](double degrees, double rise) {
        return crown.toFlat(radians(degrees - middle), rise);
    };
    Outline outline;
    for (std::size_t k = 0; k < opening.size(); ++k) {
        const double from = openingStops[k];
        const double to = openingStops[k + 1];
        outline.add(opening[k], [&](double t) { return flat(from + t * (to - from), 0.0); });
    }
    outline.add(last, [&](double t) { return flat(start + kGore, 0.5 * kPi * t); });
    outline.add(
        first, [&](double t) { return flat(start, 0.5 * kPi * t); }, Outline::Direction::Reversed);
    outline.close();
    const Surface surface = [&](Vec2 p) { return crown.fromFlat(radians(middle), p); };
    return makePiece(std::move(name), meshPatch(outline, surface, kEdge));
}

/// The peak seen from above: x to the wearer's left, y (in the layout) to the back.
Vec3 peakPoint(Vec2 flat) {
    const double x = flat.x;
    const double z = -flat.y;
    const double ratio = std::hypot(x / kHalfWidth, z / kHalfLength);
    const double out = std::max(0.0, ratio - 1.0) * kHalfLength;  // distance from the opening
    const double side = x / kHalfWidth;
    return {x, kOpeningHeight - out * (0.12 + 0.45 * side * side), z};
}

Piece makePeak(const SeamLine& frontOpening, const SeamLine& sideOpening) {
    const auto openingFlat = [](double degrees) {
        const double turn = radians(degrees);
        return Vec2{kHalfWidth * std::sin(turn), -kHalfLength * std::cos(turn)};
    };
    // The brim bows out from the end of the seam to the tip at the centre front.
    const Vec2 end = openingFlat(kPeakEnd);
    const Vec2 tip{0.0, -kHalfLength - kPeakLength};
    const FlatCurve brim = bezier(tip, tip + Vec2{52.0, 0.0}, end + Vec2{4.0, -62.0}, end);
    const FlatCurve centre = line({0.0, -kHalfLength}, tip);
    const auto sample = [](const FlatCurve& flat) {
        return sampleSeam([&](double t) { return peakPoint(flat(t)); }, kEdge);
    };
    const SeamLine brimLine = sample(brim);
    const SeamLine centreLine = sample(centre);
    Outline outline;
    outline.add(centreLine, centre, Outline::Direction::Forward, Outline::Fold::Yes);
    outline.add(brimLine, brim);
    outline.add(
        sideOpening, [&](double t) { return openingFlat(kGore + t * (kPeakEnd - kGore)); },
        Outline::Direction::Reversed);
    outline.add(
        frontOpening, [&](double t) { return openingFlat(kGore * t); },
        Outline::Direction::Reversed);
    outline.close();
    return unfoldPiece("peak", meshPatch(outline, peakPoint, kEdge));
}

}  // namespace

Garment makeCap() {
    const Crown crown;
    const SeamLine front = sampleOpening(crown, 0.0, kGore);
    const SeamLine underPeak = sampleOpening(crown, kGore, kPeakEnd);
    const SeamLine side = sampleOpening(crown, kPeakEnd, 2.0 * kGore);
    const SeamLine back = sampleOpening(crown, 2.0 * kGore, 3.0 * kGore);
    std::vector<SeamLine> ribs;
    for (int k = 0; k <= 3; ++k) {
        ribs.push_back(sampleRib(crown, k * kGore));
    }
    const Piece frontGore =
        makeGore(crown, "front_left", 0.0, {0.0, kGore}, {front}, ribs[0], ribs[1]);
    const Piece sideGore = makeGore(crown, "side_left", kGore, {kGore, kPeakEnd, 2.0 * kGore},
                                    {underPeak, side}, ribs[1], ribs[2]);
    const Piece backGore = makeGore(crown, "back_left", 2.0 * kGore, {2.0 * kGore, 3.0 * kGore},
                                    {back}, ribs[2], ribs[3]);
    return {
        .name = "cap",
        .description = "Cap: six gores and a peak",
        .pieces = {frontGore, mirrorPiece("front_right", frontGore), sideGore,
                   mirrorPiece("side_right", sideGore), backGore,
                   mirrorPiece("back_right", backGore), makePeak(front, underPeak)},
    };
}

}  // namespace toile::samples
