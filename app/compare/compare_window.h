// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>

#include "app/compare/compare_controls.h"
#include "app/compare/compared_picture.h"
#include "app/compare/method_comparison.h"

namespace toile::app {

class ColourBar;
class ComparedColumn;
class FigureTable;

/// One piece by up to four methods, side by side: pictures of one scale under one colour bar, and a
/// table of figures. Stays open beside the work and follows it; once closed it works no more.
class CompareWindow : public QDialog {
    Q_OBJECT

public:
    /// @param ordinary  the window's own jobs
    CompareWindow(Document& document, const JobRunner& ordinary, QWidget* parent);
    ~CompareWindow() override;

    MethodComparison& comparison() { return comparison_; }
    const LinkedCamera& camera() const { return camera_; }

signals:
    /// The garment is to be flattened by this method.
    void methodWanted(toile::Method method);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool event(QEvent* event) override;

private:
    void makeLayout(const QString& glProblem);
    void onDocumentChanged(DocumentChanges what);
    void refresh();
    void showPictures();
    void alignTable();
    PictureLook look() const;

    Document& document_;
    LinkedCamera camera_;
    MethodComparison comparison_;
    CompareControls* controls_;
    std::array<ComparedColumn*, kMaxCompared> columns_{};
    QWidget* pictures_;
    ColourBar* legend_;
    FigureTable* table_;
};

}  // namespace toile::app
