// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/targets.h"

#include <array>
#include <utility>

#include "core/io/usda_reader.h"
#include "tests/fuzz/check_documents.h"
#include "tests/fuzz/check_garment.h"
#include "tests/fuzz/check_patterns.h"
#include "tests/fuzz/check_prepare.h"
#include "tests/fuzz/check_reader.h"

namespace toile::fuzz {
namespace {

template <ReadFunction reader>
std::string whatBreaksIn(std::string bytes) {
    return whatBreaks(reader, std::move(bytes));
}

constexpr std::array<Target, 16> kTargets = {{{"obj", whatBreaksIn<readObj>},
                                              {"off", whatBreaksIn<readOff>},
                                              {"ply", whatBreaksIn<readPly>},
                                              {"stl", whatBreaksIn<readStl>},
                                              {"usdmesh", whatBreaksIn<readUsd>},
                                              {"project", whatBreaksInProject},
                                              {"seams", whatBreaksInSeams},
                                              {"dxf", whatBreaksInDxf},
                                              {"svg", whatBreaksInSvg},
                                              {"garmentcode", whatBreaksInGarmentCode},
                                              {"pdf", whatBreaksInPdf},
                                              {"plt", whatBreaksInPlt},
                                              {"glb", whatBreaksInGlb},
                                              {"usda", whatBreaksInUsda},
                                              {"prepare", whatBreaksInPreparing},
                                              {"garment", whatBreaksOnTheWay}}};

}  // namespace

std::span<const Target> targets() {
    return kTargets;
}

}  // namespace toile::fuzz
