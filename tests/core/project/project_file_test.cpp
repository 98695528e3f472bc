// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_file.h"

#include <bit>
#include <random>

#include <gtest/gtest.h>

#include "core/base/json_fields.h"
#include "tests/core/support/project_pieces.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

using Json = JsonDocument;

const fs::path kFolder = "/garments/patterns";
constexpr double kFarthest = 1e9, kMaxTurn = 1e6;

/// Any value of every field, numbers of any magnitude.
class RandomProject {
public:
    explicit RandomProject(unsigned seed) : random_(seed) {}

    Project make() {
        Project project;
        for (int k = 0, n = upTo(3) + 1; k < n; ++k) {
            project.files.push_back(
                {kFolder.parent_path() / text() / "a.obj",
                 flag() ? std::optional<std::uint64_t>(random_()) : std::nullopt,
                 {}});
        }
        LoadOptions& loading = project.loading;
        loading.unit = unit();
        loading.up = flag() ? std::optional(UpAxis::Z) : std::nullopt;
        loading.split = static_cast<SplitMode>(upTo(6));
        loading.weld = flag();
        loading.closeSlits = flag();
        if (flag()) {
            loading.preparing.as = static_cast<FileKind>(upTo(5));
            loading.preparing.surface = static_cast<ShellSurface>(upTo(2));
            loading.preparing.scan = {flag(), 10.5, 0.25, 7};
            loading.preparing.weldDistance = 0.1;
        }
        loading.strict = flag();
        loading.autoCut = flag();
        loading.seams.unit = unit();
        for (int k = upTo(4); k > 0; --k) {
            UserCut& cut = loading.seams.cuts.emplace_back();
            cut.name = text();
            cut.kind = static_cast<UserCut::Kind>(upTo(2));
            cut.alongEdges = flag();
            cut.mirrors = flag() ? CutId{random_() | 1U} : CutId{};
            cut.evidence = flag() ? text() : std::string();
            for (int i = upTo(5); i > 0; --i) {
                cut.points.emplace_back(number(), number(), number());
            }
            loading.seams.ease[text()] = std::uniform_real_distribution<>(-0.9, 2)(random_);
            loading.seamSettings.push_back(
                {{stretch(), flag() ? stretch() : LineStretch{}},
                 flag() ? std::optional(std::uniform_real_distribution<>(-0.9, 2)(random_))
                        : std::nullopt,
                 flag() ? text() : "",
                 flag() ? std::optional(SeamPart{0.25, 1.0 / 3}) : std::nullopt});
            loading.known.push_back({{random_() | 1U},
                                     upTo(3),
                                     text(),
                                     {number(), number(), number()},
                                     std::abs(number())});
        }
        giveIds(loading.seams.cuts);
        project.options.method = static_cast<Method>(upTo(7));
        project.options.quality = static_cast<Quality>(upTo(2));
        project.options.boundarySolver = static_cast<BoundarySolver>(upTo(1));
        project.options.freeBoundary = static_cast<FreeBoundary>(upTo(1));
        project.options.stretchOutline = static_cast<StretchOutline>(upTo(1));
        project.options.authalic = std::uniform_real_distribution<>(0, 1)(random_);
        project.lines = lines();
        project.fabric = {text(), {-0.1 / 3, 1.0 / 3}, {0, 1e-300}, {-0.0, 7}};
        for (int k = upTo(3); k > 0; --k) {
            project.materials.push_back({text(), {text(), {-0.25, 1.0 / 7}, {0, 0}, {-0.5, 3}}});
        }
        for (int k = upTo(5); k > 0; --k) {
            project.pieces.push_back(
                {flag() ? PieceId{random_() | 1U} : PieceId{}, text(), piece()});
        }
        for (int k = upTo(2); k > 0; --k) {
            project.markers[flag() ? text() : ""] = marker();
        }
        for (int k = upTo(5); k > 0; --k) {
            project.labels[{random_() | 1U}] = {flag() ? text() : "", flag() ? upTo(100) : -1};
        }
        if (flag()) {
            project.reference = {kFolder.parent_path() / text() / "a.dxf", std::nullopt, {}};
        }
        project.view = {
            flag() ? "strain" : "", flag(), flag(), flag(), flag(), flag(), flag(), flag(), flag()};
        return project;
    }

private:
    int upTo(int most) { return static_cast<int>(random_() % (static_cast<unsigned>(most) + 1)); }
    bool flag() { return upTo(1) == 1; }

