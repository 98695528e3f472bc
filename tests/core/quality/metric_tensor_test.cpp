// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/metric_tensor.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using std::numbers::pi;

const Eigen::Vector2d kAlongX = Eigen::Vector2d::UnitX(), kAlongY = Eigen::Vector2d::UnitY();

Points2 asSheet(const MeshArrays& mesh) {
    return mesh.V.leftCols(2);
}

Eigen::Vector2d at(double degrees) {
    return {std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)};
}

/// The plane's points moved by a linear map: what a sheet looks like where it is worn.
MeshArrays worn(MeshArrays sheet, const Eigen::Matrix2d& map) {
    sheet.V.leftCols(2) = (sheet.V.leftCols(2) * map.transpose()).eval();
    return sheet;
}

TEST(MetricTensors, NothingIsStretchedWhereTheSheetIsTurnedAndMoved) {
    const MeshArrays sheet = test::planeGrid(5, 4, 7);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    const Points2 Q = ((asSheet(sheet) * turn.transpose()).rowwise() + Eigen::RowVector2d(30, -20));
    for (const MetricTensor& metric : faceMetrics(sheet, Q)) {
        EXPECT_NEAR(metric.E, 1, 1e-12);
        EXPECT_NEAR(metric.F, 0, 1e-12);
        EXPECT_NEAR(metric.G, 1, 1e-12);
        EXPECT_NEAR(symmetricDirichlet(metric), 1, 1e-12);
        EXPECT_NEAR(strainAlong(metric, at(31)), 0, 1e-12);
    }
}

TEST(MetricTensors, AStretchedSheetIsStretchedAlongItsStretchAlone) {
    const MeshArrays sheet = test::planeGrid(4, 3, 10);
    Eigen::Matrix2d map = Eigen::Matrix2d::Identity();
    map(0, 0) = 1.05;
    const auto faces = faceMetrics(worn(sheet, map), asSheet(sheet));
    const auto vertices = vertexMetrics(worn(sheet, map), faces);
    ASSERT_EQ(faces.size(), 24U);
    ASSERT_EQ(vertices.size(), 20U);
    for (const auto& metrics : {faces, vertices}) {
        for (const MetricTensor& metric : metrics) {
            EXPECT_NEAR(strainAlong(metric, kAlongX), 0.05, 1e-12);
            EXPECT_NEAR(strainAlong(metric, kAlongY), 0, 1e-12);
            const double bias = std::sqrt((1.05 * 1.05 + 1) / 2) - 1;
            EXPECT_NEAR(strainAlong(metric, at(45)), bias, 1e-12);
            EXPECT_NEAR(strainAlong(metric, at(-45)), bias, 1e-12);
            const PrincipalStretch stretch = principalStretch(metric);
            EXPECT_NEAR(stretch.largest, 1.05, 1e-12);
            EXPECT_NEAR(stretch.least, 1, 1e-12);
            EXPECT_NEAR(std::abs(stretch.direction.x()), 1, 1e-9);
            EXPECT_NEAR(symmetricDirichlet(metric), (1.1025 + 1 / 1.1025 + 2) / 4, 1e-12);
        }
    }
}

TEST(MetricTensors, AShearStretchesOneDiagonalAndGathersTheOther) {
    const MeshArrays sheet = test::planeGrid(3, 3, 10);
    Eigen::Matrix2d map;
    map << 1, 0.2, 0, 1;
    for (const MetricTensor& metric : faceMetrics(worn(sheet, map), asSheet(sheet))) {
        EXPECT_NEAR(metric.F, 0.2, 1e-12);
        EXPECT_NEAR(strainAlong(metric, kAlongX), 0, 1e-12);
        // By hand: (1, 1) becomes (1.2, 1), and (1, -1) becomes (0.8, -1).
        EXPECT_NEAR(strainAlong(metric, at(45)), std::sqrt((1.44 + 1) / 2) - 1, 1e-12);
        EXPECT_NEAR(strainAlong(metric, at(-45)), std::sqrt((0.64 + 1) / 2) - 1, 1e-12);
        const PrincipalStretch stretch = principalStretch(metric);
        EXPECT_NEAR(stretch.largest * stretch.least, 1, 1e-12) << "a shear keeps the area";
        EXPECT_NEAR(strainAlong(metric, stretch.direction), stretch.largest - 1, 1e-12);
        const Eigen::Vector2d across(-stretch.direction.y(), stretch.direction.x());
        EXPECT_NEAR(strainAlong(metric, across), stretch.least - 1, 1e-12);
    }
}

