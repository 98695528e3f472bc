// SPDX-License-Identifier: GPL-3.0-or-later
#include "band.h"
#include "garments.h"

namespace toile::samples {

namespace {

constexpr double kEdge = 20.0;
constexpr double kBandEdge = 16.0;
constexpr double kWaistHeight = 1040.0;
constexpr double kHemHeight = 440.0;
constexpr double kHalfGore = 30.0;  // degrees
constexpr double kFlutes = 12.0;    // soft waves around the hem, two to a gore
constexpr double kFluteDepth = 13.0;

/// The skirt: ellipses that widen from the waist over the hip to a softly waved hem.
/// Layout of a gore: y is the height, x the way around from the middle of the gore.
class Flare {
public:
    /// `turn` from the centre front to the wearer's left, radians.
    Vec3 at(double turn, double height) const {
        const double drop = smoothStep((900.0 - height) / (900.0 - kHemHeight));
        const double wave = 1.0 + kFluteDepth * drop / depth_(height) * std::cos(kFlutes * turn);
        return {halfWidth_(height) * wave * std::sin(turn), height,
                depth_(height) * wave * std::cos(turn)};
    }

    Vec3 fromFlat(double middle, Vec2 p) const { return at(middle + p.x / radiusAt(p.y), p.y); }

    Vec2 toFlat(double turnFromMiddle, double height) const {
        return {turnFromMiddle * radiusAt(height), height};
    }

private:
    double radiusAt(double height) const { return 0.5 * (halfWidth_(height) + depth_(height)); }

    Profile halfWidth_{{{440, 312}, {650, 255}, {860, 194}, {950, 168}, {1000, 150}, {1040, 130}}};
    Profile depth_{{{440, 276}, {650, 217}, {860, 151}, {950, 128}, {1000, 114}, {1040, 100}}};
};

struct GoreEdges {
    SeamLine first;  ///< hem to waist
    SeamLine last;
    SeamLine hem;  ///< from first to last
    SeamLine waist;
};

SeamLine sampleUpright(const Flare& flare, double degrees) {
    const double turn = radians(degrees);
    return sampleSeam(
        [&](double t) {
            Vec3 p = flare.at(turn, kHemHeight + t * (kWaistHeight - kHemHeight));
            p.x = degrees == 0.0 || degrees == 180.0 ? 0.0 : p.x;
            return p;
        },
        kEdge);
}

SeamLine sampleLevel(const Flare& flare, double from, double to, double height) {
    return sampleSeam([&](double t) { return flare.at(radians(from + t * (to - from)), height); },
                      kEdge);
}

Patch meshGore(const Flare& flare, double from, double to, const GoreEdges& edges, bool foldFirst,
               bool foldLast) {
    using Direction = Outline::Direction;
    const double middle = 0.5 * (from + to);
    const auto flat = [&](double degrees, double height) {
        return flare.toFlat(radians(degrees - middle), height);
    };
    const auto level = [&](double height) -> FlatCurve {
        return [&, height](double t) { return flat(from + t * (to - from), height); };
    };
    const auto upright = [&](double degrees) -> FlatCurve {
        return [&, degrees](double t) {
            return flat(degrees, kHemHeight + t * (kWaistHeight - kHemHeight));
        };
    };
    const auto fold = [](bool on) { return on ? Outline::Fold::Yes : Outline::Fold::No; };
    Outline outline;
    outline.add(edges.hem, level(kHemHeight));
    outline.add(edges.last, upright(to), Direction::Forward, fold(foldLast));
    outline.add(edges.waist, level(kWaistHeight), Direction::Reversed);
    outline.add(edges.first, upright(from), Direction::Reversed, fold(foldFirst));
    outline.close();
    return meshPatch(
        outline, [&](Vec2 p) { return flare.fromFlat(radians(middle), p); }, kEdge);
}

Piece makeWaistband(const std::vector<GoreEdges>& edges) {
    constexpr double kWidth = 36.0;
    Band band;
    for (const GoreEdges& gore : edges) {
        band.seams.push_back({&gore.waist, false});
    }
    band.rise = [](double f) {
        const double angle = kPi * f;
        return Vec3{-2.0 * std::sin(angle), kWidth, -2.0 * std::cos(angle)};
    };
    band.width = kWidth;
    band.edge = kBandEdge;
    band.fold = BandFold::Front;
    return makeBand("waistband", band);
}

}  // namespace

Garment makeSkirt() {
    const Flare flare;
    // Seams every 60 degrees; the front and the back gore lie across the centre.
    const std::vector<double> stops{0.0, kHalfGore, 3.0 * kHalfGore, 5.0 * kHalfGore, 180.0};
    std::vector<GoreEdges> edges;
    SeamLine first = sampleUpright(flare, stops[0]);
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
        SeamLine last = sampleUpright(flare, stops[k + 1]);
        edges.push_back({first, last, sampleLevel(flare, stops[k], stops[k + 1], kHemHeight),
                         sampleLevel(flare, stops[k], stops[k + 1], kWaistHeight)});
        first = std::move(last);
    }
    const auto mesh = [&](std::size_t k, bool foldFirst, bool foldLast) {
        return meshGore(flare, stops[k], stops[k + 1], edges[k], foldFirst, foldLast);
    };
    const Piece sideFront = makePiece("side_front_left", mesh(1, false, false));
    const Piece sideBack = makePiece("side_back_left", mesh(2, false, false));
    return {
        .name = "skirt",
        .description = "Flared skirt: six gores, waistband closing at the back",
        .pieces = {unfoldPiece("front", mesh(0, true, false)), sideFront,
                   mirrorPiece("side_front_right", sideFront), sideBack,
                   mirrorPiece("side_back_right", sideBack),
                   unfoldPiece("back", mesh(3, false, true)), makeWaistband(edges)},
    };
}

}  // namespace toile::samples
