// SPDX-License-Identifier: GPL-3.0-or-later
// One small garment per kind of finding: a plan that is ready, with one thing spoilt.
#include "core/check/ready_to_cut.h"

#include <gtest/gtest.h>

#include "core/diagnose/finding.h"
#include "core/pattern/drawn_outline.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/check/cut_plans.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::copyOfResult;
using test::findingsOf;
using test::readyPlan;

/// The only finding there is, of this kind.
Finding onlyFinding(const CutPlan& plan, FindingKind kind) {
    const Readiness readiness = readyToCut(plan);
    EXPECT_EQ(readiness.findings.size(), 1U);
    for (const Finding& finding : readiness.findings) {
        EXPECT_EQ(name(finding.kind), name(kind)) << sentence(finding);
    }
    return readiness.findings.empty() ? Finding{} : readiness.findings.front();
}

TEST(ReadyToCut, NothingIsFoundWhereNothingIsWrong) {
    const Readiness readiness = readyToCut(readyPlan());
    EXPECT_TRUE(readiness.findings.empty());
    EXPECT_EQ(readiness.verdict(), Verdict::Ready);
    EXPECT_EQ(verdictText(readiness), "Ready to cut");
}

TEST(ReadyToCut, NothingOpenIsNothingToFind) {
    EXPECT_TRUE(readyToCut(CutPlan{}).findings.empty());
}

TEST(ReadyToCut, MissingAndStaleResultsAreNotFlattened) {
    CutPlan plan = readyPlan();
    plan.results[1] = nullptr;
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::NotFlattened);
    plan.results.clear();
    const Finding all = onlyFinding(plan, FindingKind::NotFlattened);
    EXPECT_EQ(all.figures[0].value, 2);
    EXPECT_EQ(all.severity, Severity::Fault);

    plan = readyPlan();
    plan.options.method = Method::Natural;  // the results are by another
    EXPECT_EQ(onlyFinding(plan, FindingKind::NotFlattened).figures[0].value, 2);
    EXPECT_EQ(verdictText(readyToCut(plan)), "Not flattened yet");

    plan = readyPlan();
    auto cancelled = copyOfResult(plan, 0);
    cancelled->flat.reset();
    cancelled->error = Error{ErrorCode::Cancelled, Subject::piece("front")};
    plan.results[0] = cancelled;
    EXPECT_EQ(onlyFinding(plan, FindingKind::NotFlattened).figures[0].value, 1);
}

TEST(ReadyToCut, ResultsOfAnotherShapeAreNotLookedAt) {
    CutPlan plan = readyPlan();
    auto other = copyOfResult(plan, 0);
    other->piece = std::make_shared<const Piece>(*other->piece);
    other->flat->Q.setZero();
    plan.results[0] = other;
    onlyFinding(plan, FindingKind::NotFlattened);
}

TEST(ReadyToCut, PieceThatIsNotFlatIsAFault) {
    CutPlan plan = readyPlan();
    auto failed = copyOfResult(plan, 1);
    failed->flat.reset();
    failed->error = Error{ErrorCode::Handle, Subject::piece("back"), "1 handle"};
    plan.results[1] = failed;
    const Finding finding = onlyFinding(plan, FindingKind::NotFlat);
    EXPECT_EQ(finding.severity, Severity::Fault);
    EXPECT_EQ(finding.pieces, std::vector{1});
    EXPECT_EQ(sentence(finding), sentence(*failed->error));
    EXPECT_EQ(verdictText(readyToCut(plan)), "1 fault");
}

TEST(ReadyToCut, ATubeIsCalledSo) {
    CutPlan plan = readyPlan({"front"});
    auto garment = std::make_shared<Garment>(*plan.garment);
    const auto tube = std::make_shared<const Piece>(makePiece("leg", test::tube(12, 4)));
    ASSERT_TRUE(tube->defect && tube->defect->code == ErrorCode::SeveralLoops);
    garment->pieces = {tube};
    auto result = std::make_shared<PieceResult>();
    result->piece = tube;
    result->error = tube->defect;
    plan.garment = garment;
    plan.results = {result};
    const auto found = findingsOf(readyToCut(plan), FindingKind::NotFlat);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(sentence(found[0]).find("leg: the piece is a tube with 2 openings"), 0U)
        << sentence(found[0]);
}

