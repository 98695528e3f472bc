// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::app {

/// That work at one garment; OpenBLAS has memory for no more.
inline constexpr int kMostThreads = 64;

}  // namespace toile::app
