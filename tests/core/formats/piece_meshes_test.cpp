// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/mesh/piece_meshes.h"

#include <random>

#include <gtest/gtest.h>

#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/toile/pipeline.h"
#include "tests/core/readers/any_read_back.h"
#include "tests/core/readers/mesh_compare.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

struct Worn {
    Garment garment;
    LineSettings lines = withPattern({});
    PieceResults results;
    LaidOutPattern laid;

    explicit Worn(const std::string& name) {
        Progress progress;
        garment = *loadGarment({test::dataFile(name)}, {}, progress);
        results = flattenGarment(garment, {}, progress, 0, lines);
        laid = inRows(garment, results, lines);
    }
    ExportSource source(const ExportOptions& options = {}) const {
        return {garment, results, laid, options, {}, lines};
    }
};

constexpr FormatId kMeshFormats[] = {FormatId::Obj, FormatId::Usd, FormatId::Glb};

TEST(PieceMeshes, HaveThePatternAtTrueSize) {
    const Worn shirt("samples/tshirt.obj");
    const PieceMeshes meshes = pieceMeshes(shirt.source());
    ASSERT_EQ(meshes.meshes.size(), shirt.garment.pieces.size());
    for (std::size_t p = 0; p < meshes.meshes.size(); ++p) {
        const Points2& Q = shirt.results[p]->flat->Q;
        const Points2& uv = meshes.meshes[p].uv;
        for (Eigen::Index k = 1; k < Q.rows(); ++k) {
            EXPECT_NEAR((uv.row(k) - uv.row(0)).norm(), (Q.row(k) - Q.row(0)).norm(), 1e-9);
        }
    }
    for (const MeshSeam& seam : meshes.seams) {
        for (const auto& vertices : seam.vertices) {
            EXPECT_GE(vertices.size(), 2U) << seam.name;
        }
    }
}

TEST(PieceMeshes, AreTheExactOnesWhereAskedFor) {
    const Worn shirt("samples/tshirt.obj");
    ExportOptions exact;
    exact.mesh.isExact = true;
    const PieceMeshes drawn = pieceMeshes(shirt.source()),
                      solved = pieceMeshes(shirt.source(exact));
    double change = 0;
    for (std::size_t p = 0; p < drawn.meshes.size(); ++p) {
        change = std::max(change, (drawn.meshes[p].uv - solved.meshes[p].uv).cwiseAbs().maxCoeff());
        const Points2& Q = exactOf(*shirt.results[p]).flat->Q;
        const Points2& uv = solved.meshes[p].uv;
        EXPECT_NEAR((uv.row(1) - uv.row(0)).norm(), (Q.row(1) - Q.row(0)).norm(), 1e-9);
    }
    EXPECT_GT(change, 0.01);
}

TEST(PieceMeshes, AreReadBackFromEveryFormat) {
    for (const char* name : {"samples/tshirt.obj", "samples/bodice.obj", "samples/trousers.obj",
                             "garments/polo.obj", "garments/suit_mh.obj"}) {
        const auto path = test::dataFile(name);
        if (!std::filesystem::exists(path)) {
            continue;  // of the shared ones
        }
        const Worn worn(name);
        for (const bool isExact : {false, true}) {
            ExportOptions options;
            options.mesh.isExact = isExact;
            const ExportSource source = worn.source(options);
            for (const FormatId id : kMeshFormats) {
                const Format& format = formatOf(id);
                const auto files = format.write(source);
                ASSERT_TRUE(files);
                const auto found = test::readBack(format, *files, source);
                ASSERT_TRUE(found) << name << ' ' << format.name << ": " << found.error().detail;
                EXPECT_LT(found->largest, 1e-3) << name << ' ' << format.name;
                EXPECT_EQ(files->front().bytes, (*format.write(source)).front().bytes);
            }
        }
    }
}

