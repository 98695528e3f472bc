// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/play_bar.h"

namespace toile::app {

class Document;
class GarmentView;

/// The way from the garment to the pattern, at the foot of the garment view. Hidden where nothing
/// is flat.
class MorphBar : public PlayBar {
    Q_OBJECT

public:
    /// @param view  where it lies; owns it
    MorphBar(Document& document, GarmentView& view);

private:
    void showOrHide();

    Document& document_;
};

}  // namespace toile::app
