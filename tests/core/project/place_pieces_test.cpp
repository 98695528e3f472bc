// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/place_pieces.h"

#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/layout/free_place.h"
#include "core/project/piece_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Box = Eigen::AlignedBox2d;

Garment panels(const std::vector<MeshArrays>& meshes) {
    Garment garment;
    for (MeshArrays mesh : meshes) {
        mesh.V.col(0).array() += 1000.0 * static_cast<double>(garment.pieces.size());
        auto piece = std::make_shared<Piece>(*test::originalPiece(std::move(mesh)));
        piece->name = "piece " + std::to_string(garment.pieces.size() + 1);
        piece->file = static_cast<int>(garment.pieces.size());
        test::identify(*piece, 1 + garment.pieces.size());
        garment.pieces.push_back(std::move(piece));
    }
    garment.uncut = garment.pieces;
    return garment;
}

PieceResults flat(const Garment& garment, Method method = Method::Isometric) {
    Progress progress;
    return flattenGarment(garment, {method}, progress);
}

std::vector<PieceSettings> placed(const Garment& garment, const PieceResults& results,
                                  std::vector<PieceSettings> settings,
                                  const PieceResults& before = {}) {
    settings.resize(garment.pieces.size());
    settings = placedSettings(std::move(settings), results, flatMotions(before, results));
    for (PieceSettings& piece : settings) {
        piece.flat = 0;  // tests of their own ask for it
    }
    return settings;
}

Points2 onSheet(const PieceResult& result, const PieceSettings& settings) {
    Points2 points = result.flat->Q;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        points.row(i) = settings.placement->applied(points.row(i).transpose()).transpose();
    }
    return points;
}

Box boxOf(const PieceResult& result, const PieceSettings& settings) {
    Box box;
    const Points2 points = onSheet(result, settings);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        box.extend(points.row(i).transpose());
    }
    return box;
}

/// The result with its own coordinates turned and moved: what another way to the same shape gives.
std::shared_ptr<const PieceResult> turned(const PieceResult& result, double turn,
                                          const Eigen::Vector2d& shift) {
    auto other = std::make_shared<PieceResult>(result);
    other->flat->Q = Placement{shift, turn}.appliedToRows(result.flat->Q);
    return other;
}

TEST(PlacePieces, TheFirstTimeAllLieInRows) {
    const Garment garment = panels({test::planeGrid(4, 4, 50), test::planeGrid(2, 6, 30)});
    const PieceResults results = flat(garment);
    const auto settings = placed(garment, results, {});
    const Marker rows = inRows(garment, results).marker;
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(settings[i].placement, rows.copies[i].placement);
    }
}

TEST(PlacePieces, APieceStaysWhereItIsWhenItIsFlattenedAnew) {
    const Garment garment = panels({test::sphericalCap(8, 90, 1.0)});
    const PieceResults before = flat(garment);
    for (const bool mirrored : {false, true}) {
        std::vector<PieceSettings> settings(1);
        settings[0].placement = Placement{{40, 70}, 1.2, mirrored};
        settings[0].grain = 0.3;
        const PieceResults after{turned(*before[0], 2.1, {300, -5})};
        const auto now = placed(garment, after, settings, before);
        EXPECT_LT((onSheet(*before[0], settings[0]) - onSheet(*after[0], now[0])).norm(), 1e-6);
        EXPECT_NEAR(std::remainder(*now[0].grain - (0.3 + 2.1), 2 * M_PI), 0, 1e-9);
    }
}

TEST(PlacePieces, AnotherMethodsShapeLiesAsNearAsItCan) {
    const Garment garment = panels({test::sphericalCap(8, 90, 1.0)});
    const PieceResults before = flat(garment), after = flat(garment, Method::Lscm);
    const auto settings = placed(garment, before, {});
    const auto now = placed(garment, after, settings, before);
    const Eigen::RowVector2d moved =
        (onSheet(*after[0], now[0]) - onSheet(*before[0], settings[0])).colwise().mean();
    EXPECT_LT(moved.norm(), 1e-6);
}

TEST(PlacePieces, NothingChangesWhereTheResultsAreTheSame) {
    const Garment garment = panels({test::planeGrid(4, 4, 50), test::planeGrid(2, 6, 30)});
    const PieceResults results = flat(garment);
    const auto settings = placed(garment, results, {});
    EXPECT_EQ(placed(garment, results, settings, results), settings);
    // Flattened again to the same coordinates by another result.
    EXPECT_EQ(placed(garment, flat(garment), settings, results), settings);
}

