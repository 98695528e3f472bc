// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/views/play_bar.h"

namespace toile::app {

class Document;
class GarmentView;
class PatternView;
class RolledPiece;

/// The walk along the selected seam, at the bottom of the pattern view. One side's piece rolls
/// along the other's, and the bar shows both lengths. Hidden until `begin`. If another seam is
/// selected, the walk continues there. Escape or a selection without a sewn seam ends it.
class WalkBar : public PlayBar {
    Q_OBJECT

public:
    /// @param pattern  parent and owner  @param garment  marks the place on the seam
    WalkBar(Document& document, PatternView& pattern, GarmentView& garment);
    ~WalkBar() override;

    /// Walks the selected seam from its start and frames the whole walk. Does nothing if the seam
    /// has no partner or a side is not flat.
    void begin();
    void end();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Updates the walk to the selected seam.
    void follow();
    void roll(double share);
    void showNow();
    /// The text, in two lines.
    QString reading() const;
    static QString notchText(const std::vector<double>& notches, double share);

    Document& document_;
    PatternView& pattern_;
    GarmentView& garment_;
    QLabel* reading_;
    std::shared_ptr<RolledPiece> rolled_;  ///< null: no walk is active
};

}  // namespace toile::app