TEST(ReadyToCut, FlippedTriangleIsAFaultWithItsPlace) {
    CutPlan plan = readyPlan();
    auto flipped = copyOfResult(plan, 0);
    const Piece& piece = *flipped->piece;
    // The middle vertex goes out of the square: triangles on that side turn over.
    const Eigen::RowVector2d middle(50, 50);
    for (Eigen::Index v = 0; v < flipped->flat->Q.rows(); ++v) {
        if ((flipped->flat->Q.row(v) - middle).norm() < 1) {
            flipped->flat->Q.row(v) = Eigen::RowVector2d(130, 50);
        }
    }
    plan.results[0] = flipped;
    const Readiness readiness = readyToCut(plan);
    const auto found = findingsOf(readiness, FindingKind::FlippedTriangles);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].severity, Severity::Fault);
    EXPECT_EQ(found[0].pieces, std::vector{0});
    EXPECT_GT(found[0].figures[0].value, 0);
    EXPECT_EQ(found[0].figures[1].value, static_cast<double>(piece.mesh.F.rows()));
    ASSERT_TRUE(found[0].place);
    EXPECT_GT(found[0].place->flat.x(), 50);
    EXPECT_GT(found[0].place->position.x(), 50);
    EXPECT_NEAR(found[0].place->normal.norm(), 1, 1e-12);
}

TEST(ReadyToCut, OutlineThatCrossesItselfIsAFaultWithItsPlace) {
    // A flat strip bent round until its end lies across its beginning: no triangle turns over.
    const auto piece = std::make_shared<const Piece>(makePiece("ring", test::planeGrid(80, 2, 10)));
    CutPlan plan = readyPlan({"front"});
    auto garment = std::make_shared<Garment>(*plan.garment);
    garment->pieces = {piece};
    auto result = copyOfResult(plan, 0);
    result->piece = piece;
    result->flat->Q = piece->mesh.V.leftCols<2>();
    for (Eigen::Index v = 0; v < result->flat->Q.rows(); ++v) {
        const double angle = result->flat->Q(v, 0) / 110, radius = 120 - result->flat->Q(v, 1);
        result->flat->Q.row(v) << radius * std::sin(angle), -radius * std::cos(angle);
    }
    plan.garment = garment;
    plan.results = {result};
    const auto found = findingsOf(readyToCut(plan), FindingKind::OutlineCrosses);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].severity, Severity::Fault);
    ASSERT_TRUE(found[0].place);
    EXPECT_LE(found[0].place->flat.norm(), 121);
    EXPECT_GE(found[0].place->flat.norm(), 99);
    EXPECT_TRUE(findingsOf(readyToCut(plan), FindingKind::FlippedTriangles).empty());

    // The note of the flattening, which knows the cut that helps, is told instead, and once.
    auto noted = std::make_shared<PieceResult>(*result);
    noted->flat->notes = {{ErrorCode::OutlineCrosses, Subject::piece("ring"), "cut it there"}};
    plan.results = {noted};
    const Readiness readiness = readyToCut(plan);
    EXPECT_NE(sentence(findingsOf(readiness, FindingKind::OutlineCrosses).at(0)).find("cut it"),
              std::string::npos);
    EXPECT_TRUE(findingsOf(readiness, FindingKind::Message).empty());
}

TEST(ReadyToCut, StrainBeyondTheFabricNamesDirectionShareAndPlace) {
    CutPlan plan = readyPlan({"front"});
    auto stretched = copyOfResult(plan, 0);
    stretched->flat->Q.col(1) /= 1.05;  // worn, the cloth is 5 % longer along the warp
    plan.results = {stretched};
    const Readiness woven = readyToCut(plan);
    const auto warp = findingsOf(woven, FindingKind::StrainWarp);
    ASSERT_EQ(warp.size(), 1U);
    EXPECT_EQ(warp[0].severity, Severity::Doubt);  // of a rule of thumb
    EXPECT_NEAR(warp[0].figures[0].value, 0.05, 1e-9);
    EXPECT_EQ(warp[0].figures[1].value, plan.fabric.warp.most);
    EXPECT_NEAR(warp[0].figures[2].value, 1, 1e-12);
    EXPECT_TRUE(warp[0].place);
    EXPECT_TRUE(findingsOf(woven, FindingKind::StrainWeft).empty());

    // The same along the weft once the grain is turned; nothing on a fabric that gives.
    plan.settings[0].grain = 0;
    EXPECT_TRUE(findingsOf(readyToCut(plan), FindingKind::StrainWarp).empty());
    EXPECT_EQ(findingsOf(readyToCut(plan), FindingKind::StrainWeft).size(), 1U);
    plan.fabric = *fabricPreset("jersey");
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);

    // Limits that a person has typed are no rule of thumb.
    plan.fabric = *fabricPreset("woven");
    plan.fabric.id = "custom";
    EXPECT_EQ(findingsOf(readyToCut(plan), FindingKind::StrainWeft).at(0).severity,
              Severity::Fault);
}

