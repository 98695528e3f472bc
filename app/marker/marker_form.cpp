// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/marker_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <algorithm>
#include <set>
#include <utility>

#include "app/marker/marker_desk.h"
#include "app/widgets/number_edits.h"
#include "core/base/units.h"
#include "core/garment/fabric.h"

namespace toile::app {

namespace {

constexpr int kSeamsHigh = 120;               // pixels
constexpr int kFieldWide = 128;               // pixels
constexpr double kLongestGap = 1000;          // mm
constexpr double kLongestRepeat = 10'000;     // mm
constexpr double kMaxSheet = kMaxClothWidth;  // mm
constexpr int kMaxGarments = 200;
const Eigen::Vector2d kUsualSheet(610, 305);  // a cutting mat, mm

/// Rows of the list of kinds.
enum Kind { Roll, Sheets, Hides };

Kind kindOf(const MarkerSettings& settings) {
    return !settings.hides.empty() ? Hides : settings.sheet ? Sheets : Roll;
}

}  // namespace

MarkerForm::MarkerForm(MarkerDesk& desk, QWidget* parent)
    : QWidget(parent),
      desk_(desk),
      guard_(*new FieldGuard(this)),
      material_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      turns_(new QComboBox(this)),
      matched_(new QListWidget(this)),
      tolerance_(new AngleEdit(this)),
      folded_(new QCheckBox(tr("F&olded lengthwise"), this)),
      garments_(new QDoubleSpinBox(this)) {
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
    auto* label = new QLabel(text, this);
    QFont strong = label->font();
    strong.setWeight(QFont::DemiBold);
    label->setFont(strong);
    const int row = grid.rowCount();
    if (row > 1) {
        grid.setRowMinimumHeight(row, 8);
    }
    grid.addWidget(label, row + 1, 0, 1, 2);
}

void MarkerForm::addRow(QGridLayout& grid, const char* name, const QString& title,
                        const QString& tip, QWidget& field) {
    auto* label = new QLabel(title, this);
    label->setBuddy(&field);
    field.setObjectName(name);
    field.setAccessibleName(QString(title).remove('&'));
    field.setToolTip(tip);
    field.setFixedWidth(kFieldWide);
    field.setFocusPolicy(Qt::StrongFocus);
    guard_.install(field);
    field.installEventFilter(this);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(&field, row, 1);
}

LengthEdit* MarkerForm::addLength(QGridLayout& grid, const char* name, const QString& title,
                                  const QString& tip, double least, double most,
                                  std::function<void(MarkerSettings&, double)> set) {
    auto* field = new LengthEdit(this);
    field->setRange(least, most);
    field->setKeyboardTracking(false);
    addRow(grid, name, title, tip, *field);
    connect(field, &QDoubleSpinBox::valueChanged, this,
            [this, set = std::move(set), text = QString(title).remove('&')](double value) {
                change(
                    tr("%1 of the marker").arg(text),
                    [&](MarkerSettings& settings) { set(settings, value); }, true);
            });
    return field;
}

void MarkerForm::addCloth(QGridLayout& grid) {
    addHeading(grid, tr("Cloth"));
    addRow(
        grid, "markerMaterial", tr("&Material"),
        tr("Each material is laid by itself; what a piece is cut from is said in the panel Piece"),
        *material_);
    connect(material_, &QComboBox::activated, this, [this](int index) {
        desk_.setMaterial(material_->itemData(index).toString().toStdString());
    });
    kind_->addItems({tr("Roll"), tr("Sheets"), tr("Hides…")});
    addRow(
        grid, "markerKind", tr("&Comes as"),
        tr("A roll, of which as little as may be is used, sheets of one size, or hides that are "
           "read from drawings: DXF or SVG, the largest line the edge, lines within it holes, or "
           "zones where their layer is called \"grade 2\""),
        *kind_);
    connect(kind_, &QComboBox::activated, this, &MarkerForm::chooseKind);
    width_ = addLength(grid, "markerWidth", tr("&Width"),
                       tr("From selvedge to selvedge; at first as the fabric is sold"), 1,
                       kMaxClothWidth,
                       [](MarkerSettings& settings, double value) { settings.width = value; });
    const auto sheetSide = [](int axis) {
        return [axis](MarkerSettings& settings, double value) {
            if (settings.sheet) {
                (*settings.sheet)[axis] = value;
            }
        };
    };
    along_ = addLength(grid, "markerSheetAlong", tr("Sheet &length"),
                       tr("Of a sheet, along the warp"), 1, kMaxSheet, sheetSide(0));
    across_ = addLength(grid, "markerSheetAcross", tr("Sheet wi&dth"),
                        tr("Of a sheet, across the warp"), 1, kMaxSheet, sheetSide(1));
    folded_->setObjectName("markerFolded");
    folded_->setToolTip(
        tr("Two layers, right sides together: pairs are cut at once, and what is its own mirror "
           "image is cut on the fold"));
    const int row = grid.rowCount();
    grid.addWidget(folded_, row, 0, 1, 2);
    connect(folded_, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Fold the cloth") : tr("Unfold the cloth"),
               [on](MarkerSettings& settings) { settings.isFolded = on; });
    });
}

