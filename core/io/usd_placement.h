// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/io/usd_text.h"

namespace toile::io {

/// The transform from a prim's own coordinates to the world, from its parent's transform and the
/// operations of its `xformOpOrder`. Nothing if one is not understood. Pure.
std::optional<Eigen::Matrix4d> usdPlacement(const UsdPrim& prim, const Eigen::Matrix4d& parent);

}  // namespace toile::io
