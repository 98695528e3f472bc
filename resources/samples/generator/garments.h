// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "piece.h"

namespace toile::samples {

/// Crew-neck T-shirt with set-in sleeves and a neckband.
Garment makeTshirt();

/// Fitted hip-length bodice with princess seams from the shoulder over the bust.
Garment makeBodice();

/// Straight trousers with a waistband.
Garment makeTrousers();

/// Six-panel cap with a peak.
Garment makeCap();

/// Flared six-gore skirt with a waistband.
Garment makeSkirt();

}  // namespace toile::samples
