// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/leave_out_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/document/document.h"
#include "app/document/piece_edits.h"

namespace toile::app {

namespace {

constexpr double kSquareMillimetres = 100;  ///< mm2 per cm2
constexpr double kUsual = 2, kMost = 10000;
constexpr int kNamed = 6;  ///< at most so many pieces are listed by name

}  // namespace

LeaveOutDialog::LeaveOutDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      area_(new QDoubleSpinBox(this)),
      count_(new QLabel(this)) {
    setObjectName("leaveOutDialog");
    setWindowTitle(tr("Leave out small pieces"));
    area_->setObjectName("leaveOutArea");
    area_->setAccessibleName(tr("Area"));
    area_->setRange(0.1, kMost);
    area_->setDecimals(1);
    area_->setSuffix(tr(" cm²"));
    area_->setValue(kUsual);
    count_->setObjectName("leaveOutCount");
    count_->setWordWrap(true);
    count_->setMinimumWidth(320);
    auto* label = new QLabel(tr("Pieces &below"), this);
    label->setBuddy(area_);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(area_);
    row->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    leaveOut_ = buttons->addButton(tr("&Leave out"), QDialogButtonBox::AcceptRole);
    leaveOut_->setObjectName("leaveOutNow");
    leaveOut_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &LeaveOutDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(row);
    layout->addWidget(count_);
    layout->addWidget(buttons);
    connect(area_, &QDoubleSpinBox::valueChanged, this, &LeaveOutDialog::count);
    connect(&document_, &Document::changed, this, &LeaveOutDialog::count);
    count();
}

double LeaveOutDialog::area() const {
    return area_->value() * kSquareMillimetres;
}

void LeaveOutDialog::count() {
    const std::vector<int> pieces = piecesBelow(document_, area());
    QStringList names;
    for (const int piece : pieces) {
        if (names.size() == kNamed) {
            names << QString(QChar(0x2026));
            break;
        }
        names << pieceName(document_, piece);
    }
    count_->setText(pieces.empty() ? tr("No piece is smaller than this.")
                                   : tr("%1 of %2 pieces: %3")
                                         .arg(pieces.size())
                                         .arg(document_.pieceCount())
                                         .arg(names.join(", ")));
    leaveOut_->setEnabled(!pieces.empty());
}

void LeaveOutDialog::accept() {
    setLeftOut(document_, piecesBelow(document_, area()), true);
    QDialog::accept();
}

}  // namespace toile::app
