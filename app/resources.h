// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// Makes shaders and icons known: a static library's resources are left out by the linker unless
/// asked for. To be called before the first window is made; again does no harm.
void loadResources();

}  // namespace toile