TEST(ReadyToCut, StrainBeyondAnyClothIsAFaultWhateverTheFabric) {
    CutPlan plan = readyPlan({"front"});
    plan.fabric = CutPlan{}.fabric;
    auto stretched = copyOfResult(plan, 0);
    stretched->flat->Q /= 2;
    plan.results = {stretched};
    const Finding finding = onlyFinding(plan, FindingKind::StrainBeyondCloth);
    EXPECT_EQ(finding.severity, Severity::Fault);
    EXPECT_EQ(finding.pieces, std::vector<int>{0});
    EXPECT_TRUE(finding.place);
    EXPECT_TRUE(sentence(finding).starts_with("front: strain exceeds 25 % on 100.0 %"))
        << sentence(finding);
}

TEST(ReadyToCut, WhileNoFabricIsStatedOnlyItsMeanJudgesStrain) {
    CutPlan plan = readyPlan({"front"});
    auto stretched = copyOfResult(plan, 0);
    stretched->flat->Q /= 1.05;  // which some cloth takes
    plan.results = {stretched};
    EXPECT_FALSE(readyToCut(plan).findings.empty());
    plan.fabric = CutPlan{}.fabric;
    EXPECT_FALSE(hasLimits(plan.fabric));
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    stretched = copyOfResult(plan, 0);
    stretched->flat->Q /= 1.1;
    plan.results = {stretched};
    EXPECT_EQ(onlyFinding(plan, FindingKind::StrainBeyondCloth).severity, Severity::Fault);
}

TEST(ReadyToCut, EachPieceIsJudgedByItsOwnFabric) {
    CutPlan plan = readyPlan({"front", "lining of the front"});
    for (std::size_t i = 0; i < 2; ++i) {
        auto stretched = copyOfResult(plan, i);
        stretched->flat->Q.col(1) /= 1.05;
        plan.results[i] = stretched;
    }
    plan.settings[1].material = "Lining";
    EXPECT_EQ(findingsOf(readyToCut(plan), FindingKind::StrainWarp).size(), 2U);
    plan.materials = {{"Interfacing", *fabricPreset("denim")}, {"Lining", *fabricPreset("jersey")}};
    const Finding front = onlyFinding(plan, FindingKind::StrainWarp);
    EXPECT_EQ(front.pieces, std::vector{0});
    EXPECT_EQ(sentence(front).find("Lining"), std::string::npos);

    // The other way round: the garment's own gives, the lining does not, and is named.
    plan.fabric = *fabricPreset("jersey");
    plan.materials[1].fabric = *fabricPreset("denim");
    const Finding lining = onlyFinding(plan, FindingKind::StrainWarp);
    EXPECT_EQ(lining.pieces, std::vector{1});
    EXPECT_EQ(lining.figures[1].value, fabricPreset("denim")->warp.most);
    EXPECT_NE(sentence(lining).find(" (Lining) allows +1.0 %"), std::string::npos)
        << sentence(lining);
}

TEST(FabricOf, IsTheGarmentsOwnWhereNobodyNamedAnother) {
    const Fabric own = *fabricPreset("denim");
    const MaterialList materials = {{"Lining", *fabricPreset("jersey")},
                                    {"", *fabricPreset("woven")}};
    EXPECT_EQ(fabricOf("Lining", materials, own), *fabricPreset("jersey"));
    EXPECT_EQ(fabricOf("lining", materials, own), own);
    EXPECT_EQ(fabricOf("", materials, own), own);
    EXPECT_EQ(fabricOf("Lining", {}, own), own);
}

