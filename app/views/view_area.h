// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QSplitter;

namespace toile {

class ColourBar;
class Document;
class GarmentView;
class PatternView;

/// Both views side by side over the overlay's legend; a sentence in their place where this
/// computer cannot draw them.
class ViewArea : public QWidget {
    Q_OBJECT

public:
    explicit ViewArea(Document& document, QWidget* parent = nullptr);

    /// Null where there is no OpenGL 3.3.
    GarmentView* garmentView() const { return garmentView_; }
    PatternView* patternView() const { return patternView_; }

    void frameSelection();
    /// Shows both sides of the selected seam.
    void frameSeam();
    /// True once both views show the present scene.
    bool isUpToDate() const;

private:
    void makeViews();
    void updateLegend();

    Document& document_;
    QSplitter* splitter_;
    ColourBar* legend_;
    GarmentView* garmentView_ = nullptr;
    PatternView* patternView_ = nullptr;
};

}  // namespace toile