void MarkerForm::addPieces(QGridLayout& grid) {
    addHeading(grid, tr("Pieces"));
    garments_->setRange(1, kMaxGarments);
    garments_->setDecimals(0);
    garments_->setKeyboardTracking(false);
    addRow(grid, "markerGarments", tr("&Garments"), tr("How many of the garment are cut at once"),
           *garments_);
    connect(garments_, &QDoubleSpinBox::valueChanged, this, [this](double count) {
        change(
            tr("Garments of the marker"),
            [count](MarkerSettings& settings) { settings.garments = static_cast<int>(count); },
            true);
    });
    gap_ =
        addLength(grid, "markerGap", tr("Ga&p"), tr("Between two pieces, at least"), 0, kLongestGap,
                  [](MarkerSettings& settings, double value) { settings.gap = value; });
    border_ =
        addLength(grid, "markerBorder", tr("&Border"),
                  tr("Between the pieces and all edges of the cloth, at least"), 0, kLongestGap,
                  [](MarkerSettings& settings, double value) { settings.border = value; });
    turns_->addItems({tr("Either way up"), tr("One way"), tr("Freely")});  // as TurnRule
    addRow(grid, "markerTurns", tr("&Turned"),
           tr("How pieces may lie: with the grain along the warp either way up, all one way for "
              "nap and prints with an up, or freely on cloth without a grain"),
           *turns_);
    connect(turns_, &QComboBox::activated, this, [this](int rule) {
        change(tr("Turning of pieces"),
               [rule](MarkerSettings& settings) { settings.turns = static_cast<TurnRule>(rule); });
    });
    tolerance_->setRange(0, 45);
    tolerance_->setWrapping(false);
    tolerance_->setKeyboardTracking(false);
    addRow(grid, "markerTolerance", tr("O&ff the grain by"),
           tr("So much more a piece may be turned, to both sides"), *tolerance_);
    connect(tolerance_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
        change(
            tr("Turning of pieces"),
            [degrees](MarkerSettings& settings) { settings.tolerance = degrees * kDegree; }, true);
    });
}