    double length() { return std::uniform_real_distribution<>(0, 1000)(random_); }

    MarkerPlan marker() {
        MarkerPlan plan;
        MarkerSettings& settings = plan.settings;
        settings.width = length();
        if (flag()) {
            settings.sheet = {1 + length(), 1 + length()};
        }
        settings.gap = length();
        settings.border = length();
        settings.turns = static_cast<TurnRule>(upTo(2));
        settings.tolerance = length() / 1000;
        settings.isFolded = flag();
        settings.repeat = {flag() ? length() : 0, flag() ? length() : 0, {-length(), length()}};
        for (int k = upTo(2); k > 0; --k) {
            settings.matched.push_back(text());
            settings.grades[text()] = 1 + upTo(4);
        }
        settings.garments = 1 + upTo(5);
        for (int k = upTo(3); k > 0; --k) {
            plan.kept.push_back({{{random_() | 1U}, upTo(9)},
                                 upTo(3),
                                 {{-length(), length()}, length() / 1000, flag()}});
        }
        return plan;
    }

    /// Any finite bit pattern.
    double number() {
        for (;;) {
            const auto value = std::bit_cast<double>(random_());
            if (std::isfinite(value)) {
                return value;
            }
        }
    }

    std::string text() {
        static const char* const kParts[] = {"front", " ",  "Ärmel", "\"", "\\",
                                             "/",     "袖", "\n",    "a.b"};
        std::string made = "p" + std::to_string(random_() % 1000000);
        for (int k = upTo(4); k > 0; --k) {
            made += kParts[upTo(8)];
        }
        return made;
    }

    LineStretch stretch() { return {{random_() | 1U}, number(2), number(2)}; }

    LineSettings lines() {
        const auto tolerance = [this] {
            return std::uniform_real_distribution<>(kMinFairTolerance, kMaxFairTolerance)(random_);
        };
        LineSettings lines;
        if (flag()) {
            lines.fairing = Fairing{tolerance(), kMinSmoothing + 1.0 / 3};
        }
        lines.trueBelow = flag() ? kProposedTrueing : 0;
        lines.mirror = static_cast<Mirror>(upTo(2));
        for (int k = upTo(3); k > 0; --k) {
            lines.segments.push_back(
                {stretch(), flag() ? std::optional(1000.0 / 7) : std::nullopt,
                 flag() ? std::optional(tolerance()) : std::nullopt, flag(),
                 flag() ? std::optional(100.0 / 7) : std::nullopt,
                 flag() ? std::optional(static_cast<EdgeKind>(upTo(8))) : std::nullopt,
                 flag() ? std::optional(static_cast<CornerRule>(upTo(6))) : std::nullopt});
            lines.turnPoints.push_back({{random_() | 1U}, number(2), flag(), flag()});
            lines.seamEnds.push_back(
                {{stretch(), flag() ? stretch() : LineStretch{}}, flag(), flag()});
        }
        if (flag()) {
            lines.allowance = AllowanceWidths{100.0 / 3, flag() ? 0 : kMaxAllowance};
            lines.allowance->edges[static_cast<std::size_t>(1 + upTo(7))] = 100.0 / 9;
        }
        if (flag()) {
            lines.grain = static_cast<GrainRule>(upTo(2));
        }
        if (flag()) {
            NotchRules& rules = lines.notches.emplace();
            rules.automatic = flag();
            rules.form = static_cast<NotchForm>(upTo(3));
            rules.depth = kMinNotchDepth + 1.0 / 3;
            for (int k = upTo(3); k > 0; --k) {
                rules.notches.push_back({{random_() | 1U},
                                         number(2),
                                         flag(),
                                         flag(),
                                         flag() ? std::optional(1 + upTo(1)) : std::nullopt});
            }
        }
        for (int k = upTo(2); k > 0; --k) {
            InternalLine& line = lines.internalLines.emplace_back();
            line.name = text();
            line.closed = flag();
            for (int n = upTo(3); n >= 0; --n) {
                line.points.emplace_back(number(1e6), -100.0 / 3, number(1));
            }
        }
        return lines;
    }

