// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/prepare_file.h"

#include <utility>
#include <vector>

#include "core/prepare/layers.h"
#include "core/prepare/recognise.h"
#include "core/prepare/scan.h"

namespace toile {
namespace {

constexpr double kSquareMillimetresPerSquareCentimetre = 100;

/// Only these faces of the file, without unused positions.
MeshArrays facesOf(const FileSurface& surface, const std::vector<int>& faces) {
    std::vector<char> isWanted(surface.face.empty() ? 0U : std::size_t(surface.face.back()) + 1, 0);
    for (const int face : faces) {
        if (static_cast<std::size_t>(face) < isWanted.size()) {
            isWanted[face] = 1;
        }
    }
    std::vector<int> number(static_cast<std::size_t>(surface.mesh.V.rows()), -1);
    std::vector<int> used, corners;
    for (std::size_t f = 0; f < surface.face.size(); ++f) {
        for (int k = 0; k < 3 && isWanted[surface.face[f]]; ++k) {
            const int v = surface.mesh.F(static_cast<Eigen::Index>(f), k);
            if (number[v] < 0) {
                number[v] = static_cast<int>(used.size());
                used.push_back(v);
            }
            corners.push_back(number[v]);
        }
    }
    MeshArrays mesh{surface.mesh.V(used, Eigen::all), Triangles(std::ssize(corners) / 3, 3)};
    std::ranges::copy(corners, mesh.F.data());
    return mesh;
}

/// Replaces the file by one surface of a shell.
void takeSurface(PreparedFile& file, const FileSurface& surface, const Shell& shell,
                 ShellSurface which, const std::string& name) {
    LeftOut out = leftOut(surface, shell, which);
    const auto rims = static_cast<long long>(out.rims.size());
    const auto others = static_cast<long long>(out.other.size());
    const char* pattern = which == ShellSurface::Outer
                              ? translatable(
                                    "a thick shell, %1: the outer surface is used; %2 of the inner "
                                    "one and %3 of rims are left out")
                          : which == ShellSurface::Inner
                              ? translatable(
                                    "a thick shell, %1: the inner surface is used; %2 of the outer "
                                    "one and %3 of rims are left out")
                              : translatable(
                                    "a thick shell, %1: the middle between its surfaces is used; "
                                    "%2 of the inner surface and %3 of rims are left out");
    file.problems.push_back({ErrorCode::ReadAs, Subject::file(name),
                             worded(pattern, {file.reading.evidence, countWording(others, "face"),
                                              countWording(rims, "face")})});
    out.other.insert(out.other.end(), out.rims.begin(), out.rims.end());
    file.reading.leftOut = facesOf(surface, out.other);
    file.soup = std::make_shared<const PolygonSoup>(sheetOf(*file.soup, surface, shell, which));
}

/// Stores the layer of each face; if a single layer is wanted, the file is reduced to it.
/// @param only  the outermost is 1; 0: all
void takeLayers(PreparedFile& file, const FileSurface& surface, const Layers& layers, int only,
                const std::string& name) {
    std::vector<int> layerOfFace(static_cast<std::size_t>(file.soup->faceCount()), 0);
    for (std::size_t t = 0; t < layers.of.size(); ++t) {
        layerOfFace[surface.face[t]] = layers.of[t];
    }
    if (only > layers.count) {
        file.problems.push_back({ErrorCode::CannotReadAs, Subject::file(name),
                                 worded("there is no layer %1 among the %2 layers, so all are used",
                                        {figure(only), figure(layers.count)})});
        only = 0;
    }
    if (only == 0) {
        file.reading.layerOfFace = std::move(layerOfFace);
        return;
    }
    std::vector<int> kept, others;
    for (std::size_t f = 0; f < layerOfFace.size(); ++f) {
        (layerOfFace[f] == only - 1 ? kept : others).push_back(static_cast<int>(f));
    }
    file.problems.push_back({ErrorCode::ReadAs, Subject::file(name),
                             worded("%1 layers of cloth, %2 mm apart: layer %3 from outside is "
                                    "used, with %4; %5 of the others are left out",
                                    {figure(layers.count), figure(layers.apart, 1), figure(only),
                                     countWording(std::ssize(kept), "face"),
                                     countWording(std::ssize(others), "face")})});
    file.reading.leftOut = facesOf(surface, others);
    file.soup = std::make_shared<const PolygonSoup>(withFaces(*file.soup, kept));
}

/// Reads a file that the user declared as layers, or from which one layer is wanted.
void readLayers(PreparedFile& file, const FileSurface& surface, int only, const std::string& name,
                const Progress& progress) {
    if (const auto layers = findLayers(surface, progress)) {
        file.reading.kind = FileKind::Layers;
        file.reading.evidence = inWords(*layers);
        takeLayers(file, surface, *layers, only, name);
        return;
    }
    file.problems.push_back(
        {ErrorCode::CannotReadAs, Subject::file(name),
         worded("no connected part lies inside another; layers that share vertices are one part")});
    file.reading.isStated = false;
}

Wording inWords(const ScanEffect& effect, const ScanSteps& steps) {
    Wording words = worded("a scan of %1", {countWording(effect.trianglesBefore, "triangle")});
    if (effect.fragments > 0) {
        words += worded("; %1 of %2 cm² removed",
                        {countWording(effect.fragments, "fragment"),
                         figure(effect.debrisArea / kSquareMillimetresPerSquareCentimetre, 1)});
    }
    if (effect.holes > 0) {
        words += worded("; %1 closed with %2 cm²",
                        {countWording(effect.holes, "hole"),
                         figure(effect.patchArea / kSquareMillimetresPerSquareCentimetre, 1)});
    }
    if (effect.isSurface) {
        words += worded("; %1 left", {countWording(effect.openings, "opening")});
    }
    if (effect.largestMove > 0) {
        words += worded("; noise smoothed by %1 mm on average, %2 mm at most",
                        {figure(effect.meanMove, 2), figure(effect.largestMove, 2)});
    }
    if (!effect.isSurface) {
        words += worded("; it is not a clean surface, so holes and noise are not treated");
    } else if (effect.isRemeshed) {
        words += worded("; remeshed to %1 with edges of about %2 mm",
                        {countWording(effect.triangles, "triangle"), figure(steps.edgeLength, 1)});
    } else if (steps.edgeLength > 0) {
        words += worded("; it could not be remeshed");
    }
    return words;
}

Result<void> takeScan(PreparedFile& file, const ScanSteps& steps, double millimetres,
                      const std::string& name, const Progress& progress) {
    Progress part(progress, 1);
    Result<PreparedScan> made = prepareScan(*file.soup, millimetres, steps, part);
    if (!made) {
        return made.error();
    }
    file.problems.push_back({ErrorCode::ReadAs, Subject::file(name), inWords(made->effect, steps)});
    for (Error& repair : made->effect.repairs) {
        repair.subject = Subject::file(name);
        file.problems.push_back(std::move(repair));
    }
    if (!made->debris.empty()) {
        file.reading.leftOut = facesOf(surfaceOf(*file.soup, millimetres), made->debris);
    }
    file.soup = std::make_shared<const PolygonSoup>(std::move(made->soup));
    return {};
}

}  // namespace

Result<PreparedFile> prepareFile(std::shared_ptr<const PolygonSoup> soup, bool wasSoup,
                                 const Preparation& preparation, double millimetres,
                                 const std::string& name, const Progress& progress) {
    PreparedFile file{std::move(soup), {}, {}};
    FileReading& reading = file.reading;
    reading.isStated = preparation.as.has_value();
    const bool areLayers =
        preparation.as == FileKind::Layers || (!reading.isStated && preparation.onlyLayer > 0);
    if (areLayers) {
        readLayers(file, surfaceOf(*file.soup, millimetres), preparation.onlyLayer, name, progress);
    } else if (!reading.isStated || *preparation.as == FileKind::Shell) {
        const FileSurface surface = surfaceOf(*file.soup, millimetres);
        const Recognition found = recognise(surface, progress);
        reading.kind = found.kind;
        reading.evidence = found.evidence;
        if (found.shell && (reading.isStated || found.kind == FileKind::Shell)) {
            takeSurface(file, surface, *found.shell, preparation.surface, name);
        } else if (reading.isStated) {
            file.problems.push_back({ErrorCode::CannotReadAs, Subject::file(name),
                                     worded("no two surfaces a thickness apart were found")});
            reading.isStated = false;
        } else if (found.layers && found.layers->isSure) {
            takeLayers(file, surface, *found.layers, 0, name);
        } else if (wasSoup && reading.kind == FileKind::Sheet) {
            reading.kind = FileKind::Soup;
        }
    }
    if (reading.isStated) {
        reading.kind = *preparation.as;
    }
    if (reading.kind == FileKind::Scan && reading.isStated) {
        const Result<void> taken = takeScan(file, preparation.scan, millimetres, name, progress);
        if (!taken) {
            return taken.error();
        }
    } else if (reading.kind == FileKind::Scan) {
        file.problems.push_back({ErrorCode::LooksLikeScan, Subject::file(name), reading.evidence});
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    return file;
}

}  // namespace toile
