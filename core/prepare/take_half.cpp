// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/take_half.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/prepare/complete_half.h"
#include "core/prepare/file_surface.h"
#include "core/prepare/half_plane.h"

namespace toile {
namespace {

/// "x = 12.5 mm", or a point on the plane.
Wording planeWording(const Eigen::Hyperplane<double, 3>& plane) {
    const Eigen::Vector3d foot = plane.projection(Eigen::Vector3d::Zero());
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(plane.normal()[axis]) == 1) {
            constexpr const char* kNames[] = {"x", "y", "z"};
            return worded("the plane %1 = %2 mm", {Wording(kNames[axis]), figure(foot[axis], 1)});
        }
    }
    return worded("the upright plane through %1 mm", {placeWording(foot.x(), foot.y(), foot.z())});
}

/// Files that only look like their kind, without certainty, are not tested for halves.
bool mayBeHalf(const FileReading& reading) {
    return reading.kind != FileKind::Solid && (reading.kind != FileKind::Scan || reading.isStated);
}

}  // namespace

void takeHalf(PreparedFile& file, const Preparation& preparation, UpAxis up, double millimetres,
              const std::string& name) {
    if (!preparation.isHalf && !mayBeHalf(file.reading)) {
        return;
    }
    const FileSurface surface = surfaceOf(*file.soup, millimetres);
    std::optional<HalfPlane>& half = file.reading.half;
    half = findHalfPlane(surface, up, preparation.isHalf);
    if (!preparation.isHalf) {
        return;
    }
    auto whole =
        half ? completeHalf(*file.soup, half->plane, halfTolerance(surface.mesh), millimetres)
             : std::nullopt;
    if (!whole) {
        half.reset();
        file.problems.push_back(
            {ErrorCode::CannotReadAs, Subject::file(name),
             worded("half a garment has rims in an upright plane, all cloth on one side of it, and "
                    "there is no such plane; see which axis points up")});
        return;
    }
    const int faces = file.soup->faceCount();
    half->isCompleted = true;
    std::vector<int>& layers = file.reading.layerOfFace;
    layers.reserve(2 * layers.size());
    std::copy_n(layers.begin(), layers.size(), std::back_inserter(layers));
    file.soup = std::make_shared<const PolygonSoup>(std::move(whole->soup));
    file.problems.push_back(
        {ErrorCode::ReadAs, Subject::file(name),
         worded(
             "half a garment: the mirror image of its %1 was added, joined over %2 mm in %3",
             {countWording(faces, "face"), figure(half->length, 0), planeWording(half->plane)})});
}

}  // namespace toile