    std::optional<FileUnit> unit() {
        if (flag()) {
            return std::nullopt;
        }
        return flag()
                   ? std::optional<FileUnit>(kLengthUnits[upTo(4)])
                   : FileUnit::ofMillimetres(std::uniform_real_distribution<>(0.01, 2000)(random_));
    }

    /// Any within the limit.
    double number(double most) {
        for (;;) {
            if (const double value = number(); std::abs(value) <= most) {
                return value;
            }
        }
    }

    PieceSettings piece() {
        PieceSettings settings;
        if (flag()) {
            settings.placement =
                Placement{{number(kFarthest), number(kFarthest)}, number(kMaxTurn), flag()};
        }
        if (flag()) {
            settings.grain = number(kMaxTurn);
        }
        settings.quantity = upTo(1000);
        settings.mirroredPair = flag();
        settings.byHalf = flag();
        settings.material = flag() ? text() : "";
        settings.materialByHand = flag();
        settings.partOf = flag() ? PieceId{random_() | 1U} : PieceId{};
        for (int k = upTo(3); k > 0; --k) {
            settings.anchors.push_back({upTo(1 << 20), {number(kFarthest), number(kFarthest)}});
            if (flag()) {
                settings.anchors.back().point.emplace(number(), number(), number());
            }
        }
        return settings;
    }

    std::mt19937_64 random_;
};

/// A small project with something in each part.
Project someProject() {
    Project project;
    project.files = {{"/garments/dress.obj", 0x1234U, {}}};
    project.loading.seams.cuts = {{"waist", UserCut::Kind::Path, {{0, 1, 2}, {3, 4, 5}}, false}};
    giveIds(project.loading.seams.cuts);
    project.loading.seams.ease["front / back"] = 0.1;
    test::said(project, "front").placement = Placement{{1.5, -2}, 0.25, true};
    test::said(project, "front").anchors = {{3, {1, 2}}, {9, {4, 5}}};
    return project;
}

Json someDocument() {
    return Json::parse(projectText(someProject(), kFolder));
}

std::string faultOf(const Json& document) {
    const auto read = parseProject(document.dump(), "p.toile", kFolder);
    return read ? "" : sentence(read.error());
}

TEST(ProjectFile, AnyProjectReadsBackToTheLastBit) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Project project = RandomProject(seed).make();
        const std::string text = projectText(project, kFolder);
        auto read = parseProject(text, "p.toile", kFolder);
        ASSERT_TRUE(read) << sentence(read.error()) << text;
        EXPECT_TRUE(read->notes.empty());
        EXPECT_EQ(read->project, project) << text;
        // Equality takes -0 for 0; the text does not.
        EXPECT_EQ(projectText(read->project, kFolder), text);
    }
}

TEST(ProjectFile, EveryPrefixOfAFileIsRefusedWithASentence) {
    const std::string text = projectText(RandomProject(7).make(), kFolder);
    const std::size_t whole = text.find_last_of('}') + 1;
    for (std::size_t length = 0; length < whole; ++length) {
        const auto read = parseProject(std::string_view(text).substr(0, length), "p", kFolder);
        ASSERT_FALSE(read) << length;
        EXPECT_EQ(read.error().code, ErrorCode::MalformedProject);
        EXPECT_FALSE(read.error().detail.empty());
    }
}

TEST(ProjectFile, DamagedBytesGiveAProjectOrASentence) {
    const std::string text = projectText(someProject(), kFolder);
    std::mt19937 random(1);
    for (int k = 0; k < 20000; ++k) {
        std::string damaged = text;
        for (int n = 0; n < 1 + k % 3; ++n) {
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        }
        const auto read = parseProject(damaged, "p", kFolder);
        if (!read) {
            EXPECT_FALSE(read.error().detail.empty());
        }
    }
}