TEST(PlacePieces, WhatWasSaidOfTheseVeryFlatPointsStays) {
    const Garment garment = panels({test::planeGrid(4, 4, 50)});
    const PieceResults isometric = flat(garment), natural = flat(garment, Method::Natural);
    ASSERT_NE(isometric[0]->fingerprint, 0U);
    auto turned = std::make_shared<PieceResult>(*natural[0]);
    const Eigen::Rotation2Dd turn(0.5);
    turned->flat->Q = (natural[0]->flat->Q * turn.toRotationMatrix().transpose()).eval();
    turned->fingerprint = 1;
    PieceSettings said;
    said.placement = Placement{{30, 40}, 0.3};
    said.grain = 0.2;
    said.flat = isometric[0]->fingerprint;
    said.anchors = {{0, {1, 2}}, {4, {3, 4}}};  // of who knows what
    auto now = placedSettings({said}, isometric, flatMotions({turned}, isometric));
    said.anchors.clear();
    EXPECT_EQ(now[0], said);
    // About other points than those that were shown before: nobody can tell how they lay.
    now = placedSettings({said}, {turned}, flatMotions(natural, {turned}));
    EXPECT_EQ(now[0].placement, said.placement);
    EXPECT_EQ(now[0].flat, 1U);
    // About those: it goes along.
    now = placedSettings({said}, {turned}, flatMotions(isometric, {turned}));
    EXPECT_NEAR(now[0].placement->turn, 0.3 - 0.5, 1e-6);
}

TEST(PlacePieces, NewPiecesLieBesideAllOthers) {
    const Garment garment =
        panels({test::planeGrid(4, 4, 50), test::planeGrid(4, 2, 50), test::planeGrid(2, 6, 30),
                test::planeGrid(9, 3, 40), test::planeGrid(3, 3, 20), test::planeGrid(5, 1, 20)});
    const PieceResults results = flat(garment);
    std::vector<PieceSettings> settings(6);
    settings[1].placement = Placement{{-300, 50}, 0.8, true};
    settings[4].placement = Placement{{100, 600}, 0.1};
    const auto now = placed(garment, results, settings);
    EXPECT_EQ(now[1], settings[1]);
    EXPECT_EQ(now[4], settings[4]);
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Box common = boxOf(*results[i], now[i]).intersection(boxOf(*results[k], now[k]));
            EXPECT_TRUE(common.isEmpty()) << i << " and " << k;
        }
    }
}

/// The garment with one cut through it.
Garment cutBy(const Garment& garment, UserCut cut) {
    LoadOptions options;
    options.seams.unit = LengthUnit::Millimetre;
    options.seams.cuts = {std::move(cut)};
    Progress progress;
    auto made = cutGarment(garment, options, progress);
    return made ? *std::move(made) : Garment{};
}

std::vector<Points2> outlines(const PieceResults& results,
                              const std::vector<PieceSettings>& settings) {
    std::vector<Points2> lines;
    for (std::size_t i = 0; i < results.size(); ++i) {
        lines.emplace_back(
            onSheet(*results[i], settings[i])(results[i]->piece->boundary, Eigen::all));
    }
    return lines;
}

/// How far a part lies at most from where it lay in the whole, by source vertex.
double awayFrom(const PieceResult& whole, const PieceSettings& wholeSettings,
                const PieceResult& part, const PieceSettings& settings) {
    const Points2 then = onSheet(whole, wholeSettings), now = onSheet(part, settings);
    std::map<int, Eigen::Index> rowOf;
    for (std::size_t v = 0; v < whole.piece->sourceVertex.size(); ++v) {
        rowOf[whole.piece->sourceVertex[v]] = static_cast<Eigen::Index>(v);
    }
    double most = 0;
    for (std::size_t v = 0; v < part.piece->sourceVertex.size(); ++v) {
        if (const auto old = rowOf.find(part.piece->sourceVertex[v]);
            old != rowOf.end() && old->first >= 0) {
            const Eigen::RowVector2d way =
                now.row(static_cast<Eigen::Index>(v)) - then.row(old->second);
            most = std::max(most, way.norm());
        }
    }
    return most;
}

