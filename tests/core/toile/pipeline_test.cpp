// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/pipeline.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "core/assemble/slits.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/project/place_pieces.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 300 0 0\nv 0 400 0\no flap\nf 1 2 3\n";

Garment load(const std::vector<std::filesystem::path>& paths,
             std::optional<LengthUnit> unit = LengthUnit::Millimetre) {
    Progress progress;
    auto garment = loadGarment(paths, {unit}, progress);
    EXPECT_TRUE(garment) << (garment ? "" : sentence(garment.error()));
    return garment ? *garment : Garment{};
}

TEST(Pipeline, SeveralFilesBecomeOneGarmentWithPrefixedNames) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "other");
    const Garment garment =
        load({folder.write("left.obj", kTriangle), folder.write("right.obj", kTriangle),
              folder.write("other/left.obj", kTriangle)});
    ASSERT_EQ(garment.pieces.size(), 3U);
    EXPECT_EQ(garment.pieces[0]->name, "left/flap");
    EXPECT_EQ(garment.pieces[1]->name, "right/flap");
    EXPECT_EQ(garment.pieces[2]->name, "left 2/flap");
    EXPECT_EQ(garment.pieces[2]->file, 2);
}

TEST(Pipeline, GuessesTheUnitWithAReasonAndAsksWhereInDoubt) {
    const test::TemporaryFolder folder;
    const Garment sure =
        load({folder.write("a.obj", "v 0 0 0\nv 1.2 0 0\nv 0 1 0\nf 1 2 3\n")}, std::nullopt);
    EXPECT_EQ(sure.files[0]->unit, LengthUnit::Metre);
    EXPECT_FALSE(sure.files[0]->unitReason.empty());
    EXPECT_TRUE(sure.files[0]->problems.empty());
    const Garment doubt =
        load({folder.write("b.obj", "v 0 0 0\nv 200 0 0\nv 0 9 0\nf 1 2 3\n")}, std::nullopt);
    ASSERT_EQ(doubt.files[0]->problems.size(), 1U);
    EXPECT_EQ(doubt.files[0]->problems[0].code, ErrorCode::UnitGuessed);
    const Garment stated = load({folder / "b.obj"}, LengthUnit::Inch);
    EXPECT_TRUE(stated.files[0]->problems.empty());
    EXPECT_NEAR(stated.pieces[0]->mesh.V.maxCoeff(), 200 * 25.4, 1e-9);
}

TEST(Pipeline, WritesTinySizesWithTheirDigits) {
    const test::TemporaryFolder folder;
    for (const auto& [size, text] :
         {std::pair("0.000001937", "a garment of 0.0019 mm"), std::pair("0.0312", "of 31 mm"),
          std::pair("1e-20", "of 1.00e-17 mm")}) {
        const std::string mesh =
            std::string("v 0 0 0\nv ") + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n";
        const Garment garment = load({folder.write("a.obj", "# Units: m\n" + mesh)}, std::nullopt);
        ASSERT_FALSE(garment.files[0]->problems.empty());
        const std::string said = sentence(garment.files[0]->problems[0]);
        EXPECT_NE(said.find(text), std::string::npos) << said;
    }
}

TEST(Pipeline, DoubtsASizeThatNoGarmentHasUntilTheUserStatesTheUnit) {
    const test::TemporaryFolder folder;
    const struct {
        const char* name;
        double metres;
        bool isUsual;
    } table[] = {{"shirt.obj", 0.41, true},   {"shirt.obj", 2.3, true},
                 {"shirt.obj", 2.6, false},   {"shirt.obj", 0.09, false},
                 {"hat.obj", 0.3, true},      {"fedora_1.obj", 2.6, false},
                 {"dress.obj", 0.41, false},  {"my tent.obj", 2.5, true},
                 {"my tent.obj", 0.3, false}, {"that chat.obj", 2, true}};
    for (const auto& row : table) {
        SCOPED_TRACE(std::string(row.name) + " " + std::to_string(row.metres));
        const std::string size = std::to_string(row.metres);
        const std::string mesh = "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n";
        for (const char* stated : {"", "# Units: m\n"}) {
            const Garment garment = load({folder.write(row.name, stated + mesh)}, std::nullopt);
            const SourceFile& file = *garment.files[0];
            ASSERT_EQ(file.unit, LengthUnit::Metre);
            ASSERT_EQ(file.problems.empty(), row.isUsual);
            EXPECT_EQ(file.unitInDoubt, !row.isUsual && *stated == '\0');
            EXPECT_TRUE(row.isUsual || file.problems[0].code == ErrorCode::UnitGuessed);
        }
        EXPECT_TRUE(load({folder / row.name}, LengthUnit::Metre).files[0]->problems.empty());
    }
}