/// Replaces each value of the document, in turn, by one of another type.
void visitEach(Json& json, const std::function<void(Json&)>& visit) {
    visit(json);
    if (json.is_structured()) {
        for (auto& item : json) {
            visitEach(item, visit);
        }
    }
}

TEST(ProjectFile, AValueOfTheWrongTypeIsNeverTakenIn) {
    Json document = someDocument();
    int tried = 0;
    visitEach(document, [&](Json& value) {
        if (&value == &document || &value == &document["program"]) {
            return;
        }
        const Json before = value;
        // No number is a text, no text an object, and nothing is null.
        for (const Json& wrong : {Json(nullptr), before.is_object() ? Json("x") : Json::object()}) {
            value = wrong;
            const std::string fault = faultOf(document);
            EXPECT_FALSE(fault.empty()) << document.dump();
            EXPECT_NE(fault.find("p.toile"), std::string::npos);
            ++tried;
        }
        value = before;
    });
    EXPECT_GT(tried, 80);
    EXPECT_EQ(faultOf(document), "");
}

TEST(ProjectFile, AFaultNamesItsPlace) {
    const auto detailWith = [](const std::function<void(Json&)>& damage) -> std::string {
        Json document = someDocument();
        damage(document);
        const auto read = parseProject(document.dump(), "p.toile", kFolder);
        return read ? "" : read.error().detail;
    };
    EXPECT_EQ(detailWith([](Json& d) { d["pieces"][0]["quantity"] = 1.5; }),
              R"("pieces[0].quantity" must be a whole number from 0 to 1000000)");
    EXPECT_EQ(detailWith([](Json& d) { d["pieces"][0]["placement"]["offset"] = {1}; }),
              R"("pieces[0].placement.offset" must be a list of 2 numbers)");
    EXPECT_EQ(detailWith([](Json& d) { d["seams"]["cuts"][0]["points"][1][2] = "x"; }),
              R"("seams.cuts[0].points[1]" must be a list of 3 numbers)");
    EXPECT_EQ(
        detailWith([](Json& d) { d["reading"]["unit"] = "ell"; }),
        R"("reading.unit" must be "mm", "cm", "dm", "m", "in" or a length such as "12.5 mm")");
    EXPECT_EQ(detailWith([](Json& d) { d.erase("files"); }), R"("files" is missing)");
    EXPECT_EQ(detailWith([](Json& d) { d["files"] = Json::array(); }),
              R"("files" must name a file)");
    EXPECT_EQ(detailWith([](Json& d) { d["format"] = "other"; }),
              R"("format" must be "toile-project")");
    EXPECT_EQ(detailWith([](Json& d) { d["version"] = 0; }),
              R"("version" must be a whole number from 1 to 2147483647)");
    EXPECT_EQ(detailWith([](Json& d) { d["flattening"]["authalic"] = 2; }),
              R"("flattening.authalic" must be a number from 0 to 1)");
}

TEST(ProjectFile, NumbersOfNoGarmentAreRefused) {
    const auto refuses = [](const std::function<void(Json&)>& damage) -> bool {
        Json document = someDocument();
        damage(document);
        return !faultOf(document).empty();
    };
    EXPECT_TRUE(refuses([](Json& d) { d["pieces"][0]["placement"]["offset"] = {0, 1e308}; }));
    EXPECT_TRUE(refuses([](Json& d) { d["pieces"][0]["placement"]["turn"] = 1e308; }));
    EXPECT_TRUE(refuses([](Json& d) { d["pieces"][0]["grain"] = -1e308; }));
    EXPECT_TRUE(refuses([](Json& d) { d["pieces"][0]["anchors"][0]["at"] = {1e308, 0}; }));
    EXPECT_TRUE(refuses([](Json& d) { d["fabric"]["warp"] = {0, 1e308}; }));
    for (const double ease : {-1.0, 10.5, 1e308}) {
        EXPECT_TRUE(refuses([ease](Json& d) { d["seams"]["ease"]["front / back"] = ease; }));
    }
    EXPECT_FALSE(refuses([](Json& d) { d["seams"]["ease"]["front / back"] = 10; }));
}

