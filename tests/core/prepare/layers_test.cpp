// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/layers.h"

#include <algorithm>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/mesh/weld.h"
#include "core/prepare/prepare_file.h"
#include "tests/core/prepare/scan_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// A tube of another radius and height.
MeshArrays ring(double radius, int around = 24, int along = 9, double from = 0) {
    MeshArrays mesh = test::tube(around, along);
    mesh.V.col(0) *= radius / 50;
    mesh.V.col(2) *= radius / 50;
    mesh.V.col(1).array() += from;
    return mesh;
}

/// A sheet of 400 x 400, bent about an upright axis to a quarter of a tube.
MeshArrays bentSheet(double radius) {
    MeshArrays mesh = test::planeGrid(20, 20, 20);
    for (auto point : mesh.V.rowwise()) {
        const double phi = point.x() / 400 * std::numbers::pi / 2;
        point.x() = radius * std::sin(phi);
        point.z() = radius * std::cos(phi);
    }
    return mesh;
}

/// Each mesh a part of one file.
struct LayeredFile {
    FileSurface surface{{Points3(0, 3), Triangles(0, 3)}, {}};
    std::vector<int> firstFace{};

    explicit LayeredFile(const std::vector<MeshArrays>& parts) {
        MeshArrays& mesh = surface.mesh;
        for (const MeshArrays& part : parts) {
            const auto v = mesh.V.rows(), f = mesh.F.rows();
            firstFace.push_back(static_cast<int>(f));
            mesh.V.conservativeResize(v + part.V.rows(), 3);
            mesh.F.conservativeResize(f + part.F.rows(), 3);
            mesh.V.bottomRows(part.V.rows()) = part.V;
            mesh.F.bottomRows(part.F.rows()) = (part.F.array() + static_cast<int>(v)).matrix();
        }
        for (int f = 0; f < mesh.F.rows(); ++f) {
            surface.face.push_back(f);
        }
    }

    /// One per part; empty where there are no layers.
    std::vector<int> layers() const {
        const auto found = findLayers(surface, Progress());
        std::vector<int> layers;
        for (const int f : firstFace) {
            if (found) {
                layers.push_back(found->of[static_cast<std::size_t>(f)]);
            }
        }
        return layers;
    }
};

using Numbers = std::vector<int>;

TEST(Layers, AreCountedFromOutsideWhateverTheOrder) {
    EXPECT_EQ(LayeredFile({ring(50), ring(46)}).layers(), (Numbers{0, 1}));
    EXPECT_EQ(LayeredFile({ring(46), ring(42), ring(50)}).layers(), (Numbers{1, 2, 0}));
    const auto found =
        findLayers(LayeredFile({ring(46, 60), ring(42, 60), ring(50, 60)}).surface, Progress());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->count, 3);
    EXPECT_TRUE(found->isSure);
    EXPECT_NEAR(found->apart, 4, 0.1);
    EXPECT_EQ(found->of.size(), 3U * 60 * 9 * 2);
}

TEST(Layers, AreTheSameHoweverFacesAreTurned) {
    LayeredFile file({ring(46), ring(50)});
    Triangles& F = file.surface.mesh.F;
    for (int f = 0; f < file.firstFace[1]; ++f) {
        std::swap(F(f, 1), F(f, 2));
    }
    EXPECT_EQ(file.layers(), (Numbers{1, 0}));
    for (int f = 0; f < F.rows(); f += 2) {
        std::swap(F(f, 1), F(f, 2));
    }
    EXPECT_EQ(file.layers(), (Numbers{1, 0})) << "each face as it likes";
    file.surface.mesh.V.col(0) *= -1;
    EXPECT_EQ(file.layers(), (Numbers{1, 0})) << "mirrored";
}

