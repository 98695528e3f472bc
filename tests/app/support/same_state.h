// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/document/document_state.h"

namespace toile::test {

/// What of two states is not the same to the last bit, a word or two; empty where all is. Garment,
/// what is said of it and its pieces by value or pointer; results by their positions and errors;
/// scenes by their buffers.
QString difference(const DocumentState& one, const DocumentState& other);

}  // namespace toile::test
