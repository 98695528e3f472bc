// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/garment_flattener.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

using PiecePointer = std::shared_ptr<const Piece>;

/// Pieces of one file, side by side, that know their faces there.
Garment garmentOfMeshes(const std::vector<MeshArrays>& meshes, std::uint64_t firstId = 1) {
    Garment garment;
    int vertices = 0;
    int faces = 0;
    for (MeshArrays mesh : meshes) {
        mesh.V.col(0).array() += 1000.0 * static_cast<double>(garment.pieces.size());
        auto piece = std::make_shared<Piece>(*test::originalPiece(std::move(mesh)));
        piece->name = "piece " + std::to_string(garment.pieces.size() + 1);
        for (int& v : piece->sourceVertex) {
            v += vertices;
        }
        for (int& f : piece->sourceFace) {
            f += faces;
        }
        vertices += static_cast<int>(piece->mesh.V.rows());
        faces += static_cast<int>(piece->mesh.F.rows());
        test::identify(*piece, firstId + garment.pieces.size());
        garment.pieces.push_back(std::move(piece));
    }
    garment.uncut = garment.pieces;
    return garment;
}

Garment fourPieces() {
    return garmentOfMeshes({test::bentPanel(30), test::sphericalCap(12, 90, 1.2),
                            test::saddle(16, 200, 1.2), test::bentPanel(12)});
}

/// The garment with a cut across the first piece, as far as `end` (mm): over the whole of it the
/// piece comes apart.
Garment withCut(const Garment& garment, double at, double end) {
    LoadOptions options;
    UserCut cut;
    cut.name = "cut";
    cut.points = {{at, 0, 0}, {at, end, 0}};
    options.seams.unit = LengthUnit::Millimetre;
    options.seams.cuts = {cut};
    Progress progress;
    auto cutOpen = cutGarment(garment, options, progress);
    EXPECT_TRUE(cutOpen);
    return *cutOpen;
}

PieceResults flat(GarmentFlattener& flattener, const Garment& garment, Method method,
                  int threads = 0) {
    Progress progress;
    PieceResults results = flattener.flatten(garment, {method}, progress, threads);
    EXPECT_EQ(progress.fraction(), 1);
    return results;
}

/// Garments as somebody would edit them, one after the other.
std::vector<Garment> history() {
    const Garment whole = fourPieces();
    return {whole,
            withCut(whole, 150, 100),
            withCut(whole, 150, 160),
            withCut(whole, 101, 160),
            withCut(whole, 101, 300),
            whole};
}

void expectNear(const PieceResults& results, const PieceResults& cold) {
    ASSERT_EQ(results.size(), cold.size());
    for (std::size_t k = 0; k < cold.size(); ++k) {
        SCOPED_TRACE(cold[k]->piece->name);
        ASSERT_EQ(results[k]->piece, cold[k]->piece);
        ASSERT_TRUE(cold[k]->flat);
        ASSERT_TRUE(results[k]->flat);
        // A cap that is round has no way up: rounding turns it.
        EXPECT_LE(test::distanceAfterRigidMotion(results[k]->flat->Q, cold[k]->flat->Q), 1e-7);
    }
}

TEST(GarmentFlattener, GivesWhatAColdSolveGivesThroughoutTheEdits) {
    GarmentFlattener flattener;
    for (const Garment& garment : history()) {
        SCOPED_TRACE(garment.pieces.size());
        for (const Method method : {Method::Curvature, Method::Wang2005}) {
            Progress progress;
            expectNear(flat(flattener, garment, method),
                       flattenGarment(garment, {method}, progress));
        }
    }
}

TEST(GarmentFlattener, LeavesUnchangedPiecesAlone) {
    GarmentFlattener flattener;
    const Garment whole = fourPieces();
    const PieceResults first = flat(flattener, whole, Method::Curvature);
    EXPECT_EQ(flat(flattener, whole, Method::Curvature), first);
    const Garment cut = withCut(whole, 150, 160);
    ASSERT_EQ(cut.pieces.size(), whole.pieces.size());
    const PieceResults second = flat(flattener, cut, Method::Curvature);
    EXPECT_NE(second[0], first[0]);
    for (std::size_t k = 1; k < first.size(); ++k) {
        EXPECT_EQ(second[k], first[k]);
    }
    EXPECT_NE(flat(flattener, cut, Method::Wang2005)[1], second[1]);
}

