// SPDX-License-Identifier: GPL-3.0-or-later
#include "band.h"
#include "garments.h"
#include "leg.h"

namespace toile::samples {

namespace {

constexpr double kEdge = 21.0;
constexpr double kBandEdge = 16.0;
constexpr double kWaistHeight = 1040.0;
constexpr double kHemHeight = 85.0;

/// The seams of the left half, sampled in space.
struct Seams {
    SeamLine frontWaist, backWaist, frontCrotch, backCrotch, inseam, side, frontHem, backHem;
};

FlatCurve waistFlat(const Leg& leg, Half half) {
    return
        [=](double t) { return leg.toFlat(half, t * leg.innerTurn(kWaistHeight), kWaistHeight); };
}

FlatCurve hemFlat(const Leg& leg, Half half) {
    return [=](double t) { return leg.toFlat(half, t * kPi, kHemHeight); };
}

FlatCurve sideFlat(const Leg& leg, Half half) {
    return [=](double t) {
        return leg.toFlat(half, 0.0, kHemHeight + t * (kWaistHeight - kHemHeight));
    };
}

FlatCurve inseamFlat(const Leg& leg, Half half) {
    return [=](double t) {
        return leg.toFlat(half, kPi, kHemHeight + t * (Leg::kCrotchHeight - kHemHeight));
    };
}

/// From the crotch point to the waist. The square makes the level end of the curve even.
FlatCurve crotchFlat(const Leg& leg, Half half) {
    return [=](double t) {
        const double height = Leg::kCrotchHeight + t * t * (kWaistHeight - Leg::kCrotchHeight);
        return leg.toFlat(half, leg.innerTurn(height), height);
    };
}

Seams sampleSeams(const Leg& leg) {
    const auto sample = [&](Half half, const FlatCurve& flat) {
        return sampleSeam([&](double t) { return leg.fromFlat(half, flat(t)); }, kEdge);
    };
    // The crotch seam lies in the plane x = 0 to the last bit, so that the halves meet there.
    const auto crotch = [&](Half half) {
        const FlatCurve flat = crotchFlat(leg, half);
        SeamLine seam = sample(half, flat);
        for (Vec3& p : seam.points) {
            p.x = 0.0;
        }
        return seam;
    };
    Seams seams{
        .frontWaist = sample(Half::Front, waistFlat(leg, Half::Front)),
        .backWaist = sample(Half::Back, waistFlat(leg, Half::Back)),
        .frontCrotch = crotch(Half::Front),
        .backCrotch = crotch(Half::Back),
        .inseam = sample(Half::Front, inseamFlat(leg, Half::Front)),
        .side = sample(Half::Front, sideFlat(leg, Half::Front)),
        .frontHem = sample(Half::Front, hemFlat(leg, Half::Front)),
        .backHem = sample(Half::Back, hemFlat(leg, Half::Back)),
    };
    seams.frontWaist.points.back().x = 0.0;
    seams.backWaist.points.back().x = 0.0;
    return seams;
}

Piece makeFront(const Leg& leg, const Seams& seams) {
    using Direction = Outline::Direction;
    constexpr Half kHalf = Half::Front;
    Outline outline;
    outline.add(seams.side, sideFlat(leg, kHalf));
    outline.add(seams.frontWaist, waistFlat(leg, kHalf));
    outline.add(seams.frontCrotch, crotchFlat(leg, kHalf), Direction::Reversed);
    outline.add(seams.inseam, inseamFlat(leg, kHalf), Direction::Reversed);
    outline.add(seams.frontHem, hemFlat(leg, kHalf), Direction::Reversed);
    outline.close();
    const Surface surface = [&](Vec2 p) { return leg.fromFlat(kHalf, p); };
    return makePiece("front_left", meshPatch(outline, surface, kEdge));
}

Piece makeBack(const Leg& leg, const Seams& seams) {
    using Direction = Outline::Direction;
    constexpr Half kHalf = Half::Back;
    Outline outline;
    outline.add(seams.backHem, hemFlat(leg, kHalf));
    outline.add(seams.inseam, inseamFlat(leg, kHalf));
    outline.add(seams.backCrotch, crotchFlat(leg, kHalf));
    outline.add(seams.backWaist, waistFlat(leg, kHalf), Direction::Reversed);
    outline.add(seams.side, sideFlat(leg, kHalf), Direction::Reversed);
    outline.close();
    const Surface surface = [&](Vec2 p) { return leg.fromFlat(kHalf, p); };
    return makePiece("back_left", meshPatch(outline, surface, kEdge));
}

Piece makeWaistband(const Seams& seams) {
    constexpr double kWidth = 38.0;
    Band band;
    band.seams = {{&seams.frontWaist, true}, {&seams.backWaist, false}};
    band.rise = [](double f) {
        const double angle = kPi * f;
        return Vec3{-2.0 * std::sin(angle), kWidth, -2.0 * std::cos(angle)};
    };
    band.width = kWidth;
    band.edge = kBandEdge;
    band.fold = BandFold::Back;
    return makeBand("waistband", band);
}

}  // namespace

Garment makeTrousers() {
    const Leg leg;
    const Seams seams = sampleSeams(leg);
    const Piece front = makeFront(leg, seams);
    const Piece back = makeBack(leg, seams);
    return {
        .name = "trousers",
        .description = "Straight trousers: two fronts, two backs, waistband closing at the front",
        .pieces = {front, mirrorPiece("front_right", front), back, mirrorPiece("back_right", back),
                   makeWaistband(seams)},
    };
}

}  // namespace toile::samples
