// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/orientation.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/prepare/file_surface.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Way = ClothSide::Way;

/// The mesh of a file that has z up: as if it was modelled there.
MeshArrays withZUp(MeshArrays mesh) {
    for (auto row : mesh.V.rowwise()) {
        row = Eigen::RowVector3d(row.x(), -row.z(), row.y());
    }
    return mesh;
}

MeshArrays insideOut(MeshArrays mesh) {
    mesh.F.col(1).swap(mesh.F.col(2));
    return mesh;
}

/// A tube with a bottom: a cup, a beanie upside down.
MeshArrays cup() {
    MeshArrays mesh = test::tube(24, 6);
    const auto bottom = static_cast<int>(mesh.V.rows());
    mesh.V.conservativeResize(bottom + 1, 3);
    mesh.V.row(bottom).setZero();
    const Eigen::Index faces = mesh.F.rows();
    mesh.F.conservativeResize(faces + 24, 3);
    for (int k = 0; k < 24; ++k) {
        mesh.F.row(faces + k) << bottom, (k + 1) % 24, k;
    }
    return mesh;
}

/// A skirt of 700 mm that is round and wider below than above: nothing but its openings tells how
/// it stands.
MeshArrays skirt() {
    MeshArrays mesh = test::tube(36, 10);
    for (auto row : mesh.V.rowwise()) {
        const double widening = 5 - row.y() / 100;
        row = Eigen::RowVector3d(widening * row.x(), 3.5 * row.y(), widening * row.z());
    }
    return mesh;
}

TEST(Orientation, OpeningsOneAboveTheOtherTellTheUpAxis) {
    for (const MeshArrays& mesh : {test::tube(24, 4), test::tube(24, 9), skirt()}) {
        const UpGuess y = guessUpAxis(mesh), z = guessUpAxis(withZUp(mesh));
        EXPECT_EQ(y.axis, UpAxis::Y);
        EXPECT_EQ(z.axis, UpAxis::Z);
        EXPECT_FALSE(y.inDoubt || z.inDoubt) << y.reason << z.reason;
        EXPECT_NE(z.reason.find("openings"), std::string::npos) << z.reason;
    }
}

TEST(Orientation, OpeningsThatDoNotTellLeaveADoubt) {
    MeshArrays across = test::tube(24, 9);
    across.V.col(0).swap(across.V.col(1));
    EXPECT_TRUE(guessUpAxis(across).inDoubt);
    EXPECT_TRUE(guessUpAxis(withZUp(cup())).inDoubt);
    EXPECT_FALSE(guessUpAxis(cup()).inDoubt);

    MeshArrays slanted = test::tube(24, 9);
    const Eigen::AngleAxisd turn(std::numbers::pi / 4, Eigen::Vector3d::UnitX());
    slanted.V = (slanted.V * turn.toRotationMatrix().transpose()).eval();
    EXPECT_TRUE(guessUpAxis(slanted).inDoubt);
}

TEST(Orientation, AHoleInASheetIsNoOpening) {
    MeshArrays holed = test::part(test::bentPanel(24), [](const Eigen::RowVector3d& middle) {
        return (middle.head<2>().array() - 300).matrix().norm() > 80;
    });
    holed.V.col(2) *= 0.5;
    const UpGuess guess = guessUpAxis(holed);
    EXPECT_EQ(guess.axis, UpAxis::Y);
    EXPECT_FALSE(guess.inDoubt) << guess.reason;
}

TEST(Orientation, WithoutOpeningsTheExtentsTell) {
    for (const MeshArrays& mesh : {test::planeGrid(6, 9, 50), withZUp(test::planeGrid(6, 9, 50)),
                                   test::octahedron(), test::bentPanel(8)}) {
        const Eigen::Vector3d extents = mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff();
        const UpGuess seen = guessUpAxis(mesh), known = guessUpAxis(extents);
        EXPECT_EQ(seen.axis, known.axis);
        EXPECT_EQ(seen.inDoubt, known.inDoubt);
        EXPECT_EQ(seen.reason, known.reason);
    }
}

TEST(Orientation, NothingToSeeIsNoTrouble) {
    const MeshArrays none{Points3(0, 3), Triangles(0, 3)};
    EXPECT_EQ(guessUpAxis(none).axis, UpAxis::Y);
    EXPECT_EQ(sideOfFaces(none).way, Way::Unknown);
    MeshArrays flat = test::planeGrid(1, 1, 10);
    flat.V.setZero();
    EXPECT_EQ(sideOfFaces(flat).way, Way::Unknown);
}

TEST(Orientation, FacesOfWhatIsWornLookOutwardsOrInwards) {
    for (const MeshArrays& mesh : {test::tube(24, 9), cup(), skirt(), test::octahedron()}) {
        EXPECT_EQ(sideOfFaces(mesh).way, Way::Outwards) << sideOfFaces(mesh).evidence;
        EXPECT_EQ(sideOfFaces(insideOut(mesh)).way, Way::Inwards);
        EXPECT_NE(sideOfFaces(insideOut(mesh)).evidence.find("100 %"), std::string::npos);
    }
}