TEST(GarmentFlattener, KnowsAPieceThatIsReadAgain) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("two.obj",
                                   "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n"
                                   "o right\nv 2 0 0\nv 2 1 1\nf 2 5 6 4\n");
    Progress progress;
    LoadOptions options;
    options.seams.cuts = {{"across", UserCut::Kind::Path, {{0, 0.5, 0}, {1, 0.5, 0}}}};
    const auto first = loadGarment({path}, options, progress);
    ASSERT_TRUE(first);
    const auto again = makeGarment({*readFiles({path}, progress), options}, progress, {}, &*first);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->pieces, first->pieces);  // pointers
    EXPECT_EQ(again->pieces.size(), 3U);
    GarmentFlattener flattener;
    const PieceResults before = flat(flattener, *first, Method::Isometric);
    EXPECT_EQ(flat(flattener, *again, Method::Isometric), before);  // nothing was solved
}

TEST(GarmentFlattener, GivesTheSameBytesWithOneThreadAndWithMany) {
    const std::vector<Garment> edits = history();
    for (const Method method : {Method::Curvature, Method::Isometric}) {
        std::vector<PieceResults> expected;
        for (const int threads : {1, 2, 5}) {
            GarmentFlattener flattener;
            for (std::size_t e = 0; e < edits.size(); ++e) {
                SCOPED_TRACE(std::to_string(threads) + " threads, edit " + std::to_string(e));
                const PieceResults results = flat(flattener, edits[e], method, threads);
                if (threads == 1) {
                    expected.push_back(results);
                }
                ASSERT_EQ(results.size(), expected[e].size());
                for (std::size_t k = 0; k < results.size(); ++k) {
                    ASSERT_TRUE(results[k]->flat);
                    EXPECT_TRUE(
                        (results[k]->flat->Q.array() == expected[e][k]->flat->Q.array()).all());
                }
            }
        }
    }
}

TEST(GarmentFlattener, IsAsGoodAsBeforeAfterACancel) {
    const Garment whole = garmentOfMeshes({test::bentPanel(250), test::bentPanel(20)});
    const Garment cut = withCut(whole, 150, 160);
    for (const int milliseconds : {0, 5, 40, 100}) {
        GarmentFlattener flattener;
        const PieceResults first = flat(flattener, whole, Method::Curvature);
        Progress progress;
        std::thread other([&progress, milliseconds] {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            progress.cancel();
        });
        const PieceResults cancelled = flattener.flatten(cut, {Method::Isometric}, progress);
        other.join();
        for (const auto& result : cancelled) {
            EXPECT_TRUE(result->flat || result->error->code == ErrorCode::Cancelled);
        }
        Progress fresh;
        expectNear(flat(flattener, cut, Method::Curvature),
                   flattenGarment(cut, {Method::Curvature}, fresh));
    }
}

void expectSame(const PieceResults& results, const PieceResults& others) {
    ASSERT_EQ(results.size(), others.size());
    for (std::size_t k = 0; k < results.size(); ++k) {
        SCOPED_TRACE(results[k]->piece->name);
        ASSERT_TRUE(results[k]->flat);
        ASSERT_TRUE(others[k]->flat);
        EXPECT_TRUE((results[k]->flat->Q.array() == others[k]->flat->Q.array()).all());
    }
}

TEST(GarmentFlattener, KeepsNoMoreThanItMay) {
    GarmentFlattener none(0);
    for (const Garment& garment : history()) {
        Progress progress;
        expectSame(flat(none, garment, Method::Isometric),
                   flattenGarment(garment, {Method::Isometric}, progress));
        EXPECT_EQ(none.keptBytes(), 0U);
    }
    // The second piece alone fits, since the first is larger.
    const Garment whole = fourPieces();
    const std::size_t second = PieceFlattener::expectedBytes(*whole.pieces[1]);
    ASSERT_LT(second, PieceFlattener::expectedBytes(*whole.pieces[0]));
    GarmentFlattener one(second);
    GarmentFlattener all;
    const PieceResults first = flat(one, whole, Method::Isometric);
    expectSame(first, flat(all, whole, Method::Isometric));
    EXPECT_GT(one.keptBytes(), 0U);
    EXPECT_LT(one.keptBytes(), all.keptBytes());
    EXPECT_EQ(flat(one, whole, Method::Isometric), first);
}

TEST(GarmentFlattener, TakesNothingFromAnotherFile) {
    MeshArrays other = test::bentPanel(20);
    other.V.col(2) *= 1.1;  // the same triangles, nearly the same place
    const Garment first = garmentOfMeshes({test::bentPanel(20), test::bentPanel(12)}, 1);
    const Garment second = garmentOfMeshes({other, test::bentPanel(12)}, 11);
    GarmentFlattener flattener;
    const PieceResults before = flat(flattener, first, Method::Isometric);
    const PieceResults after = flat(flattener, second, Method::Isometric);
    Progress progress;
    expectSame(after, flattenGarment(second, {Method::Isometric}, progress));
    EXPECT_NE(after[1]->seconds, before[1]->seconds);  // solved again, though it is the same
    // An edit of the same file goes on from what was.
    Garment edited = garmentOfMeshes({test::bentPanel(20)}, 11);
    edited.pieces.push_back(second.pieces[1]);
    EXPECT_EQ(flat(flattener, edited, Method::Isometric)[1], after[1]);
}