TEST(ReadyToCut, LittleStrainedAreaIsADoubtAndLessIsNothing) {
    const auto planWithShareOf = [](int cells) -> CutPlan {
        // Of cells x cells squares the triangles about one point stretched.
        CutPlan plan = readyPlan({"front"});
        plan.fabric.id = "custom";
        auto garment = std::make_shared<Garment>(*plan.garment);
        const auto piece =
            std::make_shared<const Piece>(makePiece("front", test::planeGrid(cells, cells, 10)));
        garment->pieces = {piece};
        auto result = copyOfResult(plan, 0);
        result->piece = piece;
        result->flat->Q = piece->mesh.V.leftCols<2>();
        const Eigen::RowVector2d inside(10, 10);
        for (Eigen::Index v = 0; v < result->flat->Q.rows(); ++v) {
            if ((result->flat->Q.row(v) - inside).norm() < 1) {
                result->flat->Q(v, 1) -= 2;
            }
        }
        plan.garment = garment;
        plan.results = {result};
        return plan;
    };
    const auto severities = [](const CutPlan& plan) -> std::vector<Severity> {
        std::vector<Severity> list;
        for (const Finding& finding : findingsOf(readyToCut(plan), FindingKind::StrainWarp)) {
            list.push_back(finding.severity);
        }
        return list;
    };
    EXPECT_EQ(severities(planWithShareOf(6)), std::vector{Severity::Fault});
    EXPECT_EQ(severities(planWithShareOf(12)), std::vector{Severity::Doubt});
    EXPECT_TRUE(severities(planWithShareOf(80)).empty());
}

TEST(ReadyToCut, SeamsAreJudgedAsTheLedgerDoes) {
    // Two sheets that lie edge to edge; one flat side is made longer.
    MeshArrays left = test::planeGrid(4, 4, 50), right = left;
    right.V.col(0).array() += 200;
    CutPlan plan = readyPlan({"left", "right"});
    auto garment = std::make_shared<Garment>(*plan.garment);
    garment->pieces = {std::make_shared<const Piece>(makePiece("left", left)),
                       std::make_shared<const Piece>(makePiece("right", right))};
    garment->seams = findSeams(garment->pieces);
    for (std::size_t i = 0; i < 2; ++i) {
        auto result = copyOfResult(plan, i);
        result->piece = garment->pieces[i];
        result->flat->Q = result->piece->mesh.V.leftCols<2>();
        plan.results[i] = result;
        plan.settings[i].placement = Placement{{i * 300.0, 0}};
    }
    plan.garment = garment;
    plan.fabric = *fabricPreset("jersey");
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    const auto lengthened = [&plan](double millimetres) -> CutPlan {
        CutPlan longer = plan;
        auto result = copyOfResult(plan, 1);
        result->flat->Q.col(1) *= 1 + millimetres / 200;
        longer.results[1] = result;
        return longer;
    };
    EXPECT_EQ(readyToCut(lengthened(0.4)).verdict(), Verdict::Ready);
    const Finding nearly = onlyFinding(lengthened(1.0), FindingKind::SeamLengths);
    EXPECT_EQ(nearly.severity, Severity::Doubt);
    const Finding differs = onlyFinding(lengthened(5.0), FindingKind::SeamLengths);
    EXPECT_EQ(differs.severity, Severity::Fault);
    EXPECT_NEAR(differs.figures[0].value, 5, 1e-9);
    ASSERT_GE(differs.seam, 0);
    EXPECT_EQ(differs.subject.name,
              garment->seams.seams[static_cast<std::size_t>(differs.seam)].name);
    EXPECT_EQ(differs.pieces, (std::vector{0, 1}));

    // Meant to be longer: no fault.
    CutPlan eased = lengthened(5.0);
    auto stated = std::make_shared<Garment>(*garment);
    stated->seams.seams[static_cast<std::size_t>(differs.seam)].ease = 200.0 / 205.0 - 1;
    eased.garment = stated;
    EXPECT_EQ(readyToCut(eased).verdict(), Verdict::Ready);
}

TEST(ReadyToCut, MissingGrainIsADoubtOfEachPiece) {
    CutPlan plan = readyPlan();
    plan.settings.clear();
    const Readiness readiness = readyToCut(plan);
    EXPECT_EQ(findingsOf(readiness, FindingKind::GrainMissing).size(), 2U);
    EXPECT_EQ(verdictText(readiness), "No faults, 2 doubts");
}

