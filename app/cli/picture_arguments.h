// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/document/view_state.h"

namespace toile::app {

/// What a picture is to show, for `toile render`.
struct PictureArguments {
    int width = 1600, height = 800;  ///< pixels, within kMinPicture and kMaxPicture
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< none: as the window begins
    double morph = 0;                          ///< 0 to 1
    bool wireframe = false, xray = false, seams = true;
    std::optional<bool> bar{};  ///< none: where the overlay is measured
    bool dark = false;
    /// Pixels of a square for file managers, which wins over the size: the garment alone. 0: no
    /// thumbnail.
    int thumbnail = 0;
};

inline constexpr int kMinPicture = 16, kMaxPicture = 8192;

/// Width and height, as in "1600x800". @return what is wrong, or nothing
std::string readPictureSize(const std::string& typed, PictureArguments& picture);
/// From where the garment is seen: the name of a side, or two angles in degrees, as in "30,10".
/// @return what is wrong, or nothing
std::string readPictureLook(const std::string& typed, PictureArguments& picture);

}  // namespace toile::app
