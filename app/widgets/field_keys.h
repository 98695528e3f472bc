// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>

namespace toile::app {

/// Returns the focus from the fields beside the views: Enter commits, Escape reverts the typing.
/// After either, keys are shortcuts again. Lists keep the focus, because they are navigated by
/// keys.
class FieldKeys : public QObject {
    Q_OBJECT

public:
    /// @param giveBack  moves the focus to the view in use
    FieldKeys(std::function<void()> giveBack, QObject* parent);

    /// Includes fields that are added to the panel later.
    void watch(QWidget& panel);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isOurs(const QWidget& field) const;

    std::function<void()> giveBack_;
    QList<QPointer<QWidget>> panels_;
};

}  // namespace toile::app
