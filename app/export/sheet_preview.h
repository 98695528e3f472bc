// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>

#include "app/export/printed_pattern.h"

namespace toile::app {

/// One sheet of paper as it will be printed, fitted into the widget.
class SheetPreview : public QWidget {
    Q_OBJECT

public:
    explicit SheetPreview(QWidget* parent = nullptr);

    /// @param pattern  null: not ready yet
    void setPattern(std::shared_ptr<const PrintedPattern> pattern);
    /// @param sheet  of the pattern, from 0
    void setSheet(int sheet);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::shared_ptr<const PrintedPattern> pattern_;
    int sheet_ = 0;
};

}  // namespace toile::app
