// SPDX-License-Identifier: GPL-3.0-or-later
// What the problems of a garment are about: the kind is one of the code's, and the id leads there.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/assemble/identify.h"
#include "core/formats/writers.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

using Kinds = std::vector<Subject::Kind>;

/// What a code can be about.
Kinds kindsOf(ErrorCode code) {
    using Kind = Subject::Kind;
    switch (code) {
        case ErrorCode::FileUnreadable:
        case ErrorCode::FileUnwritable:
        case ErrorCode::UnknownFormat:
        case ErrorCode::MalformedFile:
        case ErrorCode::NoGeometry:
        case ErrorCode::MalformedProject:
        case ErrorCode::NewerProject:
        case ErrorCode::UnitGuessed:
        case ErrorCode::IndexOutOfRange:
        case ErrorCode::PolygonNotSimple:
        case ErrorCode::OutputDiffers:
        case ErrorCode::UnknownKey:
        case ErrorCode::FileChanged:
        case ErrorCode::VerticesWelded:
        case ErrorCode::ReadAs:
        case ErrorCode::CannotReadAs:
        case ErrorCode::LooksLikeScan:
            return {Kind::File};
        case ErrorCode::NonFinitePosition:
        case ErrorCode::DegenerateFaceRecord:
        case ErrorCode::UnusedVertices:
            return {Kind::File, Kind::Piece};  // of reading, of repairing
        case ErrorCode::CutImpossible:
            return {Kind::Cut, Kind::Piece};  // the user's, Toile's own
        case ErrorCode::JoinImpossible:
            return {Kind::Join};
        case ErrorCode::NoSuchSeam:
            return {Kind::Seam};
        case ErrorCode::EdgesCrowd:
        case ErrorCode::SeamsByNearness:
            return {Kind::None};
        default:
            return {Kind::Piece};
    }
}

/// Everything that is said of a garment, flattened.
Problems everythingSaid(const Garment& garment) {
    Problems all = garment.problems;
    const auto take = [&all](const Problems& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const auto& file : garment.files) {
        take(file->problems);
    }
    for (const auto& piece : garment.uncut) {
        take(piece->defect ? Problems{*piece->defect} : Problems{});
    }
    Progress progress;
    for (const auto& result : flattenGarment(garment, {}, progress)) {
        take(result->error ? Problems{*result->error} : Problems{});
        take(result->flat ? result->flat->notes : Problems{});
    }
    return all;
}

/// The names of what an id of this kind leads to.
std::multimap<std::uint64_t, std::string> namesById(const Garment& garment,
                                                    const std::vector<UserCut>& cuts,
                                                    Subject::Kind kind) {
    std::multimap<std::uint64_t, std::string> names;
    if (kind == Subject::Kind::File) {
        const auto ids = fileIds(garment.files);
        for (std::size_t f = 0; f < ids.size(); ++f) {
            names.emplace(ids[f].value, garment.files[f]->path.filename().string());
        }
    } else if (kind == Subject::Kind::Cut) {
        for (const UserCut& cut : cuts) {
            names.emplace(cut.id.value, cut.name);
        }
    } else {
        for (const auto* pieces : {&garment.pieces, &garment.uncut}) {
            for (const auto& piece : *pieces) {
                names.emplace(piece->id.value, piece->name);
            }
        }
    }
    return names;
}

void expectToLeadThere(const Garment& garment, const std::vector<UserCut>& cuts) {
    for (const Error& said : everythingSaid(garment)) {
        SCOPED_TRACE(sentence(said));
        const auto& [kind, id, name] = said.subject;
        EXPECT_EQ(std::ranges::count(kindsOf(said.code), kind), 1);
        if (kind == Subject::Kind::File || kind == Subject::Kind::Piece ||
            kind == Subject::Kind::Cut) {
            const auto names = namesById(garment, cuts, kind);
            const auto [first, last] = names.equal_range(id);
            EXPECT_TRUE(std::any_of(first, last, [&said](const auto& known) {
                return known.second == said.subject.name;
            }));
        }
    }
}

