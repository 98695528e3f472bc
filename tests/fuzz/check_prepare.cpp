// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/check_prepare.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/toile/pipeline.h"
#include "tests/core/io/soup_promises.h"
#include "tests/fuzz/check_garment.h"
#include "tests/fuzz/check_reader.h"

namespace toile::fuzz {
namespace {

constexpr int kMaxPreparedFaces = 400;
constexpr std::size_t kMaxPreparedBytes = 16 * 1024;
constexpr std::size_t kPreparationBytes = 6;
/// The file's size in its shortest triangles: a fuzzer wants many runs.
constexpr double kMaxEdges = 24;

/// Corners whose positions are no numbers.
std::ptrdiff_t strayCorners(const PolygonSoup& soup) {
    return std::ranges::count_if(soup.corners, [&soup](int corner) {
        return !soup.positions[static_cast<std::size_t>(corner)].allFinite();
    });
}

bool isSame(const PolygonSoup& a, const PolygonSoup& b) {
    const auto bits = [](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
        return std::ranges::equal(
            x, y, [](double p, double q) { return p == q || (std::isnan(p) && std::isnan(q)); });
    };
    return std::ranges::equal(a.positions, b.positions, bits) && a.corners == b.corners &&
           a.faceStart == b.faceStart && a.cornerUvs == b.cornerUvs && a.faceGroup == b.faceGroup &&
           a.faceMaterial == b.faceMaterial;
}

std::string brokenByReading(const SourceFile& file, const PolygonSoup& before) {
    if (std::string broken = test::brokenPromise(*file.soup); !broken.empty()) {
        return broken;
    }
    const bool isDoubled = file.reading.half && file.reading.half->isCompleted;
    if (strayCorners(*file.soup) > (isDoubled ? 2 : 1) * strayCorners(before)) {
        return "a position has become no number";
    }
    const FileReading& reading = file.reading;
    const MeshArrays& out = reading.leftOut;
    if (!out.V.allFinite() ||
        (out.F.size() > 0 && (out.F.minCoeff() < 0 || out.F.maxCoeff() >= out.V.rows()))) {
        return "what is left out is no mesh";
    }
    const auto& layers = reading.layerOfFace;
    if (!layers.empty() &&
        (std::ssize(layers) != file.soup->faceCount() || *std::ranges::min_element(layers) < 0)) {
        return "a face has no layer";
    }
    return "";
}

bool says(const Problems& problems, ErrorCode code) {
    return std::ranges::find(problems, code, &Error::code) != problems.end();
}

/// A byte as a part of the whole.
double partOf(char byte) {
    return static_cast<double>(static_cast<unsigned char>(byte)) / 255;
}

/// The largest extent of a file's box.
double sizeOf(const PolygonSoup& soup) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : soup.positions) {
        if (position.allFinite()) {
            box.extend(position);
        }
    }
    return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

Preparation preparationOf(const std::string& bytes, double size) {
    const auto byte = [&bytes](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const auto length = [&](std::size_t i, double most) {
        return std::min(partOf(bytes[i]) * most * size, kMaxPreparedLength);
    };
    constexpr std::size_t kKinds = std::size(kFileKindWords);
    Preparation preparing;
    if (const std::size_t kind = byte(0) % (kKinds + 1); kind < kKinds) {
        preparing.as = kFileKindWords[kind].first;
    }
    preparing.surface = kShellSurfaceWords[byte(1) % std::size(kShellSurfaceWords)].first;
    preparing.scan.dropDebris = byte(1) / 8 % 2 == 0;
    preparing.isHalf = byte(2) % 2 == 1;
    preparing.onlyLayer = byte(2) / 2 % 4;
    preparing.scan.largestHole = length(3, 4);
    preparing.scan.smoothing = length(4, 0.1);
    preparing.weldDistance = length(4, 0.1);
    preparing.scan.edgeLength = byte(5) < 64 ? 0 : std::max(length(5, 0.5), size / kMaxEdges);
    return preparing;
}

}  // namespace

std::string whatBreaksInPreparing(const std::shared_ptr<const PolygonSoup>& soup,
                                  const Preparation& preparing) {
    const GarmentInputs inputs{{{"fuzz.off", soup}},
                               {.unit = LengthUnit::Millimetre,
                                .preparing = preparing,
                                .autoCut = true,
                                .cutStyle = CutStyle::Auto}};
    Progress progress;
    const Result<Garment> made = makeGarment(inputs, progress);
    const Result<Garment> again = makeGarment(inputs, progress);
    if (made.ok() != again.ok()) {
        return "once a garment, once none";
    }
    if (!made) {
        return made.error().code == ErrorCode::NoGeometry && !made.error().detail.empty()
                   ? ""
                   : "refused without a proper reason: " + sentence(made.error());
    }
    const SourceFile& file = *made->files.front();
    if (!isSame(*file.soup, *again->files.front()->soup)) {
        return "prepared twice, it is not the same";
    }
    if (std::string broken = brokenByReading(file, *soup); !broken.empty()) {
        return broken;
    }
    if (preparing.as && file.reading.kind != *preparing.as &&
        !says(file.problems, ErrorCode::CannotReadAs)) {
        return "it is read otherwise than stated, and nothing says so";
    }
    for (const auto& piece : made->uncut) {
        if (std::string broken = whatBreaksIn(*piece, *file.soup); !broken.empty()) {
            return broken;
        }
    }
    return whatBreaksIn(*made);
}

std::string whatBreaksInPreparing(std::string bytes) {
    if (bytes.size() > kMaxPreparedBytes || bytes.size() < kPreparationBytes) {
        return "";
    }
    Progress progress;
    auto soup = readOff(std::make_shared<const std::string>(bytes.substr(kPreparationBytes)),
                        "fuzz", progress);
    if (!soup || soup->faceCount() > kMaxPreparedFaces) {
        return "";
    }
    const Preparation preparing = preparationOf(bytes, sizeOf(*soup));
    return whatBreaksInPreparing(std::make_shared<const PolygonSoup>(std::move(*soup)), preparing);
}

}  // namespace toile::fuzz
