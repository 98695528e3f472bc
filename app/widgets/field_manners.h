// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace toile {

/// What number fields and lists beside the work must not do: change because somebody scrolls past
/// them, and keep the keys of Undo and Redo once what was typed has been taken, as the step to take
/// back is the document's then.
class FieldManners : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// From now on; the field is to go no later than this.
    void teach(QWidget& field);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace toile
