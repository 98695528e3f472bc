// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/marker_form.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <algorithm>
#include <set>
#include <utility>

#include "app/marker/marker_desk.h"
#include "core/marker/marker_fields.h"

namespace toile::app {

namespace {

constexpr int kSeamsHigh = 120, kListWidth = 132;  // pixels
const Eigen::Vector2d kUsualSheet(610, 305);       // a cutting mat, mm

/// The size of a sheet: the form's view of MarkerSettings::sheet.
struct SheetSize {
    double along = kUsualSheet.x(), across = kUsualSheet.y();
};

constexpr auto kSheetFields = [](auto& at, auto& sheet) {
    at.field(Setting{"along", TR("Sheet &length"), TR("Length of the sheet"), TR("Along the warp")},
             sheet.along, 1, kMaxClothWidth);
    at.field(Setting{"across", TR("Sheet wi&dth"), TR("Width of the sheet"), TR("Across the warp")},
             sheet.across, 1, kMaxClothWidth);
};

/// Rows of the list of kinds.
enum Kind { Roll, Sheets, Hides };

Kind kindOf(const MarkerSettings& settings) {
    return !settings.hides.empty() ? Hides : settings.sheet ? Sheets : Roll;
}

}  // namespace

MarkerForm::MarkerForm(MarkerDesk& desk, QWidget* parent)
    : QWidget(parent),
      desk_(desk),
      fields_(
          *this, [this] { return desk_.document().newGesture(); },
          [this](const SettingChange& change) { take(change); }),
      material_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      matched_(new QListWidget(this)),
      matchedTitle_(new QLabel(tr("Match stripes &across"), this)) {
    fields_.make<MarkerSettings>(kMarkerSettingsFields, "marker");
    fields_.make<SheetSize>(kSheetFields, "markerSheet");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 6, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    addCloth(*grid);
    addPieces(*grid);
    addStripes(*grid);
    grid->setColumnStretch(0, 1);
    grid->setRowStretch(grid->rowCount(), 1);
    connect(&desk_, &MarkerDesk::changed, this, &MarkerForm::refresh);
    refresh();
}

void MarkerForm::addHeading(QGridLayout& grid, const QString& text) {
    const int row = grid.rowCount();
    if (row > 1) {
        grid.setRowMinimumHeight(row, 8);
    }
    grid.addWidget(makeHeading(text, this), row + 1, 0, 1, 2);
}

void MarkerForm::addChoice(QGridLayout& grid, QComboBox& field, const char* name,
                           const QString& title, const QString& tip) {
    auto* label = new QLabel(title, this);
    label->setBuddy(&field);
    fields_.dress(field, name, QString(title).remove('&'), tip);
    field.setMinimumWidth(kListWidth);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(&field, row, 1);
}

void MarkerForm::addCloth(QGridLayout& grid) {
    addHeading(grid, tr("Cloth"));
    addChoice(grid, *material_, "markerMaterial", tr("&Material"),
              tr("Each material has its own marker. Set the material of a piece in the panel "
                 "Properties"));
    connect(material_, &QComboBox::activated, this, [this](int index) {
        desk_.setMaterial(material_->itemData(index).toString().toStdString());
    });
    kind_->addItems({tr("Roll"), tr("Sheets"), tr("Hides…")});
    addChoice(grid, *kind_, "markerKind", tr("&Fabric form"),
              tr("A roll, sheets of one size, or hides from DXF or SVG files. The largest line is "
                 "the edge, inner lines are holes, or zones on layers like \"grade 2\""));
    connect(kind_, &QComboBox::activated, this, &MarkerForm::chooseKind);
    for (const char* path : {"width", "along", "across", "isFolded"}) {
        fields_.addRow(grid, path, grid.rowCount());
    }
}

void MarkerForm::addPieces(QGridLayout& grid) {
    addHeading(grid, tr("Pieces"));
    for (const char* path : {"garments", "gap", "border", "turns", "tolerance"}) {
        fields_.addRow(grid, path, grid.rowCount());
    }
    fields_.setRange("tolerance", 0, 45);
}

void MarkerForm::addStripes(QGridLayout& grid) {
    addHeading(grid, tr("Stripes and plaids"));
    fields_.addRow(grid, "repeat.warp", grid.rowCount());
    fields_.addRow(grid, "repeat.weft", grid.rowCount());
    matched_->setObjectName("markerMatched");
    matched_->setAccessibleName(tr("Seams that match"));
    matched_->setToolTip(tr(
        "The repeat continues across the checked seams; seams where it cannot are listed below"));
    matched_->setFixedHeight(kSeamsHigh);
    matchedTitle_->setBuddy(matched_);
    const int row = grid.rowCount();
    grid.addWidget(matchedTitle_, row, 0, 1, 2);
    grid.addWidget(matched_, row + 1, 0, 1, 2);
    connect(matched_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        // The list is filled again, so wait until it has handled the event.
        QMetaObject::invokeMethod(
            this,
            [this, seam = item->text().toStdString(),
             isMatched = item->checkState() == Qt::Checked] { match(seam, isMatched); },
            Qt::QueuedConnection);
    });
}

