// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include <Eigen/Geometry>

#include "core/assemble/divide.h"
#include "core/assemble/slits.h"
#include "core/assemble/weld_soup.h"
#include "core/base/progress.h"
#include "core/base/text.h"
#include "core/io/conventions.h"
#include "core/io/soup.h"
#include "core/prepare/file_surface.h"
#include "core/prepare/half.h"
#include "core/prepare/orientation.h"
#include "core/toile/garment_flattener.h"
#include "core/toile/pipeline.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// Approximate shares: of reading in the total time, and of dividing in the rest, before joins,
/// cuts and seams.
constexpr double kReadingShare = 0.35, kDividingShare = 0.55;

double largestExtentOf(const PolygonSoup& soup) {
    Eigen::AlignedBox3d box;
    for (const int corner : soup.corners) {
        if (soup.positions[corner].allFinite()) {
            box.extend(soup.positions[corner]);
        }
    }
    return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

/// Why a garment of this size is unlikely in a guessed unit; nothing if the size is usual: 100 to
/// 2300 mm, or the range that the file's name suggests. A doll's dress cannot be distinguished from
/// a dress in the wrong unit.
/// @param largestExtent  mm
std::optional<Wording> sizeDoubt(double largestExtent, std::string_view fileName) {
    static constexpr double kHead[2] = {80, 800}, kBody[2] = {450, 2500}, kTent[2] = {1000, 30'000};
    constexpr std::pair<std::string_view, const double*> kKinds[] = {
        {"hat", kHead},  {"cap", kHead},   {"beret", kHead}, {"beanie", kHead},   {"fedora", kHead},
        {"sock", kHead}, {"glove", kHead}, {"dress", kBody}, {"jumpsuit", kBody}, {"gown", kBody},
        {"coat", kBody}, {"tent", kTent},  {"tarp", kTent}};
    constexpr double kGarment[2] = {100, 2300};
    const std::string words = "-" + slug(fileName) + "-";
    const auto* const kind = std::ranges::find_if(kKinds, [&words](const auto& known) {
        return words.find("-" + std::string(known.first) + "-") != std::string::npos;
    });
    const double* const usual = kind == std::end(kKinds) ? kGarment : kind->second;
    if (largestExtent <= 0 || (largestExtent >= usual[0] && largestExtent <= usual[1])) {
        return std::nullopt;
    }
    constexpr double kWrittenOut = 1e-6;
    const auto decimals = static_cast<int>(1 - std::floor(std::log10(largestExtent)));
    const Wording extent = largestExtent < kWrittenOut
                               ? Wording(scientific(largestExtent, 2))
                               : figure(largestExtent, std::max(0, decimals));
    return kind == std::end(kKinds) ? worded("a garment of %1 mm is unusual", {extent})
                                    : worded("%1 mm is unusual for \"%2\" in its name",
                                             {extent, Wording(std::string(kind->first))});
}

void chooseUnit(SourceFile& file, const std::optional<FileUnit>& stated, double largestExtent) {
    if (stated) {
        file.unit = *stated;
        return;
    }
    const std::string name = file.path.filename().string();
    const auto& own = file.soup->statedUnit;
    const UnitGuess guess = guessUnit(largestExtent);
    file.unit = own ? own->unit : guess.unit;
    file.unitReason = own ? own->reason : guess.reason;
    const auto doubt = sizeDoubt(largestExtent * millimetresPer(file.unit), name);
    file.unitInDoubt = !own && (guess.inDoubt || doubt);
    if (file.unitInDoubt || doubt) {
        const Wording reason = doubt ? worded("%1; %2", {file.unitReason, *doubt}) : guess.reason;
        file.problems.push_back({ErrorCode::UnitGuessed, Subject::file(name), reason});
    }
}

/// @param mesh  what the file holds once it is prepared, in its own axes
void chooseUpAxis(SourceFile& file, const std::optional<UpAxis>& stated, const MeshArrays& mesh) {
    if (stated) {
        file.up = *stated;
        return;
    }
    if (file.soup->statedUp) {
        file.up = file.soup->statedUp->axis;
        file.upReason = file.soup->statedUp->reason;
        return;
    }
    UpGuess guess = guessUpAxis(mesh);
    file.up = guess.axis;
    file.upReason = std::move(guess.reason);
    file.upInDoubt = guess.inDoubt;
}

void noteUnusedVertices(SourceFile& file) {
    std::vector<char> used(file.soup->positions.size(), 0);
    for (const int corner : file.soup->corners) {
        used[corner] = 1;
    }
    const auto unused = std::count(used.begin(), used.end(), 0);
    if (unused > 0) {
        file.problems.push_back(
            {ErrorCode::UnusedVertices, Subject::file(file.path.filename().string()),
             worded("%1 of %2", {countWording(unused, "vertex"), figure(double(used.size()))})});
    }
}

/// Distance within which to join vertices, mm, as for `weldSoup`.
std::optional<double> weldDistance(const LoadOptions& options) {
    return options.preparing.as == FileKind::Soup ? std::optional(options.preparing.weldDistance)
           : options.weld                         ? std::optional(0.0)
                                                  : std::nullopt;
}

/// The first note that something of the file was left out or changed on reading although the
/// options do not ask for it.
const Error* firstChange(const SourceFile& file, const LoadOptions& options) {
    const Preparation& preparing = options.preparing;
    const bool isReadingStated = preparing.as || preparing.onlyLayer > 0 ||
                                 (preparing.isHalf && file.reading.leftOut.F.rows() == 0);
    const auto found =
        std::find_if(file.problems.begin(), file.problems.end(), [&](const Error& problem) {
            return problem.code != ErrorCode::UnitGuessed &&
                   problem.code != ErrorCode::UnusedVertices &&
                   problem.code != ErrorCode::LooksLikeScan &&
                   !(problem.code == ErrorCode::ReadAs && isReadingStated) &&
                   !(problem.code == ErrorCode::VerticesWelded && weldDistance(options));
        });
    return found == file.problems.end() ? nullptr : &*found;
}

/// One file with everything up to its pieces.
struct TakenFile {
    std::shared_ptr<SourceFile> file;
    std::vector<std::shared_ptr<Piece>> pieces;
};

/// A single mesh of all pieces, without shared vertices.
MeshArrays joinedMesh(const std::vector<std::shared_ptr<Piece>>& pieces) {
    Eigen::Index vertices = 0, faces = 0;
    for (const auto& piece : pieces) {
        vertices += piece->mesh.V.rows();
        faces += piece->mesh.F.rows();
    }
    MeshArrays joined{Points3(vertices, 3), Triangles(faces, 3)};
    vertices = faces = 0;
    for (const auto& piece : pieces) {
        const MeshArrays& mesh = piece->mesh;
        joined.V.middleRows(vertices, mesh.V.rows()) = mesh.V;
        joined.F.middleRows(faces, mesh.F.rows()) =
            (mesh.F.array() + static_cast<int>(vertices)).matrix();
        vertices += mesh.V.rows();
        faces += mesh.F.rows();
    }
    return joined;
}

std::optional<DivisionCount> betterThan(const DividedFile& divided, const PolygonSoup& soup,
                                        const Progress& progress) {
    const auto flat =
        std::ranges::count_if(divided.pieces, [](const auto& piece) { return !piece->defect; });
    return flat == std::ssize(divided.pieces)
               ? std::nullopt
               : betterDivision(soup,
                                {divided.split.mode, static_cast<int>(divided.pieces.size()),
                                 static_cast<int>(flat)},
                                progress);
}

Result<TakenFile> takeFile(const ReadFile& read, int index, const std::string& prefix,
                           const LoadOptions& options, const Progress& progress) {
    const Stopwatch time;
    auto file = std::make_shared<SourceFile>();
    file->path = read.path;
    file->soup = read.soup;
    file->problems = read.soup->problems;
    chooseUnit(*file, options.unit, largestExtentOf(*read.soup));
    noteUnusedVertices(*file);
    const auto take = [&file](const Problems& problems) {
        file->problems.insert(file->problems.end(), problems.begin(), problems.end());
    };
    const std::string name = read.path.filename().string();
    const double millimetres = millimetresPer(file->unit);
    const Problems welded = weldSoup(file->soup, weldDistance(options), millimetres, name);
    take(welded);
    Result<PreparedFile> prepared =
        prepareFile(file->soup, !welded.empty() && !weldDistance(options), options.preparing,
                    millimetres, name, progress);
    if (!prepared) {
        return prepared.error();
    }
    if (options.preparing.isTurned) {
        prepared->soup = std::make_shared<const PolygonSoup>(turnedOver(*prepared->soup));
    }
    MeshArrays surface = surfaceOf(*prepared->soup, millimetres).mesh;
    surface.F = weldedFaces(surface);
    chooseUpAxis(*file, options.up, surface);
    takeHalf(*prepared, options.preparing, file->up, millimetres, name);
    file->soup = std::move(prepared->soup);
    file->reading = std::move(prepared->reading);
    take(prepared->problems);
    DividedFile divided = divide(*file, index, prefix, {options.split, !options.strict});
    if (divided.partCount > kMaxPiecesOfFile) {
        const Wording mode = std::string(toile::name(divided.split.mode));
        return Error{ErrorCode::MalformedFile, Subject::file(name),
                     worded("splitting by %1 gives %2 pieces, more than the limit of %3; split it "
                            "by something else, or join its parts in the modelling program",
                            {mode, figure(divided.partCount), figure(kMaxPiecesOfFile)})};
    }
    file->side = sideOfFaces(joinedMesh(divided.pieces));
    if (options.closeSlits) {
        closeSlits(divided.pieces);
    }
    if (options.split == SplitMode::Auto) {
        file->betterSplit = betterThan(divided, *file->soup, progress);
    }
    file->split = std::move(divided.split);
    take(divided.problems);
    if (options.strict) {
        if (const Error* change = firstChange(*file, options)) {
            return *change;
        }
    }
    file->readSeconds = read.seconds + time.seconds();
    return TakenFile{std::move(file), std::move(divided.pieces)};
}

/// Stems of the files, made unique, for piece names of a garment of several files.
std::vector<std::string> prefixes(const ReadFiles& files) {
    std::vector<std::string> stems;
    UniqueNames names;
    stems.reserve(files.size());
    for (const ReadFile& file : files) {
        stems.push_back(names.free(file.path.stem().string()));
    }
    return stems;
}

/// True if the same files are to be divided in the same way; joins, cuts and ease come later.
bool isDividedAlike(const GarmentInputs& inputs, GarmentInputs before) {
    before.loading.seams = inputs.loading.seams;
    before.loading.seamSettings = inputs.loading.seamSettings;
    before.loading.autoCut = inputs.loading.autoCut;
    before.loading.cutStyle = inputs.loading.cutStyle;
    return inputs == before;
}

/// The error for files without a usable face, with the reasons that their readers give.
Error noFaceLeft(const GarmentInputs& inputs,
                 const std::vector<std::shared_ptr<SourceFile>>& files) {
    Error error{ErrorCode::NoGeometry, {}, worded("no usable face is left")};
    if (!inputs.files.empty()) {
        error.subject = Subject::file(inputs.files.front().path.string());
    }
    for (const auto& file : files) {
        for (const Error& problem : file->problems) {
            if (problem.code == ErrorCode::NonFinitePosition ||
                problem.code == ErrorCode::DegenerateFaceRecord) {
                error.detail = worded("%1; %2", {error.detail, problem.detail});
            }
        }
    }
    return error;
}

/// The garment up to its uncut pieces.
Result<Garment> divideFiles(const GarmentInputs& inputs, const Progress& progress,
                            const Garment* before) {
    Garment garment;
    std::vector<std::shared_ptr<SourceFile>> files;
    std::vector<std::shared_ptr<Piece>> uncut;
    const std::vector<std::string> prefix = prefixes(inputs.files);
    const auto count = static_cast<double>(inputs.files.size());
    for (std::size_t k = 0; k < inputs.files.size(); ++k) {
        auto taken = takeFile(inputs.files[k], static_cast<int>(k),
                              inputs.files.size() > 1 ? prefix[k] + "/" : "", inputs.loading,
                              Progress(progress, 1 / count));
        if (!taken) {
            return taken.error();
        }
        files.push_back(std::move(taken->file));
        uncut.insert(uncut.end(), taken->pieces.begin(), taken->pieces.end());
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        progress.report(static_cast<double>(k + 1) / count);
    }
    if (uncut.empty()) {
        return noFaceLeft(inputs, files);
    }
    garment.files.assign(files.begin(), files.end());
    identify(uncut, garment.files, inputs.loading.known);
    nameSubjects(files, uncut);
    garment.uncut.assign(uncut.begin(), uncut.end());
    if (before) {
        reusePieces(garment.uncut, *before);
        garment.pieces = before->pieces;
        garment.cutRecords = before->cutRecords;
    }
    return garment;
}

}  // namespace

Result<ReadFiles> readFiles(const std::vector<fs::path>& paths, Progress& progress) {
    ReadFiles files;
    progress.start(1);
    for (const fs::path& path : paths) {
        const Stopwatch time;
        Progress one(progress, 1 / static_cast<double>(paths.size()));
        auto soup = readSoup(path, one);
        if (!soup) {
            return soup.error();
        }
        files.push_back(
            {path, std::make_shared<const PolygonSoup>(std::move(*soup)), time.seconds()});
        one.report(1);
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
    }
    return files;
}

Result<Garment> makeGarment(const GarmentInputs& inputs, Progress& progress,
                            const GarmentInputs& inputsBefore, const Garment* before) {
    if (before && isDividedAlike(inputs, inputsBefore)) {
        return cutGarment(*before, inputs.loading, progress);
    }
    const Result<Garment> divided = divideFiles(inputs, Progress(progress, kDividingShare), before);
    return divided ? cutGarment(*divided, inputs.loading, Progress(progress, 1 - kDividingShare))
                   : divided.error();
}

Result<Garment> loadGarment(const std::vector<fs::path>& paths, const LoadOptions& options,
                            Progress& progress) {
    progress.start(1);
    Progress reading(progress, kReadingShare), making(progress, 1 - kReadingShare);
    const Result<ReadFiles> files = readFiles(paths, reading);
    return files ? makeGarment({*files, options}, making) : files.error();
}

}  // namespace toile
