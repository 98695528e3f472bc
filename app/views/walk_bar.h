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

/// The walk of the selected seam, at the foot of the pattern view: the piece of one side rolls
/// along that of the other, and the bar says how far both have come. Hidden until it is asked for.
/// Another selected seam is walked in its place; Escape ends it, as does a selection that is no
/// sewn seam.
class WalkBar : public PlayBar {
    Q_OBJECT

public:
    /// @param pattern  where it lies; owns it  @param garment  shows the place on the seam
    WalkBar(Document& document, PatternView& pattern, GarmentView& garment);
    ~WalkBar() override;

    /// Walks the selected seam from its start, and shows all of the way; nothing where it is sewn
    /// to nothing, or a side is not flat.
    void begin();
    void end();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// The selected seam, as it is now.
    void follow();
    void roll(double share);
    void showNow();
    /// In two lines.
    QString reading() const;
    static QString notchText(const std::vector<double>& notches, double share);

    Document& document_;
    PatternView& pattern_;
    GarmentView& garment_;
    QLabel* reading_;
    std::shared_ptr<RolledPiece> rolled_;  ///< null: nothing is walked
};

}  // namespace toile::app
