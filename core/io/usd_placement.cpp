// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/usd_placement.h"

#include <numbers>
#include <string_view>

#include <Eigen/Geometry>

namespace toile::io {
namespace {

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr std::string_view kInvert = "!invert!", kReset = "!resetXformStack!", kOp = "xformOp:";

Eigen::Matrix3d turnAround(char axis, double degrees) {
    return AngleAxisd(degrees * kRadiansPerDegree, Vector3d::Unit(axis - 'X')).toRotationMatrix();
}

/// "rotateXYZ": around x first, then around y and z. One axis, or all three.
std::optional<Affine3d> rotation(std::string_view axes, const std::vector<double>& degrees) {
    if (axes.empty() || degrees.size() != axes.size() ||
        axes.find_first_not_of("XYZ") != std::string_view::npos) {
        return {};
    }
    Affine3d turned = Affine3d::Identity();
    for (const char axis : axes) {
        const std::size_t k = axes.size() == 1 ? 0 : static_cast<std::size_t>(axis - 'X');
        turned = turnAround(axis, degrees[k]) * turned;
    }
    return turned;
}

/// @param kind  "translate", "rotateX" ...
std::optional<Affine3d> operation(std::string_view kind, const std::vector<double>& numbers) {
    const auto vector = [&numbers] { return Vector3d(numbers[0], numbers[1], numbers[2]); };
    if (kind == "translate" && numbers.size() == 3) {
        return Affine3d(Eigen::Translation3d(vector()));
    }
    if (kind == "scale" && numbers.size() == 3) {
        return Affine3d(Eigen::Scaling(vector()));
    }
    if (kind == "orient" && numbers.size() == 4) {
        const Eigen::Quaterniond turn(numbers[0], numbers[1], numbers[2], numbers[3]);
        return turn.norm() > 0 ? std::optional(Affine3d(turn.normalized())) : std::nullopt;
    }
    if (kind == "transform" && numbers.size() == 16) {
        Affine3d placed;
        placed.matrix() = Eigen::Map<const Matrix4d>(numbers.data());  // rows there, columns here
        return placed;
    }
    return kind.starts_with("rotate") ? rotation(kind.substr(6), numbers) : std::nullopt;
}

}  // namespace

std::optional<Matrix4d> usdPlacement(const UsdPrim& prim, const Matrix4d& parent) {
    Matrix4d placed = parent;
    const std::string* order = prim.find("xformOpOrder");
    for (const std::string& stated : order ? usdStrings(*order) : std::vector<std::string>()) {
        std::string_view name = stated;
        if (name == kReset) {
            placed = Matrix4d::Identity();
            continue;
        }
        const bool isInverse = name.starts_with(kInvert);
        name.remove_prefix(isInverse ? kInvert.size() : 0);
        const auto numbers = usdNumbersOf(prim, std::string(name));
        if (!numbers || !name.starts_with(kOp)) {
            return {};
        }
        std::string_view kind = name.substr(kOp.size());
        kind = kind.substr(0, kind.find(':'));
        const auto step = operation(kind, *numbers);
        if (!step) {
            return {};
        }
        placed = placed * (isInverse ? Matrix4d(step->matrix().inverse()) : step->matrix());
    }
    return placed.allFinite() ? std::optional(placed) : std::nullopt;
}

}  // namespace toile::io
