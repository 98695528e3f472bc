// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace toile {

/// Content of a drawing's layer; each writer defines its name and colour.
enum class LayerKind { Cut, Sew, Notches, Internal, Marks, Grain, Text, Check };

/// Every kind, in the order in which layers are written. Seam line, notches, internal lines and
/// grain are left out if they are empty.
inline constexpr std::array kLayerKinds{LayerKind::Cut,      LayerKind::Sew,   LayerKind::Notches,
                                        LayerKind::Internal, LayerKind::Marks, LayerKind::Grain,
                                        LayerKind::Text,     LayerKind::Check};

}  // namespace toile
