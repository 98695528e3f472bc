// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace toile::app {

class Document;

/// Excludes all pieces smaller than an area, such as buttons, at once. Shows their number first.
class LeaveOutDialog : public QDialog {
    Q_OBJECT

public:
    LeaveOutDialog(Document& document, QWidget* parent);

    void accept() override;

private:
    double area() const;  ///< mm2
    void count();

    Document& document_;
    QDoubleSpinBox* area_;
    QLabel* count_;
    QPushButton* leaveOut_ = nullptr;
};

}  // namespace toile::app
