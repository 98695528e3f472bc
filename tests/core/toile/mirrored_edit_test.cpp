// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts and directions of one side of a garment, carried over to the other.
#include "core/pattern/mirrored_edit.h"

#include <cmath>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

#include "core/assemble/file_space.h"
#include "core/pattern/fair_outline.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"
#include "tests/core/toile/mirror_images.h"

namespace toile {
namespace {

using CutKind = UserCut::Kind;

constexpr double kSamePoint = 1e-6;  // mm

/// A garment, flat, and its symmetry.
struct FlatGarment {
    Garment garment;
    Symmetry symmetry{};
    PieceResults results{};

    std::optional<UserCut> image(const UserCut& cut) const {
        return mirroredCut(garment, results, symmetry, cut);
    }
};

FlatGarment flattened(Garment garment, Mirror mirror) {
    FlatGarment flat{std::move(garment)};
    FlattenOptions options;
    options.method = Method::Curvature;
    LineSettings lines;
    lines.mirror = mirror;
    Progress progress;
    auto symmetry = findSymmetry(flat.garment);
    EXPECT_TRUE(symmetry);
    flat.symmetry = symmetry.value_or(Symmetry{});
    flat.results = flattenGarment(flat.garment, options, progress, 0, lines);
    return flat;
}

Eigen::Vector3d onCloth(const Piece& piece, const Eigen::Vector3d& p) {
    return positionOf(piece.mesh, NearestSurface(piece.mesh).find(p));
}

/// On the outline, a share of its edges on from its first vertex, within an edge.
Eigen::Vector3d onOutline(const Piece& piece, double share) {
    const auto n = static_cast<double>(piece.boundary.size());
    const auto k = static_cast<std::size_t>(share * n);
    const Eigen::Vector3d a = piece.mesh.V.row(piece.boundary[k]);
    const Eigen::Vector3d b = piece.mesh.V.row(piece.boundary[(k + 1) % piece.boundary.size()]);
    return 0.7 * a + 0.3 * b;
}

/// Part of the way from there to the middle of the piece.
Eigen::Vector3d inside(const Piece& piece, double share, double part) {
    const Eigen::Vector3d middle = piece.mesh.V.colwise().mean();
    const Eigen::Vector3d rim = onOutline(piece, share);
    return onCloth(piece, rim + part * (middle - rim));
}

UserCut dartIn(const Piece& piece, double share) {
    return {"dart", CutKind::Dart, {onOutline(piece, share), inside(piece, share, 0.5)}};
}

std::vector<UserCut> cutsIn(const Piece& piece) {
    UserCut along{"along", CutKind::Path, {onOutline(piece, 0.4), inside(piece, 0.4, 0.8)}};
    along.alongEdges = true;
    return {dartIn(piece, 0.15),
            {"path",
             CutKind::Path,
             {onOutline(piece, 0.1), inside(piece, 0.3, 0.7), onOutline(piece, 0.6)}},
            {"loop",
             CutKind::Loop,
             {inside(piece, 0.1, 0.4), inside(piece, 0.3, 0.5), inside(piece, 0.45, 0.6)}},
            along};
}

void expectSamePoints(const UserCut& cut, const std::vector<Eigen::Vector3d>& wanted) {
    ASSERT_EQ(cut.points.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_LT((cut.points[i] - wanted[i]).norm(), kSamePoint) << i;
    }
}

void expectAsDrawn(const UserCut& image, const UserCut& cut) {
    EXPECT_EQ(image.kind, cut.kind);
    EXPECT_EQ(image.alongEdges, cut.alongEdges);
    EXPECT_TRUE(image.name.empty());
    EXPECT_FALSE(image.id);
}

std::vector<Eigen::Vector3d> reflected(const MirrorPlane& plane, const UserCut& cut) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& p : cut.points) {
        points.push_back(plane.reflected(p));
    }
    return points;
}

class MirroredEditOfSample : public testing::TestWithParam<const char*> {};