TEST(ReadyToCut, GuessesInDoubtAreDoubtsUntilTheyAreKept) {
    CutPlan plan = readyPlan();
    auto garment = std::make_shared<Garment>(*plan.garment);
    auto file = std::make_shared<SourceFile>(*garment->files[0]);
    file->unitInDoubt = file->upInDoubt = true;
    file->unitReason = "largest extent 200, read as centimetres: 2000 mm";
    file->problems = {{ErrorCode::UnitGuessed, Subject::file("shirt.obj"), file->unitReason}};
    garment->files = {file};
    plan.garment = garment;
    const Readiness readiness = readyToCut(plan);
    EXPECT_EQ(readiness.count(Severity::Doubt), 2);
    EXPECT_EQ(readiness.count(Severity::Note), 0);  // not said twice
    EXPECT_NE(
        sentence(findingsOf(readiness, FindingKind::UnitInDoubt).at(0)).find("read as centimetres"),
        std::string::npos);
    plan.guessesKept = true;
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
}

TEST(ReadyToCut, UnlikelySizesAreDoubts) {
    for (const double scale : {0.01, 1000.0}) {
        CutPlan plan = readyPlan({"front"});
        auto garment = std::make_shared<Garment>(*plan.garment);
        MeshArrays mesh = test::planeGrid(2, 2, 50 * scale);
        garment->pieces = {std::make_shared<const Piece>(makePiece("front", mesh))};
        auto result = copyOfResult(plan, 0);
        result->piece = garment->pieces[0];
        result->flat->Q = mesh.V.leftCols<2>();
        plan.garment = garment;
        plan.results = {result};
        const Finding finding = onlyFinding(plan, FindingKind::UnlikelySize);
        EXPECT_EQ(finding.severity, Severity::Doubt);
        EXPECT_NEAR(finding.figures[0].value, 100 * scale, 1e-9);
    }
}

/// What is cut of the pieces of a plan, in their own coordinates.
std::shared_ptr<Pattern> patternOf(const CutPlan& plan) {
    return std::make_shared<Pattern>(makePattern(*plan.garment, plan.results));
}

TEST(ReadyToCut, NotesOnTheReferencePatternAreNotes) {
    CutPlan plan = readyPlan();
    plan.referenceName = "theirs.dxf";
    plan.referenceNotes = {"left out: 1 IMAGE", "left out: 2 HATCH"};
    const Readiness readiness = readyToCut(plan);
    EXPECT_EQ(readiness.verdict(), Verdict::Ready);
    ASSERT_EQ(readiness.count(Severity::Note), 2);
    EXPECT_EQ(sentence(readiness.findings[1]), "theirs.dxf: left out: 2 HATCH.");
}

TEST(ReadyToCut, AllowancesOnEachOtherAreADoubt) {
    CutPlan plan = readyPlan();
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    const auto pattern = patternOf(plan);
    plan.pattern = pattern;
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    // As far as from one piece to the other, and further.
    Points2& line = pattern->pieces[0].cuttingLine = pattern->pieces[0].outline;
    line = (line.rowwise() - line.colwise().mean()) * 10;
    EXPECT_EQ(onlyFinding(plan, FindingKind::PiecesOverlap).pieces, (std::vector{0, 1}));
}

TEST(ReadyToCut, APieceWiderThanItsClothIsADoubtInEveryTurnThatIsAllowed) {
    CutPlan plan = readyPlan();
    const auto pattern = patternOf(plan);
    plan.pattern = pattern;
    plan.fabric.width = 101;  // the pieces are 100 mm wide
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    pattern->pieces[1].cuttingLine = pattern->pieces[1].outline;
    pattern->pieces[1].cuttingLine.col(0) *= 1.2;
    const Finding finding = onlyFinding(plan, FindingKind::WiderThanCloth);
    EXPECT_EQ(finding.severity, Severity::Doubt);
    EXPECT_EQ(finding.subject.name, "back");
    EXPECT_EQ(finding.pieces, std::vector{1});
    ASSERT_EQ(finding.figures.size(), 2U);
    EXPECT_NEAR(finding.figures[0].value, 120, 1e-9);
    EXPECT_NEAR(finding.figures[1].value, 101, 1e-9);
    plan.settings[1].grain = 0;  // the warp along its width
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    plan.settings[1].grain = kGrainUpwards;
    plan.rules[""].turns = TurnRule::Free;
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
    plan.rules[""].turns = TurnRule::OneWay;
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Doubts);
    plan.rules[""].width = 150;  // of that cloth
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
}