TEST(Pipeline, TellsWhichFileCannotBeRead) {
    const test::TemporaryFolder folder;
    Progress progress;
    const auto garment =
        loadGarment({folder.write("a.obj", kTriangle), folder / "no.obj"}, {}, progress);
    ASSERT_FALSE(garment);
    EXPECT_EQ(garment.error().code, ErrorCode::FileUnreadable);
    EXPECT_NE(garment.error().subject.name.find("no.obj"), std::string::npos);
}

TEST(Pipeline, ReadingLeavesRoomForJoinsCutsAndSeams) {
    const test::TemporaryFolder folder;
    Progress progress;
    // Read to its end, and nothing to cut or to sew.
    EXPECT_EQ(
        loadGarment({folder.write("none.obj", "v 0 0 0\nv 1 0 0\n")}, {}, progress).error().code,
        ErrorCode::NoGeometry);
    EXPECT_LT(progress.fraction(), 0.9);
    const Garment garment = load({test::sourceFile("resources/samples/tshirt.obj")});
    ASSERT_TRUE(loadGarment({test::sourceFile("resources/samples/tshirt.obj")},
                            {LengthUnit::Millimetre}, progress));
    EXPECT_NEAR(progress.fraction(), 1, 1e-9);
    LoadOptions options;
    options.seams.cuts = {{"across", UserCut::Kind::Path, {{-100, 1200, 0}, {100, 1200, 0}}}};
    for (const double from : {0.0, 0.5}) {
        Progress cutting;
        cutting.setShare(from, from + 0.5);
        ASSERT_TRUE(cutGarment(garment, options, cutting));
        EXPECT_NEAR(cutting.fraction(), from + 0.5, 1e-9);
    }
    Progress cancelled;
    cancelled.cancel();
    const auto none = cutGarment(garment, options, cancelled);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::Cancelled);
}

/// A sheet of 6 x 6 squares of 50 mm that its UV map opens along three edges inside.
std::string sheetWithSlit() {
    std::ostringstream obj;
    for (int row = 0; row <= 6; ++row) {
        for (int column = 0; column <= 6; ++column) {
            obj << "v " << 50 * column << ' ' << 50 * row << " 0\n";
            obj << "vt " << column << ' ' << row << '\n';
        }
    }
    obj << "vt 2 3\nvt 3 3\n";  // of the faces above: the ends of the slit are shared
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            obj << 'f';
            for (const auto& [right, up] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                const int c = column + right, r = row + up, vertex = 7 * r + c + 1;
                const bool isDouble = row == 3 && r == 3 && (c == 2 || c == 3);
                obj << ' ' << vertex << '/' << (isDouble ? 48 + c : vertex);
            }
            obj << '\n';
        }
    }
    return obj.str();
}

TEST(Pipeline, ClosesSlitsWhereAskedAndDividesAnewForThat) {
    const test::TemporaryFolder folder;
    Progress progress;
    const auto files = readFiles({folder.write("sheet.obj", sheetWithSlit())}, progress);
    ASSERT_TRUE(files);
    GarmentInputs asRead{*files};
    asRead.loading.unit = LengthUnit::Millimetre;
    asRead.loading.split = SplitMode::Uv;
    GarmentInputs shut = asRead;
    shut.loading.closeSlits = true;
    const auto before = makeGarment(asRead, progress);
    ASSERT_TRUE(before);
    ASSERT_EQ(before->pieces.size(), 1U);
    EXPECT_EQ(slitsInside(before->pieces).size(), 1U);
    EXPECT_EQ(before->pieces[0]->mesh.V.rows(), 7 * 7 + 2);
    const auto after = makeGarment(shut, progress, asRead, &*before);
    ASSERT_TRUE(after);
    ASSERT_EQ(after->pieces.size(), 1U);
    EXPECT_TRUE(slitsInside(after->pieces).empty());
    EXPECT_EQ(after->pieces[0]->mesh.V.rows(), 7 * 7);
    EXPECT_FALSE(after->pieces[0]->defect);
    EXPECT_EQ(after->pieces[0]->id, before->pieces[0]->id);  // what was said of it stays
    EXPECT_EQ(after->uncut, after->pieces);
    const auto again = makeGarment(asRead, progress, shut, &*after);
    ASSERT_TRUE(again);
    EXPECT_EQ(slitsInside(again->pieces).size(), 1U);
}

