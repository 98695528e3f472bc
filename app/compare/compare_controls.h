// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <vector>

#include "core/flatten/method.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace toile {

/// Side by side there is room for so many.
inline constexpr std::size_t kMostCompared = 4;

/// What is compared: one piece, up to four methods, and how far the work has come.
class CompareControls : public QWidget {
    Q_OBJECT

public:
    explicit CompareControls(QWidget* parent = nullptr);

    void setPieces(const QStringList& names, int chosen);
    /// @param methods  at most `kMostCompared`
    void setMethods(const std::vector<Method>& methods);
    /// Those that are ticked, in the order of `allMethods`.
    std::vector<Method> methods() const;
    void showWork(bool busy, bool stopped, double fraction);
    void showFraction(double fraction);

signals:
    void pieceChosen(int piece);
    void methodsChosen();
    void stopWanted();
    void goOnWanted();

private:
    void limitMethods();

    QComboBox* piece_;
    std::map<Method, QCheckBox*> boxes_;
    QLabel* work_;
    QProgressBar* progress_;
    QPushButton* button_;
    bool stopped_ = false;
};

}  // namespace toile