TEST(ReadyToCut, AWideFacingIsNamedAndNotItsPiece) {
    CutPlan plan = readyPlan();
    const auto pattern = patternOf(plan);
    FacingPiece& facing = pattern->facings.emplace_back();
    facing.piece = 1;
    facing.facing = 0;
    facing.strip.name = "hem facing";
    facing.strip.outline = pattern->pieces[1].outline;
    facing.strip.outline.col(0) *= 1.2;
    plan.pattern = pattern;
    plan.fabric.width = 101;
    const Finding finding = onlyFinding(plan, FindingKind::WiderThanCloth);
    EXPECT_EQ(finding.subject, Subject::piece("hem facing"));
    EXPECT_EQ(finding.pieces, std::vector{1});
}

TEST(ReadyToCut, FacingsWithoutRoomAreADoubt) {
    CutPlan plan = readyPlan();
    const auto pattern = patternOf(plan);
    pattern->facings.push_back({.piece = 1, .facing = 0, .strip = {}});
    plan.pattern = pattern;
    const Finding finding = onlyFinding(plan, FindingKind::NoFacing);
    EXPECT_EQ(finding.severity, Severity::Doubt);
    EXPECT_EQ(finding.subject.name, "back");
}

TEST(ReadyToCut, PiecesOnEachOtherAreADoubt) {
    CutPlan plan = readyPlan();
    plan.settings[1].placement->offset.x() = 60;
    const Finding finding = onlyFinding(plan, FindingKind::PiecesOverlap);
    EXPECT_EQ(finding.pieces, (std::vector{0, 1}));
    EXPECT_EQ(finding.subject.name, "front / back");
    plan.labels[plan.garment->pieces[1]->id].name = "Rücken";
    EXPECT_EQ(onlyFinding(plan, FindingKind::PiecesOverlap).subject.name, "front / Rücken");
    plan.settings[1].placement.reset();  // finds a place of its own
    EXPECT_EQ(readyToCut(plan).verdict(), Verdict::Ready);
}

TEST(ReadyToCut, MessagesAreNotesOrFaultsAsTheirCodeSays) {
    CutPlan plan = readyPlan();
    auto garment = std::make_shared<Garment>(*plan.garment);
    garment->problems = {{ErrorCode::CutImpossible, Subject::cut("waist"), "it ends in the air"},
                         {ErrorCode::HolesKept, subjectOf(*garment->pieces[1]), "1 hole"}};
    plan.garment = garment;
    const Readiness readiness = readyToCut(plan);
    ASSERT_EQ(readiness.findings.size(), 2U);
    EXPECT_EQ(readiness.findings[0].severity, Severity::Fault);
    EXPECT_EQ(readiness.findings[1].severity, Severity::Note);
    EXPECT_EQ(readiness.findings[1].pieces, std::vector{1});
    EXPECT_EQ(readiness.verdict(), Verdict::Faults);
}

TEST(ReadyToCut, WhatIsCalledLikeAPieceIsNone) {
    CutPlan plan = readyPlan();
    auto garment = std::make_shared<Garment>(*plan.garment);
    const std::uint64_t id = garment->pieces[1]->id.value;
    garment->problems = {{ErrorCode::CutImpossible, Subject::cut("back", {id})},
                         {ErrorCode::JoinImpossible, Subject::join("back")},
                         {ErrorCode::NoSuchSeam, Subject::seam("back", {id})},
                         {ErrorCode::UnusedVertices, Subject::file("back", {id})},
                         {ErrorCode::FlatFacesRemoved, Subject::piece("back")}};
    plan.garment = garment;
    const Readiness readiness = readyToCut(plan);
    EXPECT_EQ(readiness.findings.size(), 5U);
    for (const Finding& finding : readiness.findings) {
        EXPECT_TRUE(finding.pieces.empty()) << sentence(finding);
    }
}

TEST(ReadyToCut, AMessageLeadsToThePieceWhateverItIsCalledNow) {
    CutPlan plan = readyPlan({"front", "back", "back 2"});
    auto garment = std::make_shared<Garment>(*plan.garment);
    const PieceId divided{77};  // cut since: two of the pieces are its parts
    for (const std::size_t part : {1U, 2U}) {
        auto cut = std::make_shared<Piece>(*garment->pieces[part]);
        cut->lineage.uncut = {divided};
        garment->pieces[part] = cut;
    }
    garment->problems = {{ErrorCode::HolesKept, Subject::piece("old", garment->pieces[0]->id)},
                         {ErrorCode::WindingsTurned, Subject::piece("front", divided)}};
    plan.garment = garment;
    plan.labels[garment->pieces[0]->id].name = "Vorderteil";
    const auto messages = findingsOf(readyToCut(plan), FindingKind::Message);
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[0].pieces, std::vector{0});
    EXPECT_EQ(messages[0].subject, Subject::piece("Vorderteil", garment->pieces[0]->id));
    EXPECT_EQ(messages[1].pieces, (std::vector{1, 2}));
    EXPECT_EQ(messages[1].subject.name, "front");
}