/// Cuts that cross each other ten thousand times, and one that crosses itself a million times.
TEST(Pipeline, AttackedByTangledCutsItEndsWithAReason) {
    const auto mesh = test::sharedFile("attack/two.obj");
    TOILE_NEEDS_SHARED(mesh);
    for (const char* name : {"attack/manycuts.seams.json", "attack/manypts.seams.json"}) {
        SCOPED_TRACE(name);
        const auto path = test::sharedFile(name);
        TOILE_NEEDS_SHARED(path);
        const auto seams = readSeamsFile(path);
        ASSERT_TRUE(seams);
        LoadOptions options;
        options.unit = LengthUnit::Centimetre;
        options.seams = *seams;
        Progress progress;
        const auto garment = loadGarment({mesh}, options, progress);
        ASSERT_TRUE(garment);
        EXPECT_TRUE(std::ranges::any_of(garment->problems, [](const Error& problem) {
            return problem.code == ErrorCode::CutImpossible &&
                   problem.detail.find("crosses itself") != std::string::npos;
        }));
    }
}

TEST(Pipeline, FlattensEverySampleWithoutFlips) {
    for (const char* sample : {"tshirt.obj", "bodice.obj", "trousers.obj", "cap.obj"}) {
        SCOPED_TRACE(sample);
        const Garment garment = load({test::sourceFile("resources/samples") / sample});
        Progress progress;
        const PieceResults results = flattenGarment(garment, {}, progress);
        EXPECT_GE(results.size(), 5U);
        for (const auto& result : results) {
            SCOPED_TRACE(result->piece->name);
            ASSERT_TRUE(result->flat) << sentence(*result->error);
            EXPECT_EQ(result->quality->flippedTriangles, 0);
            EXPECT_EQ(result->quality->outlineCrossings, 0);
            EXPECT_LE(result->quality->maxBoundaryLengthError, 1e-9);
        }
        EXPECT_DOUBLE_EQ(progress.fraction(), 1);
    }
}

TEST(Pipeline, ABadPieceFailsAloneAndIsExportedAround) {
    const test::TemporaryFolder folder;
    const Garment garment = load({folder.write(
        "mixed.obj", std::string(kTriangle) + "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 0 0 6\n"
                                              "o ball\nf 4 5 6\nf 4 7 5\nf 5 7 6\nf 4 6 7\n")});
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    ASSERT_EQ(results.size(), 2U);
    EXPECT_TRUE(results[0]->flat);
    ASSERT_TRUE(results[1]->error);
    EXPECT_EQ(results[1]->error->code, ErrorCode::ClosedSurface);
    for (const char* out : {"out.svg", "out.dxf", "out.obj", "out.json", "OUT2.SVG"}) {
        EXPECT_TRUE(formatOf(folder / out));
        const auto written = exportFile(folder / out, {garment, results, inRows(garment, results)});
        EXPECT_TRUE(written) << sentence(written.error());
        EXPECT_FALSE(folder.read(out).empty());
        EXPECT_EQ(folder.read(out).find("nan"), std::string::npos);
    }
    EXPECT_FALSE(formatOf("out.tiff"));
    EXPECT_EQ(
        exportFile(folder / "out.tiff", {garment, results, inRows(garment, results)}).error().code,
        ErrorCode::UnknownFormat);
    EXPECT_EQ(exportFile(folder / "none" / "out.svg", {garment, results, inRows(garment, results)})
                  .error()
                  .code,
              ErrorCode::FileUnwritable);
}

