// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/check_documents.h"

#include <cmath>

#include "core/assemble/divide.h"
#include "core/project/piece_names.h"
#include "core/project/project_file.h"
#include "core/toile/pipeline.h"
#include "core/toile/toile.h"
#include "tests/fuzz/check_garment.h"

namespace toile::fuzz {
namespace {

constexpr std::size_t kMaxDocumentBytes = 16 * 1024;
constexpr std::size_t kMaxCutPoints = 30;  ///< beyond, cuts are not made: a fuzzer wants many runs
constexpr auto kName = "fuzz";
constexpr auto kFolder = "/meshes";
constexpr int kSide = 4;     ///< quads along the panel, and up the tube
constexpr int kRound = 8;    ///< quads around the tube
constexpr double kQuad = 2;  ///< cm

/// One grid of quads as OFF, its vertices given by a function of column and row.
template <class Place>
void addGrid(std::string& vertices, std::string& faces, int& count, int columns, bool closed,
             const Place& place) {
    const int wide = closed ? columns : columns + 1;
    for (int row = 0; row <= kSide; ++row) {
        for (int column = 0; column < wide; ++column) {
            const Eigen::Vector3d p = place(column, row);
            vertices += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                        std::to_string(p.z()) + "\n";
        }
    }
    const auto at = [&](int column, int row) {
        return " " + std::to_string(count + row * wide + column % wide);
    };
    for (int row = 0; row < kSide; ++row) {
        for (int c = 0; c < columns; ++c) {
            faces += "4" + at(c, row) + at(c + 1, row) + at(c + 1, row + 1) + at(c, row + 1) + "\n";
        }
    }
    count += wide * (kSide + 1);
}

/// A bent panel and beside it a tube, in centimetres.
Garment smallGarment() {
    std::string vertices, faces;
    int count = 0;
    addGrid(vertices, faces, count, kSide, false,
            [](int c, int r) { return Eigen::Vector3d(kQuad * c, kQuad * r, 0.2 * c * r); });
    addGrid(vertices, faces, count, kRound, true, [](int c, int r) {
        const double angle = 2 * M_PI * c / kRound;
        return Eigen::Vector3d(20 + 3 * std::cos(angle), kQuad * r, 3 * std::sin(angle));
    });
    const int quads = kSide * (kSide + kRound);
    Progress progress;
    auto file = std::make_shared<SourceFile>();
    file->path = "fuzz.off";
    file->unit = LengthUnit::Centimetre;
    file->soup = std::make_shared<const PolygonSoup>(*readOff(
        std::make_shared<const std::string>("OFF\n" + std::to_string(count) + " " +
                                            std::to_string(quads) + " 0\n" + vertices + faces),
        kName, progress));
    Garment garment;
    auto uncut = divide(*file, 0, "", {}).pieces;
    garment.files.push_back(std::move(file));
    identify(uncut, garment.files, {});
    garment.uncut.assign(uncut.begin(), uncut.end());
    garment.pieces = garment.uncut;
    return garment;
}

/// The small garment cut as a file says; none where that has many points.
std::optional<Garment> cutSmall(const LoadOptions& loading) {
    std::size_t points = 0;
    for (const UserCut& cut : loading.seams.cuts) {
        points += cut.points.size();
    }
    for (const UserJoin& join : loading.seams.joins) {
        points += join.points.size();
    }
    if (points > kMaxCutPoints) {
        return std::nullopt;
    }
    static const Garment small = smallGarment();
    Progress progress;
    return *cutGarment(small, loading, progress);
}

std::string brokenByRefusal(const Error& error) {
    const bool expected = error.code == ErrorCode::MalformedFile ||
                          error.code == ErrorCode::MalformedProject ||
                          error.code == ErrorCode::NewerProject;
    return expected && error.subject.name == kName && !error.detail.empty()
               ? ""
               : "refused without a proper reason: " + sentence(error);
}

}  // namespace

std::string whatBreaksInSeams(std::string bytes) {
    if (bytes.size() > kMaxDocumentBytes) {
        return "";
    }
    const auto file = parseSeamsFile(bytes, kName);
    if (!file) {
        return brokenByRefusal(file.error());
    }
    const auto again = parseSeamsFile(writeSeamsFile(*file), kName);
    if (!again || !(*again == *file)) {
        return "what is written does not read back to the same";
    }
    LoadOptions loading;
    loading.seams = *file;
    loading.autoCut = true;
    const auto garment = cutSmall(loading);
    return garment ? whatBreaksIn(*garment) : "";
}

std::string whatBreaksInProject(std::string bytes) {
    if (bytes.size() > kMaxDocumentBytes) {
        return "";
    }
    auto read = parseProject(bytes, kName, kFolder);
    if (!read) {
        return brokenByRefusal(read.error());
    }
    Project& project = read->project;
    const std::string text = projectText(project, kFolder);
    const auto again = parseProject(text, kName, kFolder);
    for (FileReference& file : project.files) {
        file.elsewhere.clear();  // is for looking once
    }
    if (project.reference) {
        project.reference->elsewhere.clear();
    }
    if (!again || !(again->project == project) || projectText(again->project, kFolder) != text) {
        return "what is written does not read back to the same";
    }
    const auto garment = cutSmall(project.loading);
    if (!garment) {
        return "";
    }
    if (std::string broken = whatBreaksIn(*garment); !broken.empty()) {
        return broken;
    }
    Progress progress;
    const PieceResults results = flattenGarment(*garment, project.options, progress);
    differencesTo(project, *garment);
    const FinishedPattern made =
        makePattern(named(*garment, project.labels), results,
                    {.materials = project.materials, .pieces = settingsFor(project, *garment)});
    return whatBreaksIn(made.garment, made.results, made.laid);
}

}  // namespace toile::fuzz