void MarkerForm::addStripes(QGridLayout& grid) {
    addHeading(grid, tr("Stripes and plaids"));
    warp_ = addLength(grid, "markerRepeatWarp", tr("Repeat a&long"),
                      tr("From one stripe to the next along the warp; 0: there are none"), 0,
                      kLongestRepeat,
                      [](MarkerSettings& settings, double value) { settings.repeat.warp = value; });
    weft_ = addLength(grid, "markerRepeatWeft", tr("Repeat acro&ss"),
                      tr("From one stripe to the next across the warp; 0: there are none"), 0,
                      kLongestRepeat,
                      [](MarkerSettings& settings, double value) { settings.repeat.weft = value; });
    matched_->setObjectName("markerMatched");
    matched_->setAccessibleName(tr("Seams that match"));
    matched_->setToolTip(
        tr("Along these seams the repeat goes on from one piece to the other; what cannot be kept "
           "is named below"));
    matched_->setFixedHeight(kSeamsHigh);
    matchedTitle_ = new QLabel(tr("It &goes on across"), this);
    matchedTitle_->setBuddy(matched_);
    const int row = grid.rowCount();
    grid.addWidget(matchedTitle_, row, 0, 1, 2);
    grid.addWidget(matched_, row + 1, 0, 1, 2);
    connect(matched_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        // After the list has handled the event: it is filled again.
        QMetaObject::invokeMethod(
            this,
            [this, seam = item->text().toStdString(),
             isMatched = item->checkState() == Qt::Checked] { match(seam, isMatched); },
            Qt::QueuedConnection);
    });
}

/// Others stay, those too that are not in sight.
void MarkerForm::match(const std::string& seam, bool isMatched) {
    change(tr("Seams that match"), [&](MarkerSettings& settings) {
        std::erase(settings.matched, seam);
        if (isMatched) {
            settings.matched.push_back(seam);
            std::ranges::sort(settings.matched);
        }
    });
}

bool MarkerForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = desk_.document().newGesture();
    }
    return QWidget::eventFilter(watched, event);
}

void MarkerForm::change(const QString& text, const Change& change, bool isTyped) {
    MarkerSettings settings = desk_.settings();
    change(settings);
    desk_.setSettings(text, settings, isTyped ? gesture_ : -1);
}

void MarkerForm::chooseKind(int kind) {
    if (kind == Hides) {
        emit hidesWanted();
        return;
    }
    if (kind == kindOf(desk_.settings())) {
        return;  // and has the size that was typed
    }
    change(tr("Kind of cloth"), [kind](MarkerSettings& settings) {
        settings.hides.clear();
        settings.sheet.reset();
        if (kind == Sheets) {
            settings.sheet = kUsualSheet;
            settings.isFolded = false;
        }
    });
}

void MarkerForm::showMaterials() {
    const QSignalBlocker quiet(material_);
    material_->clear();
    for (const std::string& material : desk_.materials()) {
        material_->addItem(material.empty() ? tr("Own fabric") : QString::fromStdString(material),
                           QString::fromStdString(material));
    }
    material_->setCurrentIndex(material_->findData(QString::fromStdString(desk_.material())));
    material_->setEnabled(material_->count() > 1);
}

/// That are sewn, each once, of the pieces that are laid.
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
    const int row = matched_->currentRow();  // the keys go on from there
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
    const auto show = [this](LengthEdit& field, bool isShown) {
        field.setVisible(isShown);
        for (QLabel* label : findChildren<QLabel*>()) {
            if (label->buddy() == &field) {
                label->setVisible(isShown);
            }
        }
    };
    show(*width_, kind == Roll);
    show(*along_, kind == Sheets);
    show(*across_, kind == Sheets);
    folded_->setVisible(kind == Roll);
    showLength(*width_, settings.width > 0 ? settings.width : now.width, settings.width > 0);
    if (settings.sheet) {
        showLength(*along_, settings.sheet->x(), false);
        showLength(*across_, settings.sheet->y(), false);
    }
    folded_->setChecked(settings.isFolded);
    {
        const QSignalBlocker quiet(garments_);
        garments_->setValue(settings.garments);
    }
    showLength(*gap_, settings.gap, false);
    showLength(*border_, settings.border, false);
    turns_->setCurrentIndex(static_cast<int>(settings.turns));
    {
        const QSignalBlocker quiet(tolerance_);
        tolerance_->setValue(settings.tolerance / kDegree);
    }
    tolerance_->setEnabled(settings.turns != TurnRule::Free);
    showLength(*warp_, settings.repeat.warp, false);
    showLength(*weft_, settings.repeat.weft, false);
}

}  // namespace toile::app