TEST_P(MirroredEditOfSample, ACutIsReflected) {
    for (const Mirror mirror : {Mirror::None, Mirror::Mean}) {
        const FlatGarment flat = flattened(test::garmentOf(GetParam()), mirror);
        for (const auto& piece : flat.garment.pieces) {
            if (piece->name.find("band") != std::string::npos) {
                continue;  // its triangles are no mirror images
            }
            for (const UserCut& cut : cutsIn(*piece)) {
                SCOPED_TRACE(piece->name + ", " + cut.name);
                const auto image = flat.image(cut);
                ASSERT_TRUE(image);
                expectAsDrawn(*image, cut);
                expectSamePoints(*image, reflected(flat.symmetry.plane, cut));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, MirroredEditOfSample,
                         testing::Values("samples/tshirt.obj", "samples/skirt.obj"));

TEST(MirroredEdit, ImageOfTheImageIsTheCut) {
    const FlatGarment flat = flattened(test::tube4(test::draped), Mirror::None);
    for (const auto& piece : flat.garment.pieces) {
        for (const UserCut& cut : cutsIn(*piece)) {
            SCOPED_TRACE(piece->name + ", " + cut.name);
            const auto image = flat.image(cut);
            ASSERT_TRUE(image);
            const auto back = flat.image(*image);
            ASSERT_TRUE(back);
            expectSamePoints(*back, cut.points);
        }
    }
}

TEST(MirroredEdit, NoneOfACutThatMirrorsItself) {
    const FlatGarment flat = flattened(test::garmentOf("samples/tshirt.obj"), Mirror::None);
    const Piece& front = *flat.garment.pieces[0];
    const auto at = [&](double x, double y) { return onCloth(front, {x, y, 150}); };
    EXPECT_FALSE(flat.image({"centre", CutKind::Path, {at(0, 810), at(0, 1200)}}));
    EXPECT_FALSE(flat.image({"dart", CutKind::Dart, {at(0, 790), at(0, 900)}}));
    EXPECT_FALSE(flat.image({"across", CutKind::Path, {at(-90, 1000), at(90, 1000)}}));
    EXPECT_FALSE(
        flat.image({"uneven", CutKind::Path, {at(90, 1000), at(20, 1000), at(-90, 1000)}}));
    EXPECT_FALSE(flat.image({"loop", CutKind::Loop, {at(0, 950), at(60, 1000), at(-60, 1000)}}));
    EXPECT_TRUE(flat.image({"half", CutKind::Path, {at(0, 1000), at(90, 1000)}}));
    EXPECT_TRUE(flat.image({"slanting", CutKind::Path, {at(-90, 1000), at(90, 1050)}}));
}

TEST(MirroredEdit, NoneWithoutCounterpartOrFlatPieces) {
    FlatGarment flat = flattened(test::tube4(), Mirror::None);
    const UserCut cut = dartIn(*flat.garment.pieces[1], 0.15);
    EXPECT_TRUE(flat.image(cut));
    EXPECT_FALSE(flat.image({"nowhere", CutKind::Path, {}}));
    EXPECT_FALSE(flat.image({"far", CutKind::Dart, {{0, 1e5, 0}, {0, 1e5, 9}}}));
    const PieceResults results = flat.results;
    flat.results[3] = nullptr;
    EXPECT_FALSE(flat.image(cut));
    EXPECT_FALSE(mirroredDirection(flat.garment, flat.results, flat.symmetry, 1, 0));
    flat.results = results;
    flat.symmetry.pieces.counterpart[1] = -1;
    EXPECT_FALSE(flat.image(cut));
    EXPECT_FALSE(mirroredDirection(flat.garment, flat.results, flat.symmetry, 1, 0));
    EXPECT_FALSE(mirroredDirection(flat.garment, flat.results, flat.symmetry, 0, 0));  // its own
}

TEST(MirroredEdit, NoneOnceCancelled) {
    const FlatGarment flat = flattened(test::tube4(), Mirror::None);
    const UserCut cut = dartIn(*flat.garment.pieces[1], 0.15);
    Progress progress;
    EXPECT_TRUE(mirroredCut(flat.garment, flat.results, flat.symmetry, cut, progress));
    progress.cancel();
    EXPECT_FALSE(mirroredCut(flat.garment, flat.results, flat.symmetry, cut, progress));
}

TEST(MirroredEdit, DirectionsFollowTheFlatPieces) {
    const FlatGarment flat = flattened(test::garmentOf("samples/skirt.obj"), Mirror::None);
    const int left = 1, right = flat.symmetry.pieces.counterpart[left];
    const PieceResult &here = *flat.results[left], &there = *flat.results[right];
    const auto flatAt = [](const PieceResult& result, const Eigen::Vector3d& p) {
        const MeshArrays& mesh = result.piece->mesh;
        return flatPositionOf(result.flat->Q, mesh.F, NearestSurface(mesh).find(p));
    };
    const Eigen::Vector3d a = inside(*here.piece, 0.1, 0.3), b = inside(*here.piece, 0.6, 0.2);
    const MirrorPlane& plane = flat.symmetry.plane;
    const Eigen::RowVector2d from = flatAt(here, b) - flatAt(here, a);
    const Eigen::RowVector2d to =
        flatAt(there, plane.reflected(b)) - flatAt(there, plane.reflected(a));
    const auto direction = mirroredDirection(flat.garment, flat.results, flat.symmetry, left,
                                             std::atan2(from.y(), from.x()));
    ASSERT_TRUE(direction);
    EXPECT_NEAR(std::remainder(*direction - std::atan2(to.y(), to.x()), 2 * M_PI), 0, 1e-8);
    const auto back =
        mirroredDirection(flat.garment, flat.results, flat.symmetry, right, *direction);
    ASSERT_TRUE(back);
    EXPECT_NEAR(*back, std::atan2(from.y(), from.x()), 1e-9);
}

Result<Garment> withCuts(const Garment& garment, std::vector<UserCut> cuts);

/// The pieces as a file would have them: its vertices and faces are theirs.
Garment withSources(Garment garment) {
    for (auto& piece : garment.pieces) {
        auto copy = std::make_shared<Piece>(*piece);
        copy->sourceVertex.resize(static_cast<std::size_t>(copy->mesh.V.rows()));
        copy->sourceFace.resize(static_cast<std::size_t>(copy->mesh.F.rows()));
        std::iota(copy->sourceVertex.begin(), copy->sourceVertex.end(), 0);
        std::iota(copy->sourceFace.begin(), copy->sourceFace.end(), 0);
        piece = copy;
    }
    garment.uncut = garment.pieces;
    garment.files = {std::make_shared<SourceFile>()};
    return garment;
}

TEST(MirroredEdit, NoneBesideACutThatIsThereAlready) {
    // The front is cut open from its hem on the right; now the same cut is drawn on the left.
    const FlatGarment flat = flattened(withSources(test::tube4()), Mirror::None);
    const auto upwards = [&flat](double x) -> UserCut {
        const Piece& front = *flat.garment.pieces.front();
        const auto at = [&](double y) { return onCloth(front, {x, y, 400}); };
        return {"upwards", CutKind::Path, {at(-1), at(100), at(200)}};
    };
    ASSERT_TRUE(flat.image(upwards(-60)));
    auto made = withCuts(flat.garment, {upwards(60)});
    ASSERT_TRUE(made);
    ASSERT_EQ(made->pieces.size(), 4U);
    const FlatGarment cut = flattened(std::move(*made), Mirror::None);
    EXPECT_FALSE(cut.image(upwards(-60)));
    EXPECT_TRUE(cut.image(upwards(-30)));
}

struct Dart {
    const char* garment;
    int piece;
    double share;  ///< of its outline, where the dart begins
};

class MirroredDart : public testing::TestWithParam<Dart> {};

bool allCorrespond(const Symmetry& symmetry, std::size_t piece) {
    return std::ranges::none_of(symmetry.pairs[piece], [](int pair) { return pair < 0; });
}

Result<Garment> withCuts(const Garment& garment, std::vector<UserCut> cuts) {
    LoadOptions options;
    for (UserCut& cut : cuts) {
        for (Eigen::Vector3d& point : cut.points) {
            point = inFileSpace(point, options.seams, garment);
        }
    }
    options.seams.cuts = std::move(cuts);
    Progress progress;
    return cutGarment(garment, options, progress);
}

TEST_P(MirroredDart, LeavesThePiecesMirrorImages) {
    const auto [file, index, share] = GetParam();
    TOILE_NEEDS_SHARED(test::dataFile(file));
    const FlatGarment flat = flattened(test::garmentOf(file), Mirror::Mean);
    const auto piece = static_cast<std::size_t>(index);
    const UserCut cut = dartIn(*flat.garment.pieces[piece], share);
    const auto image = flat.image(cut);
    ASSERT_TRUE(image);
    const auto back = flat.image(*image);
    ASSERT_TRUE(back);
    expectSamePoints(*back, cut.points);

    auto made = withCuts(flat.garment, {cut, *image});
    ASSERT_TRUE(made);
    EXPECT_EQ(made->cuts.size(), 2U);
    const FlatGarment after = flattened(std::move(*made), Mirror::Mean);
    EXPECT_EQ(after.symmetry.plane.normal, flat.symmetry.plane.normal);
    EXPECT_EQ(after.symmetry.plane.offset, flat.symmetry.plane.offset);
    EXPECT_EQ(after.symmetry.pieces.counterpart, flat.symmetry.pieces.counterpart);
    EXPECT_TRUE(allCorrespond(after.symmetry, piece));
    EXPECT_EQ(test::areMirrored(after.results), test::areMirrored(flat.results));
    EXPECT_TRUE(test::areMirrored(after.results)[piece]);
    test::expectMirrorImages(after.garment, after.symmetry, after.results);
    test::expectLengths(after.garment, after.results);
}

INSTANTIATE_TEST_SUITE_P(Garments, MirroredDart,
                         testing::Values(Dart{"samples/tshirt.obj", 2, 0.1},     // a sleeve
                                         Dart{"garments/tee_sim.obj", 0, 0.15},  // half of one
                                         Dart{"garments/tee_sim.obj", 4, 0.3},   // a body
                                         Dart{"garments/dress.obj", 10, 0.4},
                                         Dart{"garments/dress.obj", 6, 0.3}));

}  // namespace
}  // namespace toile