/// Of the vertices that both outlines have, how far they lie from where they lay: mean square.
double outlineRms(const PieceResult& whole, const PieceSettings& wholeSettings,
                  const PieceResult& part, const PieceSettings& settings) {
    const Points2 then = onSheet(whole, wholeSettings), now = onSheet(part, settings);
    std::map<int, Eigen::Index> rowOf;
    for (const int v : whole.piece->boundary) {
        rowOf[whole.piece->sourceVertex[static_cast<std::size_t>(v)]] = v;
    }
    double sum = 0, count = 0;
    for (const int v : part.piece->boundary) {
        const auto old = rowOf.find(part.piece->sourceVertex[static_cast<std::size_t>(v)]);
        if (old != rowOf.end() && old->first >= 0) {
            sum += (now.row(v) - then.row(old->second)).squaredNorm();
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::infinity();
}

double outlineArea(const PieceResult& result) {
    double area = 0;
    const Points2 line = result.flat->Q(result.piece->boundary, Eigen::all);
    for (Eigen::Index i = 0, k = line.rows() - 1; i < line.rows(); k = i++) {
        area += 0.5 * (line(k, 0) * line(i, 1) - line(i, 0) * line(k, 1));
    }
    return area;
}

TEST(PlacePieces, TheLargestPartOfACutPieceStaysAndTheOthersGoToFreePlaces) {
    // A plane lies between two others; it is cut in two, slantwise, or gets a hole.
    const Garment garment = panels(
        {test::planeGrid(12, 12, 25), test::planeGrid(12, 12, 25), test::planeGrid(12, 12, 25)});
    const PieceResults results = flat(garment);
    auto settings = placed(garment, results, {});
    for (std::size_t i = 0; i < 3; ++i) {
        settings[i].placement = Placement{{310.0 * static_cast<double>(i), 0}};
    }
    const Points3& V = garment.pieces[1]->mesh.V;
    const Eigen::Vector3d low = V.colwise().minCoeff().transpose();
    const Eigen::Vector3d size = V.colwise().maxCoeff().transpose() - low;
    const auto at = [&](double x, double y) -> Eigen::Vector3d {
        return low + Eigen::Vector3d(x * size.x(), y * size.y(), 0);
    };
    const std::vector<UserCut> cuts{
        {"halves", UserCut::Kind::Path, {at(0.4, 0), at(0.4, 1)}, false},
        {"slant", UserCut::Kind::Path, {at(0.3, 0), at(0.6, 1)}, false},
        {"corner", UserCut::Kind::Path, {at(0, 0.3), at(0.3, 0)}, false},
        {"patch", UserCut::Kind::Loop, {at(0.4, 0.3), at(0.6, 0.3), at(0.5, 0.5)}, false}};
    for (const UserCut& cut : cuts) {
        for (const double turn : {0.0, 0.7}) {
            settings[1].placement->turn = turn;
            const Garment made = cutBy(garment, cut);
            ASSERT_EQ(made.pieces.size(), 4U) << cut.name;
            const PieceResults parts = flat(made);
            const auto now =
                placed(made, parts,
                       carriedSettings(carriedFrom(garment, settings, results, made), settings));
            EXPECT_EQ(now[0], settings[0]);
            EXPECT_EQ(now[3], settings[2]);
            const std::size_t large = outlineArea(*parts[1]) > outlineArea(*parts[2]) ? 1 : 2;
            EXPECT_LT(awayFrom(*results[1], settings[1], *parts[large], now[large]), 1) << cut.name;
            if (turn == 0) {
                EXPECT_TRUE(overlappingOutlines(outlines(parts, now)).empty()) << cut.name;
                const auto whole = boxOf(*results[1], settings[1]);
                EXPECT_LT(awayFrom(*results[1], settings[1], *parts[3 - large], now[3 - large]),
                          1.2 * whole.diagonal().norm())
                    << cut.name;
            }
        }
    }
}

TEST(PlacePieces, PiecesLaidInOnePlaceAreNoPartsOfOne) {
    const Garment garment = panels({test::planeGrid(10, 10, 20), test::planeGrid(8, 8, 20)});
    const PieceResults results = flat(garment);
    std::vector<PieceSettings> settings(2);
    for (std::size_t i = 0; i < 2; ++i) {
        settings[i].placement = Placement{{40, 70}, 0.3};
        settings[i].placedByHand = true;
        settings[i].anchors = outlineAnchors(garment.pieces[i]->boundary, results[i]->flat->Q);
    }
    for (const PieceSettings& piece : placed(garment, results, settings)) {
        EXPECT_EQ(piece.placement, settings[0].placement);
    }
}

class PlacedGarments : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(PlacedGarments, StayWhereTheyAreWhenAPatchIsCutOut) {
    const auto path = test::dataFile(GetParam().first);
    TOILE_NEEDS_SHARED(path);
    Progress progress;
    const auto garment = loadGarment({path}, {}, progress);
    ASSERT_TRUE(garment);
    const PieceResults results = flat(*garment);
    const auto settings = placed(*garment, results, {});
    const std::size_t which = GetParam().second;
    const Points3& V = garment->pieces[which]->mesh.V;
    const Eigen::RowVector3d mean = V.colwise().mean();
    Eigen::Index nearest = 0;
    (V.rowwise() - mean).rowwise().squaredNorm().minCoeff(&nearest);
    const Eigen::Vector3d middle = V.row(nearest).transpose();
    // A patch in the middle, and a dart from below.
    const Eigen::Vector3d left(-40, -20, 0), right(40, -20, 0), up(0, 40, 0);
    for (const UserCut& cut :
         {UserCut{"patch", UserCut::Kind::Loop, {middle + left, middle + right, middle + up}},
          UserCut{"dart", UserCut::Kind::Dart, {middle - 5 * up, middle}}}) {
        const Garment made = cutBy(*garment, cut);
        ASSERT_FALSE(made.pieces.empty());
        const PieceResults parts = flat(made);
        const auto now = placed(
            made, parts, carriedSettings(carriedFrom(*garment, settings, results, made), settings));
        EXPECT_TRUE(overlappingOutlines(outlines(parts, now)).empty()) << cut.name;
        if (cut.kind == UserCut::Kind::Loop) {
            ASSERT_EQ(now.size(), settings.size() + 1);
            const bool first = outlineArea(*parts[which]) > outlineArea(*parts[which + 1]);
            const std::size_t large = first ? which : which + 1;
            EXPECT_LT(outlineRms(*results[which], settings[which], *parts[large], now[large]), 1);
        } else {
            EXPECT_EQ(now[which].placement->turn, 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, PlacedGarments,
                         testing::Values(std::pair("samples/tshirt.obj", 0),
                                         std::pair("samples/tshirt.obj", 1)));
INSTANTIATE_TEST_SUITE_P(Shared, PlacedGarments,
                         testing::Values(std::pair("garments/tee_sim.obj", 4)));

TEST(PlacePieces, APieceThatGrowsPushesOnlyThoseWithoutASetPlace) {
    const Garment garment = panels({test::planeGrid(10, 10, 20), test::planeGrid(8, 8, 20)});
    PieceResults before = flat(garment);
    std::vector<PieceSettings> settings(2);
    settings[0].placement = Placement{{0, 0}};
    settings[1].placement = Placement{{203, 10}};
    auto grown = std::make_shared<PieceResult>(*before[0]);
    grown->flat->Q.col(0) *= 1.1;  // 20 mm more, 10 mm of them to the right
    const PieceResults after{grown, before[1]};
    for (const bool firstByHand : {false, true}) {
        for (const bool secondByHand : {false, true}) {
            settings[0].placedByHand = firstByHand;
            settings[1].placedByHand = secondByHand;
            const auto now = placed(garment, after, settings, before);
            const bool apart = overlappingOutlines(outlines(after, now)).empty();
            EXPECT_EQ(apart, !firstByHand || !secondByHand);
            EXPECT_EQ(now[1] == settings[1], secondByHand);
            // By the shift of its middle alone, unless it has to make room itself.
            const Eigen::Vector2d middle =
                boxOf(*after[0], now[0]).center() - boxOf(*before[0], settings[0]).center();
            EXPECT_EQ(middle.norm() < 1e-6, firstByHand || !secondByHand);
            EXPECT_LT(middle.norm(), 40);
        }
    }
}

TEST(PlacePieces, PiecesThatLieOnEachOtherOnPurposeStayWhereNothingGrows) {
    const Garment garment = panels({test::planeGrid(10, 10, 20), test::planeGrid(8, 8, 20)});
    const PieceResults results = flat(garment);
    std::vector<PieceSettings> settings(2);
    settings[0].placement = Placement{{0, 0}};
    settings[1].placement = Placement{{50, 10}};
    EXPECT_EQ(placed(garment, flat(garment), settings, results), settings);
}

TEST(PlacePieces, UnturnedPiecesStayUprightByAnotherMethod) {
    const Garment garment =
        panels({test::sphericalCap(8, 90, 1.0), test::sphericalCap(6, 70, 0.8)});
    const PieceResults before = flat(garment), after = flat(garment, Method::Lscm);
    const auto settings = placed(garment, before, {});
    const auto now = placed(garment, after, settings, before);
    EXPECT_EQ(now.size(), 2U);
    for (const PieceSettings& piece : now) {
        EXPECT_EQ(piece.placement->turn, 0);
        EXPECT_FALSE(piece.grain);
    }
}

TEST(PlacePieces, TheSheetGrowsWithAGarmentReadInAnotherUnit) {
    const std::vector<MeshArrays> meshes{test::sphericalCap(8, 90, 1.0), test::planeGrid(4, 2, 50)};
    const Garment garment = panels(meshes);
    const PieceResults before = flat(garment);
    auto settings = placed(garment, before, {});
    settings[1].placement->mirrored = true;
    Garment larger = garment;
    for (auto& piece : larger.pieces) {
        MeshArrays mesh = piece->mesh;
        mesh.V *= 10;
        auto grown = std::make_shared<Piece>(*test::originalPiece(std::move(mesh)));
        grown->name = piece->name;
        grown->file = piece->file;
        test::identify(*grown, piece->id.value);
        piece = grown;
    }
    const auto carried = carriedSettings(carriedFrom(garment, settings, before, larger), settings);
    const PieceResults after = flat(larger);
    const auto now = placed(larger, after, carried);
    for (std::size_t i = 0; i < 2; ++i) {
        const Points2 wanted = 10 * onSheet(*before[i], settings[i]);
        EXPECT_LT((onSheet(*after[i], now[i]) - wanted).cwiseAbs().maxCoeff(), 2) << i;
    }
}

TEST(PlacePieces, APieceThatCouldNotBeFlattenedKeepsWhatIsKnownOfIt) {
    const Garment garment = panels({test::planeGrid(4, 4, 50)});
    std::vector<PieceSettings> settings(1);
    settings[0].placement = Placement{{1, 2}, 3};
    settings[0].anchors = {{0, {0, 0}}, {1, {1, 0}}};
    auto failed = std::make_shared<PieceResult>();
    failed->piece = garment.pieces[0];
    failed->error = Error{ErrorCode::NotFinite};
    EXPECT_EQ(placedSettings(settings, {failed}, {std::nullopt}), settings);
}

TEST(PlacePieces, NoneOfTheFirstRowsIsWiderThanAClothInIt) {
    const Garment garment = panels(std::vector<MeshArrays>(9, test::planeGrid(4, 4, 50)));
    PieceResults results = flat(garment);
    const MaterialList materials{{"Lining", {"unstated", {}, {}, {}, 300}}};
    const Fabric own{"unstated", {}, {}, {}, 800};
    auto leftOut = std::make_shared<PieceResult>(*results[0]);
    leftOut->flat.reset();
    results[0] = leftOut;  // its cloth is no limit
    std::vector<PieceSettings> settings(9);
    settings[0].material = settings[8].material = "Lining";
    settings = placedSettings(settings, results, flatMotions({}, results), nullptr, materials, own);
    EXPECT_FALSE(settings[0].placement);
    std::vector<Box> boxes;
    Box all;
    for (std::size_t i = 1; i < 9; ++i) {
        boxes.push_back(outlineBox(placedOutline(results[i]->flat->Q, results[i]->piece->boundary,
                                                 settings[i].placement.value()),
                                   {}));
        all.extend(boxes.back());
    }
    EXPECT_LE(all.sizes().x(), 800);
    EXPECT_GT(all.sizes().x(), 500);
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_GT(boxes[i].min().y(), boxes[7].max().y()) << i;  // no other is in that row
    }
}

TEST(PlacePieces, PiecesWithAllowancesAreAsLargeAsTheyAreCut) {
    const Garment garment =
        panels({test::planeGrid(4, 4, 50), test::planeGrid(6, 4, 50), test::planeGrid(4, 4, 50)});
    const PieceResults results = flat(garment);
    const Pattern pattern = makePattern(garment, results, {.allowance = AllowanceWidths{45, 45}});
    std::vector<PieceSettings> lying(3);
    lying[0].placement = Placement{{7, 5}, 0.3, true};
    for (std::vector<PieceSettings> settings : {std::vector<PieceSettings>(3), lying}) {
        settings = placedSettings(settings, results, flatMotions({}, results), &pattern);
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < 3; ++i) {
            boxes.push_back(
                outlineBox(pattern.pieces[i].cuttingLine, settings[i].placement.value()));
            EXPECT_GT(boxes[i].sizes().minCoeff(), 280);
            for (std::size_t k = 0; k < i; ++k) {
                EXPECT_GT(boxes[i].exteriorDistance(boxes[k]), 10) << i << k;
            }
        }
    }
}

}  // namespace
}  // namespace toile
