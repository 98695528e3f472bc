// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace toile {

/// One sentence across the window that waits for nobody: what went wrong, until it is closed.
class Banner : public QFrame {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent = nullptr);

    void showSentence(const QString& sentence);
    QString sentence() const;

private:
    QLabel* label_;
};

}  // namespace toile