TEST(ProjectFile, ListsInListsWithoutEndAreASentence) {
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    std::string text = someDocument().dump();
    const std::string points = R"("points":[[0.0,1.0,2.0])";
    ASSERT_NE(text.find(points), std::string::npos) << text;
    ASSERT_FALSE(parseProject(deep, "p.toile", kFolder));
    for (const std::string& wrong : {deep, "[0,1," + deep + "]"}) {
        std::string damaged = text;
        damaged.replace(text.find(points), points.size(), R"("points":[)" + wrong);
        const auto read = parseProject(damaged, "p.toile", kFolder);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, ErrorCode::MalformedProject);
        EXPECT_NE(read.error().detail.find("too deep"), std::string::npos);
        EXPECT_FALSE(parseSeamsFile(damaged, "s"));
    }
}

TEST(ProjectFile, UnknownKeysAreNotedAndNotFatal) {
    Json document = someDocument();
    document["colour"] = "red";
    document["pieces"][0]["lining"] = {1, 2, 3};
    const auto read = parseProject(document.dump(), "p.toile", kFolder);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->project, someProject());
    ASSERT_EQ(read->notes.size(), 1U);
    EXPECT_EQ(read->notes[0].code, ErrorCode::UnknownKey);
    EXPECT_EQ(read->notes[0].detail, R"("pieces[0].lining", "colour")");
}

TEST(ProjectFile, WhatIsLeftOutIsAsInANewProject) {
    const auto read = parseProject(
        R"({"format": "toile-project", "version": 1, "files": [{"path": "../dress.obj"}]})", "p",
        kFolder);
    ASSERT_TRUE(read);
    Project expected;
    expected.files = {{"/garments/dress.obj", std::nullopt, {}}};
    EXPECT_EQ(read->project, expected);
}

TEST(ProjectFile, ANewerVersionIsRefusedByName) {
    Json document = someDocument();
    document["version"] = kProjectVersion + 1;
    document["files"] = "whatever a later version has here";
    const auto read = parseProject(document.dump(), "p.toile", kFolder);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::NewerProject);
}

TEST(ProjectFile, EveryOlderVersionHasAnUpgrade) {
    for (int version = 1; version < kProjectVersion; ++version) {
        EXPECT_EQ(std::ranges::count(kProjectUpgrades, version, &ProjectUpgrade::from), 1);
    }
}

TEST(ProjectFile, OlderFilesKeepTheWidthOfHemsAlongAllFreeEdges) {
    Json document = someDocument();
    document["version"] = 3;
    document["lines"] = {{"allowance", {{"seam", 12.0}, {"hem", 40.0}}}};
    const auto read = parseProject(document.dump(), "p.toile", kFolder);
    ASSERT_TRUE(read) << sentence(read.error());
    const AllowanceWidths& widths = *read->project.lines.allowance;
    EXPECT_EQ(widths.seam, 12);
    for (std::size_t kind = 0; kind < kEdgeKindCount; ++kind) {
        EXPECT_EQ(widths.widthOf(static_cast<EdgeKind>(kind)), 40);
    }
}

TEST(ProjectFile, UpgradesAreAppliedOneAfterTheOtherFromTheFilesVersionOn) {
    const ProjectUpgrade upgrades[] = {
        {3, [](Json& d) { d["steps"].push_back("3 to 4"); }},
        {1, [](Json& d) { d["steps"] = {"1 to 2"}; }},
        {2, [](Json& d) { d["steps"].push_back("2 to 3"); }},
    };
    for (int from = 1; from <= 4; ++from) {
        Json document{{"version", from}, {"steps", Json::array()}};
        upgradeProject(document, from, upgrades);
        EXPECT_EQ(document["version"], 4);
        EXPECT_EQ(document["steps"].size(), static_cast<std::size_t>(4 - from));
    }
}

TEST(ProjectFile, PathsAreRelativeToTheFileWithTheWholePathBeside) {
    const Json document = someDocument();
    EXPECT_EQ(document["files"][0]["path"], "../dress.obj");
    EXPECT_EQ(document["files"][0]["absolute"], "/garments/dress.obj");
    // Moved together, the relative path leads on.
    const auto moved = parseProject(document.dump(), "p", "/home/patterns");
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->project.files[0].path, "/home/dress.obj");
    EXPECT_EQ(moved->project.files[0].elsewhere, "/garments/dress.obj");
}

