// SPDX-License-Identifier: GPL-3.0-or-later
#include "garments.h"
#include "torso.h"

namespace toile::samples {

namespace {

constexpr double kEdge = 14.0;
constexpr double kHemHeight = 985.0;
constexpr double kUnderarmHeight = 1274.0;
constexpr double kSide = 90.0;  // degrees from the centre
constexpr double kTip = 68.0;
constexpr double kNeck = 31.0;

Torso bodiceTorso() {
    return Torso({
        .halfWidth =
            Profile({{985, 157}, {1065, 131}, {1160, 140}, {1240, 148}, {1300, 152}, {1400, 152}}),
        .frontDepth =
            Profile({{985, 107}, {1065, 92}, {1160, 97}, {1240, 100}, {1300, 96}, {1400, 96}}),
        .backDepth =
            Profile({{985, 117}, {1065, 88}, {1160, 98}, {1240, 108}, {1300, 111}, {1400, 111}}),
        .frontMounds = {{82, 1232, 44, 58, 42, 42}, {30, 985, 70, 60, 60, 6}},
        .backMounds = {{70, 1320, 50, 70, 80, 8}},
        .bendHeight = 1300,
        .riseLength = 212,
        .widening = 0.14,
        .neckX = 84,
        .neckY = 1452,
        .shoulderSlope = 0.40,
        .shoulderZ = -14,
        .squareness = 0.05,
    });
}

/// A line on one half of the torso, given by a flat curve of its layout.
struct Cut {
    FlatCurve flat;
    SeamLine seam;
};

/// Smooth curve through (degrees from the centre, layout height) rows, given from the top down.
FlatCurve throughRows(const Torso& torso, Half half,
                      const std::vector<std::pair<double, double>>& rows) {
    // Over the depth below the shoulder line, so that the positions rise.
    std::vector<std::pair<double, double>> byDepth;
    byDepth.reserve(rows.size());
    const double top = rows.front().second;
    for (const auto& [degrees, height] : rows) {
        byDepth.emplace_back(top - height, degrees);
    }
    const Profile degreesAt(byDepth);
    const double deepest = byDepth.back().first;
    return [=](double t) {
        return torso.toFlat(half, radians(degreesAt(t * deepest)), top - t * deepest);
    };
}

/// The left side of one half, cut by a princess seam. Fields follow the outline.
struct HalfCuts {
    Cut centre;         ///< neck to hem
    Cut centreHem;      ///< centre to princess seam
    Cut princess;       ///< shoulder to hem
    Cut sideHem;        ///< princess seam to side
    Cut side;           ///< hem to underarm
    Cut armhole;        ///< underarm to shoulder tip
    Cut outerShoulder;  ///< tip to princess seam
    Cut innerShoulder;  ///< princess seam to neck
    Cut neck;           ///< shoulder to centre
};

struct HalfPlan {
    std::vector<std::pair<double, double>> princess;  ///< degrees, layout height; top down
    double neckLow = 0.0;                             ///< layout height of the neck at the centre
    Vec2 neckHandle, neckLowHandle;                   ///< mirrored for the back
    Vec2 underarmHandle, tipHandle;
};

HalfCuts cutHalf(const Torso& torso, Half half, const HalfPlan& plan) {
    const double top = torso.shoulderHeight();
    const double sign = half == Half::Front ? 1.0 : -1.0;
    const auto place = [=, &torso](double degrees, double height) {
        return torso.toFlat(half, radians(degrees), height);
    };
    const auto handle = [=](Vec2 h) { return Vec2{sign * h.x, h.y}; };
    const auto level = [=](double from, double to, double height) -> FlatCurve {
        return
            [=](double t) { return torso.toFlat(half, radians(from + t * (to - from)), height); };
    };
    const auto cut = [&](const FlatCurve& flat) {
        return Cut{flat,
                   sampleSeam([&](double t) { return torso.fromFlat(half, flat(t)); }, kEdge)};
    };
    const double split = plan.princess.front().first;
    const double hemSplit = plan.princess.back().first;
    const Vec2 underarm = place(kSide, kUnderarmHeight);
    const Vec2 tip = place(kTip, top);
    const Vec2 neck = place(kNeck, top);
    const Vec2 low{0.0, plan.neckLow};
    return {
        .centre = cut(line(low, {0.0, kHemHeight})),
        .centreHem = cut(level(0.0, hemSplit, kHemHeight)),
        .princess = cut(throughRows(torso, half, plan.princess)),
        .sideHem = cut(level(hemSplit, kSide, kHemHeight)),
        .side = cut([=](double t) {
            return torso.toFlat(half, radians(kSide),
                                kHemHeight + t * (kUnderarmHeight - kHemHeight));
        }),
        .armhole = cut(bezier(underarm, underarm + handle(plan.underarmHandle),
                              tip + handle(plan.tipHandle), tip)),
        .outerShoulder = cut(level(kTip, split, top)),
        .innerShoulder = cut(level(split, kNeck, top)),
        .neck = cut(
            bezier(neck, neck + handle(plan.neckHandle), low + handle(plan.neckLowHandle), low)),
    };
}

/// Sides in the order of the front; the back's layout is mirrored, so it runs the other way.
struct OutlineSide {
    const Cut* cut = nullptr;
    bool reversed = false;
    bool fold = false;
};

Patch meshSides(const Torso& torso, Half half, std::vector<OutlineSide> sides) {
    if (half == Half::Back) {
        sides = {sides.rbegin(), sides.rend()};
        for (OutlineSide& side : sides) {
            side.reversed = !side.reversed;
        }
    }
    Outline outline;
    for (const OutlineSide& side : sides) {
        outline.add(side.cut->seam, side.cut->flat,
                    side.reversed ? Outline::Direction::Reversed : Outline::Direction::Forward,
                    side.fold ? Outline::Fold::Yes : Outline::Fold::No);
    }
    outline.close();
    return meshPatch(
        outline, [&](Vec2 p) { return torso.fromFlat(half, p); }, kEdge);
}

Patch meshCentre(const Torso& torso, Half half, const HalfCuts& cuts) {
    return meshSides(torso, half,
                     {{&cuts.centreHem, false, false},
                      {&cuts.princess, true, false},
                      {&cuts.innerShoulder, false, false},
                      {&cuts.neck, false, false},
                      {&cuts.centre, false, true}});
}

Patch meshSidePanel(const Torso& torso, Half half, const HalfCuts& cuts) {
    return meshSides(torso, half,
                     {{&cuts.sideHem, false, false},
                      {&cuts.side, false, false},
                      {&cuts.armhole, false, false},
                      {&cuts.outerShoulder, false, false},
                      {&cuts.princess, false, false}});
}

}  // namespace

Garment makeBodice() {
    const Torso torso = bodiceTorso();
    const double top = torso.shoulderHeight();
    const HalfPlan frontPlan{
        .princess = {{48.0, top},
                     {43.0, 1370.0},
                     {38.0, 1232.0},
                     {32.0, 1140.0},
                     {29.0, 1065.0},
                     {31.0, kHemHeight}},
        .neckLow = 1345.0,
        .neckHandle = {-6.0, -70.0},
        .neckLowHandle = {46.0, 0.0},
        .underarmHandle = {-72.0, -4.0},
        .tipHandle = {-26.0, -100.0},
    };
    const HalfPlan backPlan{
        .princess =
            {{48.0, top}, {38.0, 1330.0}, {33.0, 1200.0}, {27.0, 1065.0}, {30.0, kHemHeight}},
        .neckLow = top - 70.0,
        .neckHandle = {-6.0, -38.0},
        .neckLowHandle = {44.0, 0.0},
        .underarmHandle = {-60.0, -2.0},
        .tipHandle = {-16.0, -105.0},
    };
    const HalfCuts front = cutHalf(torso, Half::Front, frontPlan);
    HalfCuts back = cutHalf(torso, Half::Back, backPlan);
    // Both halves share the side and the shoulder line: one sampling serves both.
    back.side.seam = front.side.seam;
    back.outerShoulder.seam = front.outerShoulder.seam;
    back.innerShoulder.seam = front.innerShoulder.seam;

    const Piece sideFront = makePiece("side_front_left", meshSidePanel(torso, Half::Front, front));
    const Piece sideBack = makePiece("side_back_left", meshSidePanel(torso, Half::Back, back));
    const Piece backLeft = makePiece("back_left", meshCentre(torso, Half::Back, back));
    return {
        .name = "bodice",
        .description = "Fitted bodice: front, back in two, side fronts and side backs",
        .pieces = {unfoldPiece("front", meshCentre(torso, Half::Front, front)), sideFront,
                   mirrorPiece("side_front_right", sideFront), sideBack,
                   mirrorPiece("side_back_right", sideBack), backLeft,
                   mirrorPiece("back_right", backLeft)},
    };
}

}  // namespace toile::samples
