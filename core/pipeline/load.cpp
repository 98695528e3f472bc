// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <Eigen/Geometry>

#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/garment/divide.h"
#include "core/io/soup.h"
#include "core/io/unit_guess.h"
#include "core/pipeline/pipeline.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

double largestExtent(const PolygonSoup& soup) {
    Eigen::AlignedBox3d box;
    for (const int corner : soup.corners) {
        if (soup.positions[corner].allFinite()) {
            box.extend(soup.positions[corner]);
        }
    }
    return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

void chooseUnit(SourceFile& file, const std::optional<LengthUnit>& stated) {
    if (stated) {
        file.unit = *stated;
        return;
    }
    const UnitGuess guess = guessUnit(largestExtent(file.soup));
    file.unit = guess.unit;
    file.unitReason = guess.reason;
    if (guess.inDoubt) {
        file.problems.push_back(
            {ErrorCode::UnitGuessed, file.path.filename().string(), guess.reason});
    }
}

void noteUnusedVertices(SourceFile& file) {
    std::vector<char> used(file.soup.positions.size(), 0);
    for (const int corner : file.soup.corners) {
        used[corner] = 1;
    }
    const auto unused = std::count(used.begin(), used.end(), 0);
    if (unused > 0) {
        file.problems.push_back({ErrorCode::UnusedVertices, file.path.filename().string(),
                                 counted(unused, "vertex") + " of " + std::to_string(used.size())});
    }
}

/// The first note that something of the file was left out or read otherwise than written.
const Error* firstChange(const Problems& problems) {
    const auto found = std::find_if(problems.begin(), problems.end(), [](const Error& problem) {
        return problem.code != ErrorCode::UnitGuessed && problem.code != ErrorCode::UnusedVertices;
    });
    return found == problems.end() ? nullptr : &*found;
}

/// Stems of the files, made unique, for piece names of a garment of several files.
std::vector<std::string> prefixes(const std::vector<fs::path>& paths) {
    std::vector<std::string> stems;
    std::set<std::string> taken;
    for (const fs::path& path : paths) {
        std::string stem = path.stem().string();
        for (int k = 2; !taken.insert(stem).second; ++k) {
            stem = path.stem().string() + " " + std::to_string(k);
        }
        stems.push_back(stem);
    }
    return stems;
}

}  // namespace

Result<Garment> loadGarment(const std::vector<fs::path>& paths, const LoadOptions& options,
                            Progress& progress) {
    Garment garment;
    const std::vector<std::string> prefix = prefixes(paths);
    progress.start(2.0 * static_cast<double>(paths.size()));
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const Stopwatch time;
        auto soup = readSoup(paths[k], progress);
        if (!soup) {
            return soup.error();
        }
        progress.advance(1);
        auto file = std::make_shared<SourceFile>();
        file->path = paths[k];
        file->soup = std::move(*soup);
        file->problems = file->soup.problems;
        chooseUnit(*file, options.unit);
        noteUnusedVertices(*file);
        DividedFile divided =
            divide(*file, static_cast<int>(k), paths.size() > 1 ? prefix[k] + "/" : "",
                   {options.split, !options.strict});
        file->split = std::move(divided.split);
        file->problems.insert(file->problems.end(), divided.problems.begin(),
                              divided.problems.end());
        if (options.strict) {
            if (const Error* change = firstChange(file->problems)) {
                return *change;
            }
        }
        file->readSeconds = time.seconds();
        garment.pieces.insert(garment.pieces.end(), divided.pieces.begin(), divided.pieces.end());
        garment.files.push_back(std::move(file));
        progress.advance(1);
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, "", ""};
        }
    }
    if (garment.pieces.empty()) {
        return Error{ErrorCode::NoGeometry, paths.empty() ? "" : paths.front().string(),
                     "no usable face is left"};
    }
    return garment;
}

}  // namespace toile