TEST(ReadyToCut, FilesOfOneNameAreToldApart) {
    CutPlan plan = readyPlan();
    auto garment = std::make_shared<Garment>(*plan.garment);
    auto file = std::make_shared<SourceFile>(*garment->files[0]);
    file->unitInDoubt = true;
    garment->files = {file, file};
    plan.garment = garment;
    const auto doubts = findingsOf(readyToCut(plan), FindingKind::UnitInDoubt);
    ASSERT_EQ(doubts.size(), 2U);
    EXPECT_EQ(doubts[0].subject.name, doubts[1].subject.name);
    EXPECT_NE(doubts[0].subject, doubts[1].subject);
}

TEST(ReadyToCut, FaultsComeFirstAndTheWorstOfAKindBeforeTheOthers) {
    CutPlan plan = readyPlan({"a", "b", "c"});
    plan.settings[0].grain.reset();
    const double stretch[] = {1.1, 1.3, 1.2};
    for (std::size_t i = 0; i < 3; ++i) {
        auto result = copyOfResult(plan, i);
        result->flat->Q.col(1) /= stretch[i];
        plan.results[i] = result;
    }
    const Readiness readiness = readyToCut(plan);
    const auto warp = findingsOf(readiness, FindingKind::StrainWarp);
    ASSERT_EQ(warp.size(), 3U);
    EXPECT_EQ(warp[0].subject.name + warp[1].subject.name + warp[2].subject.name, "bca");
    EXPECT_TRUE(std::ranges::is_sorted(readiness.findings, {}, &Finding::severity));
}

TEST(ReadyToCut, CancelledItEndsEarly) {
    CutPlan plan = readyPlan();
    plan.settings.clear();
    Progress progress;
    progress.cancel();
    EXPECT_TRUE(findingsOf(readyToCut(plan, progress), FindingKind::GrainMissing).empty());
}

TEST(ReadyToCut, LengthKeepingMethodsLeaveNoSeamAndNoFlipOnCurvedCloth) {
    auto garment = std::make_shared<Garment>();
    auto file = std::make_shared<SourceFile>();
    garment->files = {file};
    garment->pieces = {
        std::make_shared<const Piece>(makePiece("cap", test::sphericalCap(8, 200, 0.5)))};
    garment->seams = findSeams(garment->pieces);
    CutPlan plan;
    Progress progress;
    plan.garment = garment;
    plan.results = flattenGarment(*garment, plan.options, progress);
    const Readiness readiness = readyToCut(plan);
    for (const FindingKind kind : {FindingKind::NotFlattened, FindingKind::FlippedTriangles,
                                   FindingKind::SeamLengths, FindingKind::OutlineCrosses}) {
        EXPECT_TRUE(findingsOf(readiness, kind).empty()) << name(kind);
    }
}

TEST(ReadyToCut, AHalfThatIsNoneIsANote) {
    CutPlan plan = readyPlan();
    plan.settings[1].byHalf = true;
    const Finding found = onlyFinding(plan, FindingKind::NotSymmetric);
    EXPECT_EQ(found.severity, Severity::Note);
    EXPECT_EQ(found.pieces, std::vector<int>{1});
    EXPECT_EQ(found.subject.name, "back");

    // Drawn as its own mirror image it is one: the square's outline from the middle of a side.
    auto drawn = copyOfResult(plan, 1);
    auto line = std::make_shared<FlatLine>();
    line->points.resize(6, 2);
    line->points << 50, 0, 100, 0, 100, 100, 50, 100, 0, 100, 0, 0;
    line->arc = {50, 100, 200, 250, 300, 400, 450};
    drawn->flat->line = line;
    auto outline = std::make_shared<OutlinePlan>();
    outline->mirrored.emplace().isSymmetric = true;
    drawn->plan = outline;
    plan.results[1] = drawn;
    EXPECT_TRUE(readyToCut(plan).findings.empty());
}

}  // namespace
}  // namespace toile
