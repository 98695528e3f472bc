// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/check/finding.h"

namespace toile {

/// How a kind of finding is told. %1, %2 ... stand for the figures in their order, %0 for the
/// reason. The window translates these words and writes the numbers in the person's units.
struct FindingWords {
    const char* title;     ///< of several findings of the kind: "Seams that do not match"
    const char* describe;  ///< what is the matter; empty where the finding's error says it
    const char* advice;    ///< what to try; likewise
};

const FindingWords& findingWords(FindingKind kind);

/// What was found, without the place and without what to try: "the flat sides of the seam differ
/// by 3.20 mm ...". English, millimetres.
std::string description(const Finding& finding);
/// What to try, as a sentence without a full stop; empty where nothing is needed.
std::string adviceFor(const Finding& finding);
/// One sentence for a person, like those of errors: where, what, what to try.
std::string sentence(const Finding& finding);

}  // namespace toile