TEST(Pipeline, WritesTurnedFacesTurned) {
    const test::TemporaryFolder folder;
    const Garment garment = load({folder.write("a.obj",
                                               "v 0 0 0\nv 10 0 0\nv 20 0 0\nv 0 10 0\nv 10 10 0\n"
                                               "v 20 10 0\nv 30 0 0\nv 30 10 0\n"
                                               "f 1 2 5 4\nf 2 5 6 3\nf 3 7 8 6\n")});
    ASSERT_EQ(garment.files[0]->problems.size(), 1U);
    EXPECT_EQ(garment.files[0]->problems[0].code, ErrorCode::WindingsTurned);
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    ASSERT_TRUE(exportFile(folder / "out.obj", {garment, results, inRows(garment, results)}));
    EXPECT_NE(folder.read("out.obj").find("1 face flipped"), std::string::npos);
    const Garment again = load({folder / "out.obj"});
    EXPECT_TRUE(again.files[0]->problems.empty());
    EXPECT_EQ(again.pieces[0]->mesh.F.rows(), 6);
}

TEST(Pipeline, CancellingMarksWhatIsNotDone) {
    const Garment garment = load({test::dataFile("samples/tshirt.obj")});
    Progress progress;
    progress.cancel();
    const PieceResults results = flattenGarment(garment, {}, progress);
    EXPECT_EQ(results.size(), 5U);
    for (const auto& result : results) {
        ASSERT_TRUE(result->error);
        EXPECT_EQ(result->error->code, ErrorCode::Cancelled);
    }
}

TEST(Pipeline, FilesShowPiecesAsTheyWereLaid) {
    const test::TemporaryFolder folder;
    const Garment garment = load({test::dataFile("samples/cap.obj")});
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    // As in rows: the same bytes as without a word about places.
    const LaidOutPattern rows = inRows(garment, results);
    std::vector<PieceSettings> said(garment.pieces.size());
    for (const PlacedCopy& copy : rows.marker.copies) {
        said[static_cast<std::size_t>(copy.piece)].placement = copy.placement;
    }
    for (const char* name : {"a.svg", "a.dxf", "a.obj"}) {
        ASSERT_TRUE(exportFile(folder / name, {garment, results, inRows(garment, results)}));
        const std::string before = folder.read(name);
        ASSERT_TRUE(write(folder / name, makePattern(garment, results, {.pieces = said})));
        EXPECT_EQ(folder.read(name), before) << name;
    }
    // Turned, mirrored and elsewhere: re-measured from the UV map.
    said[0].placement = Placement{{900, -400}, 0.7, true};
    ASSERT_TRUE(write(folder / "b.obj", makePattern(garment, results, {.pieces = said})));
    const std::string bytes = folder.read("b.obj");
    EXPECT_NE(bytes.find("mirrored, wrong side of the fabric up"), std::string::npos);
    std::vector<Eigen::Vector2d> uvs;
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("vt ")) {
            std::istringstream numbers(line.substr(3));
            Eigen::Vector2d uv;
            numbers >> uv.x() >> uv.y();
            uvs.push_back(uv);
        }
    }
    const Points2 &first = results[0]->flat->Q, &second = results[1]->flat->Q;
    ASSERT_GE(static_cast<Eigen::Index>(uvs.size()), first.rows() + second.rows());
    const Eigen::Vector2d shift = uvs[0] - said[0].placement->applied(first.row(0).transpose());
    for (Eigen::Index v = 0; v < first.rows(); ++v) {
        const Eigen::Vector2d should = said[0].placement->applied(first.row(v).transpose());
        EXPECT_LT((uvs[static_cast<std::size_t>(v)] - should - shift).norm(), 1e-9);
    }
    for (Eigen::Index v = 0; v < second.rows(); ++v) {
        const Eigen::Vector2d should = said[1].placement->applied(second.row(v).transpose());
        EXPECT_LT((uvs[static_cast<std::size_t>(first.rows() + v)] - should - shift).norm(), 1e-9);
    }
}

TEST(Pipeline, GivesTheSameFilesAgain) {
    const test::TemporaryFolder folder;
    for (const char* run : {"a", "b"}) {
        const Garment garment = load({test::dataFile("samples/cap.obj")});
        Progress progress;
        const PieceResults results = flattenGarment(garment, {}, progress);
        for (const char* ending : {".svg", ".dxf", ".obj"}) {
            ASSERT_TRUE(exportFile(folder / (std::string(run) + ending),
                                   {garment, results, inRows(garment, results)}));
        }
    }
    for (const char* ending : {".svg", ".dxf", ".obj"}) {
        EXPECT_EQ(folder.read(std::string("a") + ending), folder.read(std::string("b") + ending));
    }
}

}  // namespace
}  // namespace toile