/// Single floats have a tenth of a millimetre there.
TEST(PieceMeshes, OneKilometreAwayIsReadBackToo) {
    const Worn shirt("samples/tshirt.obj");
    PieceMeshes meshes = pieceMeshes(shirt.source());
    for (PieceMesh& mesh : meshes.meshes) {
        mesh.V.array() += 1e6;
        mesh.uv.array() += 1e6;
    }
    const auto found = comparedWithMeshes(*readGlb(writeGlb(meshes, "")), meshes);
    EXPECT_TRUE(found) << sentence(found.error());
}

/// One figure is changed: by much more than rounding, in the middle of the file.
TEST(PieceMeshes, AreNotReadBackFromChangedFiles) {
    const Worn shirt("samples/tshirt.obj");
    const ExportSource source = shirt.source();
    const PieceMeshes meshes = pieceMeshes(source);
    PieceMeshes moved = meshes;
    moved.meshes[1].uv(3, 0) += 0.05;
    EXPECT_FALSE(comparedWithMeshes(*readGlb(writeGlb(moved, "")), meshes));
    EXPECT_FALSE(comparedWithMeshes(*readUsda(writeUsda(moved, "")), meshes));
    moved = meshes;
    moved.meshes[0].V(2, 1) += 0.05;
    EXPECT_FALSE(comparedWithMeshes(*readGlb(writeGlb(moved, "")), meshes));
    EXPECT_FALSE(comparedWithMeshes(*readUsda(writeUsda(moved, "")), meshes));
    moved = meshes;
    std::swap(moved.meshes[0].F(0, 0), moved.meshes[0].F(0, 1));
    EXPECT_FALSE(comparedWithMeshes(*readGlb(writeGlb(moved, "")), meshes));
    moved = meshes;
    moved.seams.front().vertices[1].pop_back();
    EXPECT_FALSE(comparedWithMeshes(*readUsda(writeUsda(moved, "")), meshes));
    std::string obj = formatOf(FormatId::Obj).write(source)->front().bytes;
    EXPECT_TRUE(comparedWithObj(obj, source));
    const std::size_t digit = obj.find("\nvt ") + 4;
    obj[digit] = obj[digit] == '9' ? '8' : '9';
    EXPECT_FALSE(comparedWithObj(obj, source));
}

TEST(PieceMeshes, ReadersSurviveAnyBytes) {
    const Worn shirt("samples/cap.obj");
    const PieceMeshes meshes = pieceMeshes(shirt.source());
    std::mt19937 random(5);  // NOLINT: the same bytes each time
    for (const std::string& file : {writeGlb(meshes, "a"), writeUsda(meshes, "a")}) {
        for (int k = 0; k < 500; ++k) {
            std::string bytes = file;
            for (int change = 0; change < 3; ++change) {
                bytes[random() % std::min<std::size_t>(bytes.size(), 4000)] =
                    static_cast<char>(random());
            }
            bytes.resize(k % 3 == 0 ? random() % bytes.size() : bytes.size());
            (void)readGlb(bytes);
            (void)readUsda(bytes);
        }
    }
}

TEST(PieceMeshes, EachPieceIsAFileOfItsOwn) {
    const Worn shirt("samples/tshirt.obj");
    ExportOptions options;
    options.mesh.eachPiece = true;
    const test::TemporaryFolder folder;
    const auto written = exportFile(folder / "shirt.obj", shirt.source(options));
    ASSERT_TRUE(written);
    ASSERT_EQ(written->files.size(), shirt.garment.pieces.size() + 1);
    for (std::size_t p = 0; p < shirt.garment.pieces.size(); ++p) {
        Progress progress;
        const auto again =
            loadGarment({written->files[p + 1]}, {.unit = shirt.garment.files[0]->unit}, progress);
        ASSERT_TRUE(again);
        ASSERT_EQ(again->pieces.size(), 1U);
        const MeshArrays& mesh = again->pieces[0]->mesh;
        EXPECT_EQ(mesh.F, shirt.garment.pieces[p]->mesh.F);
        EXPECT_LT((mesh.V - shirt.garment.pieces[p]->mesh.V).cwiseAbs().maxCoeff(), 1e-9);
    }
}

}  // namespace
}  // namespace toile
