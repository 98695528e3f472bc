// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::app {

/// What is sewn back together.
enum class SewnPattern {
    Own,        ///< the document's, as it is written to a file and read back
    Designer,   ///< the designer's own panels, where the garment's file has them
    Reference,  ///< the reference pattern that is open
};

}  // namespace toile::app