TEST(GarmentFlattener, TellsOfEveryPieceThatItSolves) {
    GarmentFlattener flattener;
    std::vector<std::string> begun;
    std::vector<int> done;
    const auto note = [&](int flat, int count, const Piece& piece) {
        EXPECT_LT(flat, count);
        begun.push_back(piece.name);
        done.push_back(flat);
    };
    const Garment whole = fourPieces();
    Progress progress;
    flattener.flatten(whole, {Method::Curvature}, progress, 0, {}, {}, note);
    EXPECT_TRUE(std::ranges::is_sorted(done));
    std::ranges::sort(begun);
    EXPECT_EQ(begun, (std::vector<std::string>{"piece 1", "piece 2", "piece 3", "piece 4"}));
    begun.clear();
    flattener.flatten(whole, {Method::Curvature}, progress, 0, {}, {}, note);
    EXPECT_TRUE(begun.empty());
}

TEST(GarmentFlattener, TakesWhatCannotBeFlattened) {
    GarmentFlattener flattener;
    const Garment garment = garmentOfMeshes({test::tube(12, 4), test::bentPanel(5)});
    const PieceResults results = flat(flattener, garment, Method::Curvature);
    EXPECT_TRUE(results[0]->error);
    EXPECT_TRUE(results[1]->flat);
    EXPECT_EQ(flat(flattener, garment, Method::Curvature), results);
    EXPECT_TRUE(flat(flattener, Garment{}, Method::Curvature).empty());
}

/// An energy that reads the cloth, for tests: the isotropic one, which takes note of what it gets.
const isometric::EnergyKind kReadsCloth{
    "reads-cloth", true,
    [](const MeshArrays& mesh, const EdgeTable& table,
       const PieceCloth& cloth) -> std::unique_ptr<isometric::FlatEnergy> {
        EXPECT_TRUE(cloth.warp.rows() <= mesh.V.rows());
        if (cloth.warp.rows() > 0) {
            // In this test the warp runs along x everywhere, on coarse meshes too.
            for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
                const Eigen::Vector3d warp = warpIn(cloth, mesh, f);
                EXPECT_TRUE(warp.isZero() || std::abs(warp.z()) + std::abs(warp.y()) < 1);
            }
        }
        return std::make_unique<isometric::SymmetricDirichlet>(mesh, table);
    }};

PieceCloths clothsOf(const Garment& garment, const Eigen::RowVector3d& warp,
                     std::string_view fabric) {
    PieceCloths cloths;
    for (const auto& piece : garment.pieces) {
        PieceCloth cloth;
        cloth.warp = warp.replicate(piece->mesh.V.rows(), 1);
        cloth.fabric = *fabricPreset(fabric);
        cloths.push_back(std::make_shared<const PieceCloth>(std::move(cloth)));
    }
    return cloths;
}

TEST(GarmentFlattener, SolvesAgainForOtherClothOnlyIfTheEnergyReadsIt) {
    const Garment garment = fourPieces();
    const Eigen::RowVector3d along(1, 0, 0), other(0.9, 0.1, 0);
    for (const bool reads : {false, true}) {
        GarmentFlattener flattener;
        FlattenOptions options;
        if (reads) {
            options.energy = &kReadsCloth;
        }
        const auto flattened = [&](const PieceCloths& cloths) {
            Progress progress;
            return flattener.flatten(garment, options, progress, 0, {}, {}, {}, cloths);
        };
        const PieceResults first = flattened(clothsOf(garment, along, "woven"));
        EXPECT_EQ(flattened(clothsOf(garment, along, "woven")), first);  // equal cloth
        const PieceResults turned = flattened(clothsOf(garment, other, "woven"));
        const PieceResults denim = flattened(clothsOf(garment, other, "denim"));
        for (std::size_t p = 0; p < first.size(); ++p) {
            EXPECT_EQ(turned[p] == first[p], !reads);
            EXPECT_EQ(denim[p] == turned[p], !reads);
            ASSERT_TRUE(denim[p]->flat);
            // This energy is the isotropic one, solved cold: no memory of other cloth is used.
            EXPECT_FALSE(denim[p]->flat->warm);
            EXPECT_EQ(denim[p]->fingerprint, first[p]->fingerprint);
        }
        Progress progress;
        const PieceResults settled = flattener.settle(garment, denim, progress);
        EXPECT_EQ(settled, denim);
    }
}

}  // namespace
}  // namespace toile