TEST(Orientation, PartsThatLookInwardsAreNamedByTheirShare) {
    MeshArrays half = skirt();
    for (Eigen::Index f = 0; f < half.F.rows(); ++f) {  // its back, apart from the front
        if (half.V.row(half.F(f, 0)).z() + half.V.row(half.F(f, 1)).z() < 0) {
            std::swap(half.F(f, 1), half.F(f, 2));
        }
    }
    const ClothSide side = sideOfFaces(half);
    EXPECT_EQ(side.way, Way::Inwards);
    EXPECT_EQ(side.evidence.find("100 %"), std::string::npos) << side.evidence;
}

TEST(Orientation, AnOpenSheetHasNoInside) {
    for (const MeshArrays& mesh : {test::planeGrid(6, 6, 50), test::bentPanel(8)}) {
        EXPECT_EQ(sideOfFaces(mesh).way, Way::Unknown);
        EXPECT_EQ(sideOfFaces(insideOut(mesh)).way, Way::Unknown);
    }
}

/// The tube as a file.
GarmentInputs asInputs(const MeshArrays& mesh, const LoadOptions& options) {
    PolygonSoup soup;
    for (const auto& row : mesh.V.rowwise()) {
        soup.positions.push_back(row.transpose());
    }
    for (const auto& row : mesh.F.rowwise()) {
        soup.corners.insert(soup.corners.end(), {row[0], row[1], row[2]});
        soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
    }
    return {{{"tube.obj", std::make_shared<const PolygonSoup>(std::move(soup))}}, options};
}

TEST(Orientation, TurnedOverAnInsideOutGarmentIsAsItIsWorn) {
    Progress progress;
    const MeshArrays tube = test::tube(24, 9);
    const auto right = makeGarment(asInputs(tube, {}), progress);
    const auto wrong = makeGarment(asInputs(insideOut(tube), {}), progress);
    const auto turned =
        makeGarment(asInputs(insideOut(tube), {.preparing = {.isTurned = true}}), progress);
    ASSERT_TRUE(right && wrong && turned);
    EXPECT_EQ(right->files[0]->side.way, Way::Outwards);
    EXPECT_EQ(wrong->files[0]->side.way, Way::Inwards);
    EXPECT_EQ(turned->files[0]->side.way, Way::Outwards);
    for (Eigen::Index f = 0; f < tube.F.rows(); ++f) {
        EXPECT_GT(doubleAreaNormal(right->pieces[0]->mesh, f)
                      .dot(doubleAreaNormal(turned->pieces[0]->mesh, f)),
                  0);
    }
}

TEST(Orientation, AStatedAxisDecides) {
    Progress progress;
    const MeshArrays lying = withZUp(test::tube(24, 9));
    EXPECT_EQ(makeGarment(asInputs(lying, {}), progress)->files[0]->up, UpAxis::Z);
    EXPECT_EQ(makeGarment(asInputs(lying, {.up = UpAxis::Y}), progress)->files[0]->up, UpAxis::Y);
    GarmentInputs stating = asInputs(lying, {});
    auto soup = std::make_shared<PolygonSoup>(*stating.files[0].soup);
    soup->statedUp = StatedUp{UpAxis::Y, "stated"};
    stating.files[0].soup = soup;
    const auto garment = makeGarment(stating, progress);
    EXPECT_EQ(garment->files[0]->up, UpAxis::Y);
    EXPECT_EQ(garment->files[0]->upReason, "stated");
    EXPECT_FALSE(garment->files[0]->upInDoubt);
}

TEST(Orientation, RealGarmentsAreReadAsTheyAreWorn) {
    for (const std::string name :
         {"dress.obj", "dress14_pieces.obj", "elegant_mh.obj", "leggings.ply", "longsleeve.obj",
          "polo.obj", "polo_pieces.obj", "skirt_clo.obj", "suit_mh.obj", "tee_sim.obj",
          "tee_sim_pieces.obj", "tshirt.obj", "wetsuit_patches.obj"}) {
        const auto file = test::sharedFile("garments/" + name);
        TOILE_NEEDS_SHARED(file);
        Progress progress;
        const auto soup = readSoup(file, progress);
        ASSERT_TRUE(soup);
        MeshArrays mesh = surfaceOf(*soup, 1).mesh;
        mesh.F = weldedFaces(mesh);
        const ClothSide side = sideOfFaces(mesh);
        const bool isMixed = name == "skirt_clo.obj";  // its back looks to the body
        EXPECT_EQ(side.way, isMixed ? Way::Inwards : Way::Outwards) << name << side.evidence;
        EXPECT_EQ(guessUpAxis(mesh).axis, UpAxis::Y) << name;
        EXPECT_FALSE(guessUpAxis(mesh).inDoubt) << name << ": " << guessUpAxis(mesh).reason;
        EXPECT_EQ(guessUpAxis(withZUp(mesh)).axis, UpAxis::Z) << name;
    }
}

}  // namespace
}  // namespace toile
