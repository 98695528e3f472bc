// SPDX-License-Identifier: GPL-3.0-or-later
// What files are taken for: the table in docs/input.md.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/toile/pipeline.h"
#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/half_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

Garment readAs(const std::filesystem::path& file, const Preparation& preparing,
               bool autoCut = false) {
    Progress progress;
    auto garment = loadGarment({file}, {.preparing = preparing, .autoCut = autoCut}, progress);
    EXPECT_TRUE(garment) << file;
    return garment ? *garment : Garment{};
}

/// "13 flat", "1 closed", "1 with 4 openings", "68 flat, 1 not": what can lie flat as it is.
std::string piecesOf(const Garment& garment) {
    const auto isDisk = [](const auto& piece) { return !piece->defect; };
    const auto flat = std::ranges::count_if(garment.pieces, isDisk);
    const auto others = std::ssize(garment.pieces) - flat;
    std::string cell = flat > 0 ? std::to_string(flat) + " flat" : "";
    if (others == 1 && flat == 0) {
        const std::size_t rims = loopLengths(*garment.pieces.front()).size();
        return rims == 0 ? "1 closed" : "1 with " + std::to_string(rims) + " openings";
    }
    if (others > 0) {
        cell += (cell.empty() ? "" : ", ") + std::to_string(others) + " not";
    }
    return cell;
}

/// Mean strain by `curvature`, over the area of all that lies flat, percent; a dash where none
/// does.
std::string strainOf(const Garment& garment) {
    Progress progress;
    FlattenOptions options;
    options.method = Method::Curvature;
    double area = 0, strain = 0;
    for (const auto& result : flattenGarment(garment, options, progress)) {
        if (result->quality && result->quality->strainMeanAbs) {
            area += result->quality->area3d;
            strain += result->quality->area3d * *result->quality->strainMeanAbs;
        }
    }
    const double percent = area > 0 ? 100 * strain / area : 0;
    return area <= 0 ? "–" : percent > 1000 ? "beyond 1000" : fixed(percent, 1);
}

/// What was done with the file to read it as it was taken.
std::string stepsOf(const Garment& garment) {
    for (const Error& problem : garment.files.front()->problems) {
        if (problem.code == ErrorCode::ReadAs) {
            return problem.detail;
        }
    }
    return "";
}

std::string row(const std::string& name) {
    const auto file = test::sharedFile(name);
    const Garment plain = readAs(file, {.as = FileKind::Sheet}), taken = readAs(file, {});
    const FileReading& reading = taken.files.front()->reading;
    std::string said(wordOf(kFileKindWords, reading.kind));
    said += reading.evidence.empty() ? "" : ": " + reading.evidence;
    Preparation chosen;
    std::string after = piecesOf(taken), steps = stepsOf(taken);
    if (reading.kind == FileKind::Scan) {
        chosen.as = FileKind::Scan;
        const Garment prepared = readAs(file, chosen);
        after = piecesOf(prepared) + " with `--as scan`";
        steps = stepsOf(prepared);
    }
    const std::string strain = strainOf(readAs(file, {.as = FileKind::Sheet}, true));
    const bool isAsBefore = steps.empty();
    return "| `" + name + "` | " + said + " | " + steps + " | " + piecesOf(plain) + " | " + strain +
           " | " + (isAsBefore ? "" : after) + " | " +
           (isAsBefore ? "" : strainOf(readAs(file, chosen, true))) + " |\n";
}

TEST(InputKindsSlow, UpdatesTheTableInDocs) {
    TOILE_NEEDS_SHARED(test::sharedFile("thick"));
    std::string table =
        "| File | Taken for | Steps | Pieces, read as a sheet | mean strain % | read as that | "
        "mean "
        "strain % |\n|---|---|---|---|--:|---|--:|\n";
    for (const char* name : {"thick/dress_thick.obj",
                             "thick/tee_sim_thick.obj",
                             "scans/dress_scan.obj",
                             "garments/dress.obj",
                             "garments/dress14_pieces.obj",
                             "garments/elegant_mh.obj",
                             "garments/leggings.ply",
                             "garments/longsleeve.obj",
                             "garments/polo.obj",
                             "garments/skirt_clo.obj",
                             "garments/suit_mh.obj",
                             "garments/tee_sim.obj",
                             "garments/tshirt.obj",
                             "garments/wetsuit_patches.obj",
                             "nasty/boeing.off",
                             "nasty/bunny_holes.ply",
                             "nasty/capsule.obj",
                             "nasty/elephant-with-holes.off",
                             "nasty/hand_closed.off",
                             "nasty/knot_torus.off",
                             "nasty/mask_cone.off",
                             "nasty/soup.stl"}) {
        table += row(name);
    }
    test::updateTableInDocs("input.md", "kinds of files", table);
}

TEST(InputKinds, HalfAGarmentIsNamedAndCompleted) {
    Progress progress;
    const auto whole = readSoup(test::dataFile("samples/skirt.obj"), progress);
    ASSERT_TRUE(whole);
    const test::TemporaryFolder folder;
    const Eigen::Hyperplane<double, 3> centre(Eigen::Vector3d::UnitX(), 0);
    const std::string half =
        folder.write("half.obj", test::objOf(test::halfOf(*whole, centre))).string();
    const test::ProgramRun named = test::toileRun({"info", half});
    EXPECT_NE(named.out.find("--complete-half"), std::string::npos) << named.out;
    const test::ProgramRun completed = test::toileRun({"info", half, "--complete-half"});
    EXPECT_NE(completed.out.find("mirror image added"), std::string::npos) << completed.out;
    EXPECT_NE(completed.err.find("half a garment: the mirror image"), std::string::npos)
        << completed.err;
    const test::ProgramRun refused =
        test::toileRun({"info", test::dataFile("samples/skirt.obj").string(), "--complete-half"});
    EXPECT_NE(refused.err.find("half a garment needs"), std::string::npos) << refused.err;
}

TEST(InputKinds, ASolidIsToldHowItIsOpened) {
    const test::TemporaryFolder folder;
    const std::string ball = folder.write("ball.obj", test::kBall).string();
    EXPECT_NE(test::toileRun({"info", ball}).out.find("--auto-cut"), std::string::npos);
}

}  // namespace
}  // namespace toile
