// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/reading/dxf_document.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// The unit of a DXF pattern and how it is known. "Units: METRIC" means millimetres by the
/// standard, but files in centimetres say so too, ENGLISH inches; $INSUNITS is often wrong. So what
/// the file says counts where pieces then have a size that cloth has, else their size tells; either
/// way it is said what is in doubt.
struct DxfUnit {
    LengthUnit unit = LengthUnit::Millimetre;
    Wording reason{};
    bool inDoubt = false;
};

/// The unit that $INSUNITS names; none if there is none.
std::optional<LengthUnit> headerUnit(const DxfDocument& document);

/// @param units   the value of the text "Units"; empty: none
/// @param extent  of the largest piece, in the file's unit; 0: not known
DxfUnit dxfUnit(const DxfDocument& document, const std::string& units, double extent);

}  // namespace toile
