// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace toile::app {

/// One sentence across the window; not modal, hidden at first.
class SentenceBar : public QFrame {
    Q_OBJECT

public:
    void showSentence(const QString& sentence);
    QString sentence() const;

protected:
    explicit SentenceBar(QWidget* parent);

    QLabel* label_;
    QHBoxLayout* row_;  ///< the sentence, followed by buttons
};

/// Shows an error until the user closes it.
class Banner : public SentenceBar {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent = nullptr);
};

/// Offers to restore work after a crash: "Restore" and "Discard".
class RecoveryCard : public SentenceBar {
    Q_OBJECT

public:
    explicit RecoveryCard(QWidget* parent = nullptr);

signals:
    void restoreWanted();
    void discardWanted();
};

}  // namespace toile::app
