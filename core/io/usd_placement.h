// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/io/usd_text.h"

namespace toile::io {

/// Where a prim's own coordinates lie in the world, from where its parent's do: by the operations
/// of its `xformOpOrder`. None where one cannot be understood. Pure.
std::optional<Eigen::Matrix4d> usdPlacement(const UsdPrim& prim, const Eigen::Matrix4d& parent);

}  // namespace toile::io
