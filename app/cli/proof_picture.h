// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/prove/proof.h"

namespace toile::app {

struct Arguments;

/// The bytes of a PNG file that shows a proof as the arguments ask; empty where nothing can be
/// drawn here.
using DrawProof = std::string (*)(const ExportSource& source,
                                  const std::shared_ptr<const Proof>& proof,
                                  const Arguments& arguments);

/// For who can draw, before the command runs.
void provideProofPictures(DrawProof draw);
/// Null where nobody can.
DrawProof proofPictures();

}  // namespace toile::app
