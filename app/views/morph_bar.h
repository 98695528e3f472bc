// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QSlider;
class QToolButton;
class QVariantAnimation;

namespace toile::app {

class Document;
class GarmentView;

/// The way from the garment to the pattern, at the foot of the garment view: a slider, and a button
/// that plays it. Hidden where nothing is flat.
class MorphBar : public QWidget {
    Q_OBJECT

public:
    /// @param view  where it lies; owns it
    MorphBar(Document& document, GarmentView& view);

    /// Goes to the other end of the way by itself; called again, it stops.
    void play();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    void showOrHide();

    Document& document_;
    GarmentView& view_;
    QSlider* slider_;
    QToolButton* button_;
    QVariantAnimation* animation_;
};

}  // namespace toile::app
