// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace toile {

/// A file that was opened before: its name, its folder, when it was changed.
class RecentFileButton : public QPushButton {
    Q_OBJECT

public:
    explicit RecentFileButton(const QString& path, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString folder_, date_;
};

}  // namespace toile