TEST(MetricTensors, NoDirectionIsStretchedFurtherThanThePrincipalOne) {
    const MeshArrays sheet = test::planeGrid(1, 1, 10);
    Eigen::Matrix2d map;
    map << 1.3, 0.25, -0.4, 0.8;
    const MetricTensor metric = faceMetrics(worn(sheet, map), asSheet(sheet)).front();
    const PrincipalStretch stretch = principalStretch(metric);
    for (int degrees = 0; degrees < 180; ++degrees) {
        EXPECT_LE(strainAlong(metric, at(degrees)), stretch.largest - 1 + 1e-12);
        EXPECT_GE(strainAlong(metric, at(degrees)), stretch.least - 1 - 1e-12);
    }
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(map);
    EXPECT_NEAR(stretch.largest, svd.singularValues()[0], 1e-12);
    EXPECT_NEAR(stretch.least, svd.singularValues()[1], 1e-12);
}

TEST(MetricTensors, ACylinderUnrollsWithoutStretch) {
    constexpr int kColumns = 12;
    constexpr double kAngle = 1.2, kRadius = 100;
    const MeshArrays sector = test::cylinderSector(kColumns, 4, kRadius, kAngle, 80);
    const double chord = 2 * kRadius * std::sin(kAngle / kColumns / 2);
    Points2 Q(sector.V.rows(), 2);
    for (Eigen::Index v = 0; v < Q.rows(); ++v) {
        const double columns = std::atan2(sector.V(v, 0), sector.V(v, 2)) / kAngle * kColumns;
        Q.row(v) << columns * chord, sector.V(v, 1);
    }
    const auto vertices = vertexMetrics(sector, faceMetrics(sector, Q));
    EXPECT_EQ(static_cast<Eigen::Index>(vertices.size()), sector.V.rows());
    for (const MetricTensor& metric : vertices) {
        EXPECT_NEAR(principalStretch(metric).largest, 1, 1e-9);
        EXPECT_NEAR(principalStretch(metric).least, 1, 1e-9);
    }
}

TEST(MetricTensors, AgreesWithTheSingularValuesOfTheMapTheOtherWay) {
    const MeshArrays cap = test::sphericalCap(6, 100, 1.0);
    Points2 Q(cap.V.rows(), 2);
    Q << cap.V.col(2), cap.V.col(0);
    const Eigen::MatrixX2d singular = singularValues(cap, Q);
    const auto faces = faceMetrics(cap, Q);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto row = static_cast<Eigen::Index>(f);
        EXPECT_NEAR(principalStretch(faces[f]).largest, 1 / singular(row, 1), 1e-9);
        EXPECT_NEAR(principalStretch(faces[f]).least, 1 / singular(row, 0), 1e-9);
    }
}

TEST(MetricTensors, VerticesTakeTheMeanByAreaOfWhatIsAroundThem) {
    // Two triangles of area 1 and 3 around the vertices they share.
    MeshArrays mesh;
    mesh.V.resize(4, 3);
    mesh.V << 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, -3, 0;
    mesh.F.resize(2, 3);
    mesh.F << 0, 1, 2, 0, 3, 1;
    const auto mean = vertexMetrics(mesh, {{1, 0, 1}, {1.4, 0.2, 1}});
    EXPECT_NEAR(mean[0].E, (1 + 3 * 1.4) / 4, 1e-12);
    EXPECT_NEAR(mean[0].F, 0.15, 1e-12);
    EXPECT_NEAR(mean[2].E, 1, 1e-12);
    EXPECT_NEAR(mean[3].E, 1.4, 1e-12);
}

TEST(MetricTensors, StaysFiniteWhateverComesIn) {
    MeshArrays mesh;
    mesh.V.resize(4, 3);
    mesh.V << 0, 0, 0, 10, 0, 0, 0, 10, 0, 5, 5, 0;
    mesh.F.resize(2, 3);
    mesh.F << 0, 1, 2, 1, 3, 2;  // the second has no area
    Points2 collapsed(4, 2);
    collapsed << 0, 0, 10, 0, 20, 0, 30, 0;
    Points2 nonsense(4, 2);
    nonsense.setConstant(std::numeric_limits<double>::quiet_NaN());
    Points2 asWorn = asSheet(mesh);
    for (const Points2* Q : {&collapsed, &nonsense, &asWorn}) {
        const auto faces = faceMetrics(mesh, *Q);
        for (const auto& metrics : {faces, vertexMetrics(mesh, faces)}) {
            for (const MetricTensor& metric : metrics) {
                EXPECT_TRUE(std::isfinite(metric.E + metric.F + metric.G));
                const PrincipalStretch stretch = principalStretch(metric);
                EXPECT_LE(stretch.largest, 1.01 * kLargestStretch);
                EXPECT_TRUE(std::isfinite(stretch.least));
                EXPECT_TRUE(std::isfinite(strainAlong(metric, at(20))));
                EXPECT_TRUE(std::isfinite(symmetricDirichlet(metric)));
            }
        }
    }
    EXPECT_NEAR(principalStretch(faceMetrics(mesh, collapsed).front()).least, kLargestStretch, 1);
}

}  // namespace
}  // namespace toile