TEST(Layers, AreThoseOfPanelsSewnBesideEachOther) {
    // Four panels around, of shell and lining each, that share no vertices.
    std::vector<MeshArrays> panels;
    for (const double radius : {50.0, 47.0}) {
        const MeshArrays whole = ring(radius);
        for (int quarter = 0; quarter < 4; ++quarter) {
            panels.push_back(test::part(whole, [&](const Eigen::RowVector3d& at) {
                return (at.x() > 0) == (quarter % 2 == 0) && (at.z() > 0) == (quarter < 2);
            }));
        }
    }
    EXPECT_EQ(LayeredFile(panels).layers(), (Numbers{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(Layers, WhatLiesOnNoneBelongsToWhatItIsSewnTo) {
    // A longer lining, whose lower part nothing covers; a hem of the shell that covers nothing.
    const MeshArrays below = ring(46, 24, 3, -60), above = ring(50, 24, 3, 180);
    EXPECT_EQ(LayeredFile({below, ring(46), ring(50), above}).layers(), (Numbers{1, 1, 0, 0}));
    const MeshArrays farOff = ring(46, 24, 3, 500);
    EXPECT_EQ(LayeredFile({ring(46), farOff, ring(50)}).layers(), (Numbers{1, 0, 0}));
}

TEST(Layers, AButtonIsNone) {
    const auto button = [](double x) {
        MeshArrays mesh = test::octahedron();
        mesh.V *= 2 / mesh.V.rowwise().norm().maxCoeff();
        mesh.V.rowwise() += Eigen::RowVector3d(x, 90, 0);
        return mesh;
    };
    EXPECT_EQ(LayeredFile({ring(46), button(43), ring(50), button(53)}).layers(),
              (Numbers{1, 1, 0, 0}));
}

TEST(Layers, AreSeenOfBentSheetsAndGuessedOfFlatOnes) {
    const LayeredFile bent({bentSheet(246), bentSheet(250), bentSheet(242)});
    EXPECT_EQ(bent.layers(), (Numbers{1, 0, 2}));
    EXPECT_TRUE(findLayers(bent.surface, Progress())->isSure);
    std::vector<MeshArrays> flat(3, test::planeGrid(12, 12, 40));
    flat[1].V.col(2).array() += 5;
    flat[2].V.col(2).array() += 10;
    EXPECT_EQ(LayeredFile(flat).layers(), (Numbers{0, 1, 2})) << "as the file has them";
    EXPECT_FALSE(findLayers(LayeredFile(flat).surface, Progress())->isSure);
}

TEST(Layers, ArePassedOverWhereThereAreNone) {
    EXPECT_TRUE(LayeredFile({ring(50)}).layers().empty());
    EXPECT_TRUE(LayeredFile({}).layers().empty());
    MeshArrays leg = ring(50);
    leg.V.col(0).array() += 300;
    EXPECT_TRUE(LayeredFile({ring(50), leg}).layers().empty()) << "two legs";
    const MeshArrays pocket = test::part(
        ring(52), [](const Eigen::RowVector3d& at) { return at.z() > 30 && at.y() < 100; });
    EXPECT_TRUE(LayeredFile({ring(50), pocket}).layers().empty()) << "a pocket on it";
    MeshArrays doll = ring(50);
    doll.V *= 0.1;
    MeshArrays other = doll;
    other.V.col(0).array() += 15;
    EXPECT_TRUE(LayeredFile({doll, other}).layers().empty()) << "a doll's legs";
}

TEST(Layers, FacesThatAreThereTwiceAreOfOneLayer) {
    MeshArrays lining = ring(46);
    const Triangles once = lining.F;
    lining.F.resize(2 * once.rows(), 3);
    lining.F << once, once.rowwise().reverse();
    const LayeredFile file({lining, ring(50)});
    EXPECT_EQ(file.layers(), (Numbers{1, 0}));
    const auto found = findLayers(file.surface, Progress());
    EXPECT_EQ(found->of[static_cast<std::size_t>(once.rows()) + 3], 1);
}

/// The same cloth so far inside: along the normals, by which panels stay sewn together.
MeshArrays liningOf(const MeshArrays& mesh, double distance) {
    const std::vector<int> target = findWeld(mesh.F, mesh.V, {.tolerance = 0.01}).target;
    Points3 normals = Points3::Zero(mesh.V.rows(), 3);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (const int v : mesh.F.row(f)) {
            normals.row(target[static_cast<std::size_t>(v)]) +=
                doubleAreaNormal(mesh, f).transpose();
        }
    }
    MeshArrays lining = mesh;
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        lining.V.row(v) -= distance * normals.row(target[static_cast<std::size_t>(v)]).normalized();
    }
    return lining;
}

TEST(Layers, ALiningOfEverySampleIsFound) {
    for (const char* name : {"tshirt", "skirt", "trousers", "bodice"}) {
        Progress progress;
        const auto soup =
            readSoup(test::dataFile(std::string("samples/") + name + ".obj"), progress);
        ASSERT_TRUE(soup) << name;
        const MeshArrays shell = surfaceOf(*soup, 1).mesh;
        const LayeredFile file({liningOf(shell, 4), shell});
        const auto found = findLayers(file.surface, progress);
        ASSERT_TRUE(found) << name;
        EXPECT_TRUE(found->isSure) << name;
        EXPECT_EQ(found->count, 2) << name;
        EXPECT_NEAR(found->apart, 4, 0.1) << name;
        const std::size_t half = found->of.size() / 2;
        const auto wrong = [&](std::size_t first, int layer) {
            const auto begin = found->of.begin() + static_cast<std::ptrdiff_t>(first);
            return std::count_if(begin, begin + static_cast<std::ptrdiff_t>(half),
                                 [layer](int of) { return of != layer; });
        };
        EXPECT_EQ(wrong(0, 1), 0) << name;
        EXPECT_EQ(wrong(half, 0), 0) << name;
    }
}

class ReadLayers : public testing::Test {
protected:
    /// A lining before its shell, in the file.
    std::shared_ptr<const PolygonSoup> soup_ = std::make_shared<const PolygonSoup>(
        test::inCentimetres(LayeredFile({ring(46, 24, 8), ring(50)}).surface.mesh));

    PreparedFile read(const Preparation& preparing) const {
        auto file = prepareFile(soup_, false, preparing, 10, "coat.obj", Progress());
        EXPECT_TRUE(file);
        return std::move(file).value();
    }
};

TEST_F(ReadLayers, RecognisedTheyAreAllThere) {
    const PreparedFile file = read({});
    EXPECT_EQ(file.reading.kind, FileKind::Layers);
    EXPECT_FALSE(file.reading.isStated);
    EXPECT_EQ(file.soup, soup_) << "nothing was done with it";
    EXPECT_EQ(file.reading.layerOfFace.size(), static_cast<std::size_t>(soup_->faceCount()));
    EXPECT_EQ(file.reading.layerOfFace.front(), 1);
    EXPECT_EQ(file.reading.layerOfFace.back(), 0);
    EXPECT_TRUE(file.problems.empty());
    EXPECT_EQ(read({.as = FileKind::Layers}).reading.layerOfFace, file.reading.layerOfFace);
    EXPECT_TRUE(read({.as = FileKind::Sheet}).reading.layerOfFace.empty());
}

TEST_F(ReadLayers, OneAloneIsTakenAndTheOthersAreLeftOut) {
    for (const auto as : {std::optional<FileKind>(), std::optional(FileKind::Layers)}) {
        const PreparedFile lining = read({.as = as, .onlyLayer = 2});
        EXPECT_EQ(lining.soup->faceCount(), 24 * 8 * 2);
        EXPECT_EQ(lining.reading.leftOut.F.rows(), 24 * 9 * 2);
        EXPECT_TRUE(lining.reading.layerOfFace.empty()) << "it is the only one";
        EXPECT_EQ(lining.reading.kind, FileKind::Layers);
        ASSERT_EQ(lining.problems.size(), 1U);
        EXPECT_EQ(lining.problems[0].code, ErrorCode::ReadAs);
        EXPECT_NE(sentence(lining.problems[0]).find("layer 2 from outside"), std::string::npos)
            << sentence(lining.problems[0]);
    }
    EXPECT_EQ(read({.onlyLayer = 1}).soup->faceCount(), 24 * 9 * 2);
}

TEST_F(ReadLayers, WhatIsNotThereIsSaid) {
    const PreparedFile third = read({.as = FileKind::Layers, .onlyLayer = 3});
    EXPECT_EQ(third.soup, soup_);
    ASSERT_EQ(third.problems.size(), 1U);
    EXPECT_EQ(third.problems[0].code, ErrorCode::CannotReadAs);
    EXPECT_NE(third.problems[0].detail.find("the 2 layers"), std::string::npos);
    soup_ = std::make_shared<const PolygonSoup>(test::inCentimetres(ring(50)));
    const PreparedFile tube = read({.as = FileKind::Layers});
    EXPECT_EQ(tube.reading.kind, FileKind::Sheet);
    EXPECT_FALSE(tube.reading.isStated);
    ASSERT_EQ(tube.problems.size(), 1U);
    EXPECT_EQ(tube.problems[0].code, ErrorCode::CannotReadAs);
}

}  // namespace
}  // namespace toile
