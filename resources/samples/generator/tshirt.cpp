// SPDX-License-Identifier: GPL-3.0-or-later
#include "band.h"
#include "garments.h"
#include "sleeve.h"
#include "torso.h"

namespace toile::samples {

namespace {

constexpr double kEdge = 18.0;
constexpr double kNeckEdge = 12.0;
constexpr double kHemHeight = 800.0;
constexpr double kUnderarmHeight = 1258.0;

Torso tshirtTorso() {
    return Torso({
        .halfWidth =
            Profile({{800, 206}, {950, 198}, {1080, 186}, {1200, 191}, {1290, 193}, {1400, 193}}),
        .frontDepth =
            Profile({{800, 136}, {950, 130}, {1080, 116}, {1200, 112}, {1290, 106}, {1400, 106}}),
        .backDepth =
            Profile({{800, 140}, {930, 138}, {1080, 110}, {1200, 112}, {1290, 115}, {1400, 115}}),
        .frontMounds = {{85, 1235, 62, 52, 95, 30}, {35, 950, 80, 90, 90, 5}},
        .backMounds = {{75, 1330, 60, 70, 90, 8}, {75, 880, 75, 80, 90, 6}},
        .bendHeight = 1290,
        .riseLength = 205,
        .widening = 0.0,
        .neckX = 82,
        .neckY = 1462,
        .shoulderSlope = 0.38,
        .shoulderZ = -14,
        .squareness = 0.10,
    });
}

/// All lines along which the left side of the T-shirt is cut and sewn.
struct Lines {
    FlatCurve frontHem, frontSide, frontArmhole, frontShoulder, frontNeck, frontCentre;
    FlatCurve backHem, backSide, backArmhole, backShoulder, backNeck, backCentre;
};

Lines drawLines(const Torso& torso) {
    const double top = torso.shoulderHeight();
    const double tip = radians(63.0);
    const double neck = radians(23.0);
    const double side = radians(90.0);
    const auto front = [&](double angle, double height) {
        return torso.toFlat(Half::Front, angle, height);
    };
    const auto back = [&](double angle, double height) {
        return torso.toFlat(Half::Back, angle, height);
    };
    const Vec2 frontTip = front(tip, top);
    const Vec2 frontUnderarm = front(side, kUnderarmHeight);
    const Vec2 frontNeck = front(neck, top);
    const Vec2 backTip = back(tip, top);
    const Vec2 backUnderarm = back(side, kUnderarmHeight);
    const Vec2 backNeck = back(neck, top);
    const Vec2 frontLow = front(0.0, 1370.0);
    const Vec2 backLow = back(0.0, top - 46.0);

    Lines lines;
    lines.frontHem = [=](double t) { return torso.toFlat(Half::Front, side * t, kHemHeight); };
    lines.frontSide = [=](double t) {
        return torso.toFlat(Half::Front, side, kHemHeight + t * (kUnderarmHeight - kHemHeight));
    };
    lines.frontArmhole = bezier(frontUnderarm, frontUnderarm + Vec2{-78.0, -4.0},
                                frontTip + Vec2{-26.0, -100.0}, frontTip);
    lines.frontShoulder = [=](double t) {
        return torso.toFlat(Half::Front, tip + t * (neck - tip), top);
    };
    lines.frontNeck =
        bezier(frontNeck, frontNeck + Vec2{-6.0, -62.0}, frontLow + Vec2{42.0, 0.0}, frontLow);
    lines.frontCentre = line(frontLow, {0.0, kHemHeight});

    lines.backHem = [=](double t) { return torso.toFlat(Half::Back, side * t, kHemHeight); };
    lines.backSide = [=](double t) {
        return torso.toFlat(Half::Back, side, kHemHeight + t * (kUnderarmHeight - kHemHeight));
    };
    lines.backArmhole = bezier(backUnderarm, backUnderarm + Vec2{66.0, -2.0},
                               backTip + Vec2{14.0, -105.0}, backTip);
    lines.backShoulder = [=](double t) {
        return torso.toFlat(Half::Back, tip + t * (neck - tip), top);
    };
    lines.backNeck =
        bezier(backNeck, backNeck + Vec2{6.0, -34.0}, backLow + Vec2{-38.0, 0.0}, backLow);
    lines.backCentre = line(backLow, {0.0, kHemHeight});
    return lines;
}

/// The same lines, sampled in space.
struct Seams {
    SeamLine frontHem, backHem, side, frontArmhole, backArmhole, shoulder, frontNeck, backNeck,
        frontCentre, backCentre;
};

Seams sampleLines(const Torso& torso, const Lines& lines) {
    const auto sample = [&](Half half, const FlatCurve& flat, double edge) {
        return sampleSeam([&](double t) { return torso.fromFlat(half, flat(t)); }, edge);
    };
    return {
        .frontHem = sample(Half::Front, lines.frontHem, kEdge),
        .backHem = sample(Half::Back, lines.backHem, kEdge),
        .side = sample(Half::Front, lines.frontSide, kEdge),
        .frontArmhole = sample(Half::Front, lines.frontArmhole, kEdge),
        .backArmhole = sample(Half::Back, lines.backArmhole, kEdge),
        .shoulder = sample(Half::Front, lines.frontShoulder, kEdge),
        .frontNeck = sample(Half::Front, lines.frontNeck, kNeckEdge),
        .backNeck = sample(Half::Back, lines.backNeck, kNeckEdge),
        .frontCentre = sample(Half::Front, lines.frontCentre, kEdge),
        .backCentre = sample(Half::Back, lines.backCentre, kEdge),
    };
}

Piece makeFront(const Torso& torso, const Lines& lines, const Seams& seams) {
    Outline outline;
    outline.add(seams.frontHem, lines.frontHem);
    outline.add(seams.side, lines.frontSide);
    outline.add(seams.frontArmhole, lines.frontArmhole);
    outline.add(seams.shoulder, lines.frontShoulder);
    outline.add(seams.frontNeck, lines.frontNeck);
    outline.add(seams.frontCentre, lines.frontCentre, Outline::Direction::Forward,
                Outline::Fold::Yes);
    outline.close();
    const Surface surface = [&](Vec2 p) { return torso.fromFlat(Half::Front, p); };
    return unfoldPiece("front", meshPatch(outline, surface, kEdge));
}

Piece makeBack(const Torso& torso, const Lines& lines, const Seams& seams) {
    using Direction = Outline::Direction;
    Outline outline;
    outline.add(seams.backHem, lines.backHem, Direction::Reversed);
    outline.add(seams.backCentre, lines.backCentre, Direction::Reversed, Outline::Fold::Yes);
    outline.add(seams.backNeck, lines.backNeck, Direction::Reversed);
    outline.add(seams.shoulder, lines.backShoulder, Direction::Reversed);
    outline.add(seams.backArmhole, lines.backArmhole, Direction::Reversed);
    outline.add(seams.side, lines.backSide, Direction::Reversed);
    outline.close();
    const Surface surface = [&](Vec2 p) { return torso.fromFlat(Half::Back, p); };
    return unfoldPiece("back", meshPatch(outline, surface, kEdge));
}

Piece makeSleeve(const Seams& seams) {
    using Direction = Outline::Direction;
    const Sleeve sleeve(seams.frontArmhole, seams.backArmhole);
    const double part = sleeve.frontPart();
    const SeamLine underarm = sampleSeam([&](double t) { return sleeve.at(0.0, t); }, kEdge);
    const SeamLine cuff = sampleSeam([&](double t) { return sleeve.at(t, 1.0); }, kEdge);

    // Seen from outside with the cap upwards, the wearer's front lies to the left.
    Outline outline;
    outline.add(cuff, [&](double t) { return sleeve.toFlat(t, 1.0); });
    outline.add(
        underarm, [&](double t) { return sleeve.toFlat(1.0, t); }, Direction::Reversed);
    outline.addByLength(seams.backArmhole,
                        [&](double f) { return sleeve.toFlat(1.0 - (1.0 - part) * f, 0.0); });
    outline.addByLength(
        seams.frontArmhole, [&](double f) { return sleeve.toFlat(part * f, 0.0); },
        Direction::Reversed);
    outline.add(underarm, [&](double t) { return sleeve.toFlat(0.0, t); });
    outline.close();
    const Surface surface = [&](Vec2 p) { return sleeve.fromFlat(p); };
    return makePiece("sleeve_left", meshPatch(outline, surface, kEdge));
}

Piece makeNeckband(const Seams& seams) {
    constexpr double kWidth = 22.0;
    // Leans in towards the neck, least at the back.
    const auto rise = [](double f) {
        const double angle = kPi * smoothStep(f);
        const double inwards = 0.75 + 0.15 * std::cos(angle);
        const Vec3 in{-std::sin(angle) * inwards, 0.0, -std::cos(angle) * inwards};
        return kWidth * normalized(in + Vec3{0.0, 0.55, 0.0});
    };
    Band band;
    band.seams = {{&seams.frontNeck, true}, {&seams.backNeck, false}};
    band.rise = rise;
    band.width = kWidth;
    band.edge = kNeckEdge;
    band.fold = BandFold::Front;
    return makeBand("neckband", band);
}

}  // namespace

Garment makeTshirt() {
    const Torso torso = tshirtTorso();
    const Lines lines = drawLines(torso);
    const Seams seams = sampleLines(torso, lines);
    const Piece sleeve = makeSleeve(seams);
    return {
        .name = "tshirt",
        .description = "T-shirt: front, back, two set-in sleeves, neckband",
        .pieces = {makeFront(torso, lines, seams), makeBack(torso, lines, seams), sleeve,
                   mirrorPiece("sleeve_right", sleeve), makeNeckband(seams)},
    };
}

}  // namespace toile::samples
