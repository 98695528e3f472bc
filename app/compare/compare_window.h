// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QWidget>
#include <array>
#include <map>
#include <vector>

#include "app/compare/compared_picture.h"
#include "app/compare/method_comparison.h"
#include "core/flatten/base/flat_piece.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace toile::app {

class ColourBar;
class ComparedColumn;
class Document;
class FigureTable;
class MethodComparison;

/// Side by side there is room for so many.
inline constexpr std::size_t kMaxCompared = 4;

/// What is compared: one piece, up to four methods, and how far the work has come.
class CompareControls : public QWidget {
    Q_OBJECT

public:
    CompareControls(const Document& document, MethodComparison& comparison,
                    QWidget* parent = nullptr);

    /// Proposes the selected piece, or the first flat one, and, unless a person has chosen methods,
    /// the present one and those that tell most beside it.
    void propose();

private:
    void makeLayout();
    std::vector<Method> ticked() const;
    void refresh();
    void showPieces();
    void limitMethods();
    void showWork();

    const Document& document_;
    MethodComparison& comparison_;
    QComboBox* piece_;
    std::map<Method, QCheckBox*> boxes_;
    QLabel* work_;
    QProgressBar* progress_;
    QPushButton* button_;    ///< cancels, or goes on
    bool isChosen_ = false;  ///< the methods, by the person
};

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
