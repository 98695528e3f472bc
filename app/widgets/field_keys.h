// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>

namespace toile::app {

/// Gives the keyboard back from the fields beside the views: Enter takes what was typed, Escape
/// takes back what was not taken yet, and after either the next key is a command again. Lists keep
/// the keyboard: they are walked through with keys.
class FieldKeys : public QObject {
    Q_OBJECT

public:
    /// @param giveBack  moves the keyboard to where the work is
    FieldKeys(std::function<void()> giveBack, QObject* parent);

    /// The fields within this widget, those that come later too.
    void watch(QWidget& panel);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isOurs(const QWidget& field) const;

    std::function<void()> giveBack_;
    QList<QPointer<QWidget>> panels_;
};

}  // namespace toile::app