/// Keeps other names, including those the list does not show.
void MarkerForm::match(const std::string& seam, bool isMatched) {
    MarkerSettings settings = desk_.settings();
    std::erase(settings.matched, seam);
    if (isMatched) {
        settings.matched.push_back(seam);
        std::ranges::sort(settings.matched);
    }
    desk_.setSettings(tr("Seams that match"), settings, -1);
}

void MarkerForm::take(const SettingChange& change) {
    MarkerSettings settings = desk_.settings();
    if (change.path == "along" || change.path == "across") {
        if (settings.sheet) {
            (*settings.sheet)[change.path == "along" ? 0 : 1] = *change.value.number;
        }
    } else {
        settings = fields_.changed(kMarkerSettingsFields, settings, change);
    }
    desk_.setSettings(change.text, settings, change.gesture);
}

void MarkerForm::chooseKind(int kind) {
    if (kind == Hides) {
        emit hidesWanted();
        return;
    }
    MarkerSettings settings = desk_.settings();
    if (kind == kindOf(settings)) {
        return;  // keep the size that the user typed
    }
    settings.hides.clear();
    settings.sheet.reset();
    if (kind == Sheets) {
        settings.sheet = kUsualSheet;
        settings.isFolded = false;
    }
    desk_.setSettings(tr("Change fabric form"), settings, -1);
}

void MarkerForm::showMaterials() {
    const QSignalBlocker quiet(material_);
    material_->clear();
    for (const std::string& material : desk_.materials()) {
        material_->addItem(
            material.empty() ? tr("Garment's fabric") : QString::fromStdString(material),
            QString::fromStdString(material));
    }
    material_->setCurrentIndex(material_->findData(QString::fromStdString(desk_.material())));
    material_->setEnabled(material_->count() > 1);
}

/// Names of the sewn seams of the pieces in the marker, without duplicates.
std::vector<std::string> MarkerForm::seamNames() const {
    std::set<std::string> names;
    if (desk_.marker()) {
        for (const LaidCopy& copy : desk_.marker()->copies) {
            for (const SeamLine& seam :
                 desk_.pattern()->pieces[static_cast<std::size_t>(copy.piece)].seams) {
                if (seam.kind == SeamKind::Seam) {
                    names.insert(seam.name);
                }
            }
        }
    }
    return {names.begin(), names.end()};
}

void MarkerForm::showSeams() {
    const QSignalBlocker quiet(matched_);
    const int row = matched_->currentRow();
    matched_->clear();
    const std::vector<std::string>& matched = shown_->settings.matched;
    for (const std::string& name : shown_->seams) {
        auto* item = new QListWidgetItem(QString::fromStdString(name), matched_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        const bool isMatched = std::ranges::find(matched, name) != matched.end();
        item->setCheckState(isMatched ? Qt::Checked : Qt::Unchecked);
    }
    matched_->setCurrentRow(row);
    const bool isShown = !(shown_->settings.repeat == ClothRepeat{}) && !shown_->seams.empty();
    matched_->setVisible(isShown);
    matchedTitle_->setVisible(isShown);
}

void MarkerForm::showAgain() {
    shown_.reset();
    refresh();
}

void MarkerForm::refresh() {
    const Shown now{desk_.settings(),     desk_.materials(), desk_.material(),
                    desk_.fabric().width, seamNames(),       desk_.document().garment() != nullptr};
    if (shown_ == now) {
        return;
    }
    shown_ = now;
    const MarkerSettings& settings = now.settings;
    setEnabled(now.isOpen);
    showMaterials();
    showSeams();
    const Kind kind = kindOf(settings);
    kind_->setCurrentIndex(kind);
    fields_.setShown("width", kind == Roll);
    fields_.setShown("along", kind == Sheets);
    fields_.setShown("across", kind == Sheets);
    fields_.setShown("isFolded", kind == Roll);
    MarkerSettings usual;
    usual.width = now.width;
    fields_.show(kMarkerSettingsFields, settings, usual);
    if (settings.sheet) {
        fields_.show(kSheetFields, SheetSize{settings.sheet->x(), settings.sheet->y()});
    }
    fields_.setEnabled("tolerance", settings.turns != TurnRule::Free);
}

}  // namespace toile::app