/// A file, its only piece, a cut and a join of one name; a face flipped, a vertex unused, a
/// size that leaves doubt, a hole.
constexpr const char* kOneName = "front.obj";
constexpr const char* kText =
    "o front.obj\nv 0 0 0\nv 200 0 0\nv 200 9 0\nv 0 9 0\nv 50 3 0\nv 60 3 0\nv 55 6 0\nv 1 1 1\n"
    "f 1 2 6\nf 6 5 1\nf 2 3 6\nf 6 3 7\nf 3 4 7\nf 4 5 7\nf 1 4 5\n";

Garment garmentOfOneName(const test::TemporaryFolder& folder, LoadOptions& options) {
    options.seams.cuts = {{kOneName, UserCut::Kind::Path, {{9e5, 0, 0}, {9e5, 9, 0}}},
                          {"across", UserCut::Kind::Path, {{20, 0, 0}, {20, 9, 0}}}};
    giveIds(options.seams.cuts);
    options.seams.joins = {{kOneName, {{0, 0, 0}, {200, 0, 0}}}};
    options.seams.ease = {{kOneName, 0.1}};
    Progress progress;
    auto garment = loadGarment({folder.write(kOneName, kText)}, options, progress);
    return garment ? std::move(*garment) : Garment{};
}

TEST(Subjects, LeadToWhatTheyNameWhateverElseIsCalledSo) {
    const test::TemporaryFolder folder;
    LoadOptions options;
    const Garment garment = garmentOfOneName(folder, options);
    ASSERT_EQ(garment.uncut.size(), 1U);
    expectToLeadThere(garment, options.seams.cuts);
    std::map<std::string_view, Subject::Kind> said;
    for (const Error& problem : everythingSaid(garment)) {
        said.emplace(name(problem.code), problem.subject.kind);
    }
    using Kind = Subject::Kind;
    EXPECT_EQ(said["windings-turned"], Kind::Piece);
    EXPECT_EQ(said["unused-vertices"], Kind::File);
    EXPECT_EQ(said["unit-guessed"], Kind::File);
    EXPECT_EQ(said["cut-impossible"], Kind::Cut);
    EXPECT_EQ(said["join-impossible"], Kind::Join);
    EXPECT_EQ(said["no-such-seam"], Kind::Seam);
}

TEST(Subjects, OnlyWhatIsSaidOfAPieceIsReportedWithOne) {
    const test::TemporaryFolder folder;
    LoadOptions options;
    const auto info = nlohmann::json::parse(writeInfo(garmentOfOneName(folder, options)));
    std::size_t ofPieces = 0;
    for (const auto* list : {&info["files"][0]["problems"], &info["problems"]}) {
        for (const auto& problem : *list) {
            const bool isOfPiece =
                problem["code"] == "windings-turned" || problem["code"] == "holes-kept";
            EXPECT_EQ(problem["piece"].is_null(), !isOfPiece) << problem;
            ofPieces += isOfPiece ? 1 : 0;
        }
    }
    EXPECT_EQ(ofPieces, 2U);
}

TEST(Subjects, AFileOpenedTwiceIsTwoFiles) {
    const test::TemporaryFolder folder;
    const auto path = folder.write(kOneName, kText);
    Progress progress;
    const auto twice = loadGarment({path, path}, {}, progress);
    ASSERT_TRUE(twice);
    expectToLeadThere(*twice, {});
    const Problems &one = twice->files[0]->problems, &other = twice->files[1]->problems;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].code, other[i].code);
        EXPECT_NE(one[i].subject, other[i].subject) << sentence(one[i]);
    }
}

TEST(Subjects, OfFilesWithFaultsLeadThereToo) {
    const auto folder = test::sharedFile("nasty");
    TOILE_NEEDS_SHARED(folder);
    constexpr std::uintmax_t kQuick = 50000;
    LoadOptions options;
    options.autoCut = true;
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.file_size() > kQuick) {
            continue;
        }
        SCOPED_TRACE(entry.path().string());
        Progress progress;
        if (const auto garment = loadGarment({entry.path()}, options, progress)) {
            expectToLeadThere(*garment, {});
            ++read;
        } else {
            EXPECT_EQ(garment.error().subject.kind, Subject::Kind::File);
        }
    }
    EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace toile