TEST(ProjectFile, APathThatTheSystemWouldCutOffIsRefused) {
    for (const char* key : {"path", "absolute"}) {
        Json document = someDocument();
        document["files"][0][key] = std::string("a\0b.obj", 7);
        EXPECT_NE(faultOf(document).find(std::string("files[0].") + key), std::string::npos);
    }
}

TEST(ProjectFile, HundredThousandEntriesAreReadAndWrittenLikeFew) {
    Project project = someProject();
    for (int k = 0; k < 100000; ++k) {
        project.pieces.push_back({{k + 1U}, "piece " + std::to_string(k), {}});
        project.loading.seams.ease["seam " + std::to_string(k)] = 0.5;
    }
    const auto read = parseProject(projectText(project, kFolder), "p", kFolder);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->project, project);
}

TEST(ProjectFile, AMeshIsFoundByEitherPath) {
    const test::TemporaryFolder folder;
    const fs::path mesh = folder.write("dress.obj", "mesh");
    Project project;
    project.files = {{folder / "gone.obj", std::nullopt, mesh}, {mesh, std::nullopt, {}}};
    EXPECT_TRUE(locateMeshes(project).empty());
    EXPECT_EQ(project.files[0].path, mesh);
    project.files.push_back({folder / "gone.obj", std::nullopt, folder / "lost.obj"});
    EXPECT_EQ(locateMeshes(project), std::vector<fs::path>{folder / "gone.obj"});
}

TEST(ProjectFile, AReferencePatternIsFoundByEitherPathAndMissedByNobody) {
    const test::TemporaryFolder folder;
    const fs::path pattern = folder.write("dress.dxf", "pattern");
    Project project;
    project.reference = FileReference{folder / "gone.dxf", std::nullopt, pattern};
    EXPECT_TRUE(locateMeshes(project).empty());
    EXPECT_EQ(project.reference->path, pattern);
    project.reference = FileReference{folder / "gone.dxf", std::nullopt, folder / "lost.dxf"};
    EXPECT_TRUE(locateMeshes(project).empty());
    EXPECT_EQ(project.reference->path, folder / "gone.dxf");
}

TEST(ProjectFile, AReferencePatternMustHaveAPath) {
    for (const Json& reference : {Json::object(), Json{{"path", std::string("a\0b.dxf", 7)}},
                                  Json{{"absolute", 3}}, Json("dress.dxf"), Json::array()}) {
        Json document = someDocument();
        document["reference"] = reference;
        EXPECT_NE(faultOf(document).find("reference"), std::string::npos) << reference.dump();
    }
}

TEST(ProjectFile, IsWrittenAndReadBesideItsMesh) {
    const test::TemporaryFolder folder;
    Project project = someProject();
    project.files[0].path = folder.write("dress.obj", "mesh");
    const auto written = writeProject(folder / "p.toile", project);
    ASSERT_TRUE(written);
    const auto read = readProject(folder / "p.toile");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->project, project);
    EXPECT_EQ(read->hash, *written);
    EXPECT_NE(folder.read("p.toile").find("\"path\": \"dress.obj\""), std::string::npos);
}

TEST(ProjectFile, AnErrorLeavesTheOldFileWhole) {
    const test::TemporaryFolder folder;
    EXPECT_FALSE(writeProject(folder / "missing" / "p.toile", someProject()));
    EXPECT_FALSE(readProject(folder / "missing.toile"));
    EXPECT_EQ(readProject(folder / "missing.toile").error().code, ErrorCode::FileUnreadable);
}

TEST(ProjectFile, IsKnownByItsEnding) {
    EXPECT_TRUE(isProjectFile("a/b.toile"));
    EXPECT_TRUE(isProjectFile("B.TOILE"));
    EXPECT_FALSE(isProjectFile("toile"));
    EXPECT_FALSE(isProjectFile("a.toile/b.obj"));
}

}  // namespace
}  // namespace toile
