// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace toile {

/// A slim card over the views that offers what a crash has left: a sentence, "Restore" and
/// "Discard". Waits for nobody.
class RecoveryCard : public QFrame {
    Q_OBJECT

public:
    explicit RecoveryCard(QWidget* parent = nullptr);

    void offer(const QString& sentence);
    QString sentence() const;

signals:
    void restoreWanted();
    void discardWanted();

private:
    QLabel* label_;
};

}  // namespace toile
