// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <vector>

#include "core/flatten/base/flat_piece.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace toile::app {

class Document;
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

}  // namespace toile::app
