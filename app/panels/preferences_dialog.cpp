// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/preferences_dialog.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QPixmap>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "app/settings/language.h"
#include "app/settings/preferences.h"

namespace toile::app {
namespace {

constexpr QSize kSwatch(28, 16);

constexpr int kMaxTriangles = 10'000'000, kTriangleStep = 50'000;

/// In the order of the list of units.
constexpr struct {
    LengthUnit unit;
    int denominator;
} kUnitRows[] = {{LengthUnit::Millimetre, 0}, {LengthUnit::Centimetre, 0}, {LengthUnit::Inch, 0},
                 {LengthUnit::Inch, 8},       {LengthUnit::Inch, 16},      {LengthUnit::Inch, 32}};

int unitRow(const Choices& choices) {
    const bool fractions = choices.lengthUnit == LengthUnit::Inch;
    const auto row =
        std::find_if(std::begin(kUnitRows), std::end(kUnitRows), [&](const auto& known) {
            return known.unit == choices.lengthUnit &&
                   known.denominator == (fractions ? choices.inchDenominator : 0);
        });
    return row == std::end(kUnitRows) ? 0 : static_cast<int>(row - std::begin(kUnitRows));
}

}  // namespace

ColourButton::ColourButton(QWidget* parent) : QToolButton(parent) {
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setPopupMode(QToolButton::InstantPopup);
    setIconSize(kSwatch);
    auto* menu = new QMenu(this);
    menu->addAction(tr("Default"), this, [this] { choose({}); })->setObjectName("usualColour");
    menu->addAction(tr("Another colour…"), this, [this] {
        const QColor chosen = QColorDialog::getColor(colour_, this);
        if (chosen.isValid()) {
            choose(chosen);
        }
    });
    setMenu(menu);
    setColour({});
}

void ColourButton::setColour(const QColor& colour) {
    colour_ = colour;
    setText(colour.isValid() ? colour.name() : tr("Default"));
    if (!colour.isValid()) {
        setIcon({});
        return;
    }
    QPixmap pixmap(kSwatch * devicePixelRatio());
    pixmap.fill(colour);
    setIcon(QIcon(pixmap));
}

void ColourButton::choose(const QColor& colour) {
    setColour(colour);
    emit colourChosen(colour);
}

PreferencesDialog::PreferencesDialog(Preferences& preferences, QWidget* parent)
    : QDialog(parent), preferences_(preferences), before_(preferences.choices()) {
    setObjectName("preferencesDialog");
    setWindowTitle(tr("Preferences"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    const std::pair<QString, void (PreferencesDialog::*)(QFormLayout&)> groups[] = {
        {tr("Units and language"), &PreferencesDialog::makeUnits},
        {tr("Appearance"), &PreferencesDialog::makeLook},
        {tr("General"), &PreferencesDialog::makeWork}};
    for (const auto& [title, make] : groups) {
        auto* box = new QGroupBox(title, this);
        auto* form = new QFormLayout(box);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        form->setHorizontalSpacing(14);
        (this->*make)(*form);
        layout->addWidget(box);
    }
    auto* buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    buttons->setObjectName("preferencesButtons");
    auto& reset = *buttons->button(QDialogButtonBox::RestoreDefaults);
    reset.setText(tr("&Reset"));
    reset.setToolTip(tr("Reset to the defaults; Cancel undoes this"));
    connect(&reset, &QPushButton::clicked, this, [this] {
        preferences_.setChoices({});
        showChoices();
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    alignLabels();
    showChoices();
    setMinimumWidth(460);
}

void PreferencesDialog::alignLabels() {
    QList<QLabel*> labels;
    for (const QFormLayout* form : findChildren<QFormLayout*>()) {
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            if (auto* label = item ? qobject_cast<QLabel*>(item->widget()) : nullptr) {
                labels << label;
            }
        }
    }
    int width = 0;
    for (const QLabel* label : labels) {
        width = std::max(width, label->sizeHint().width());
    }
    for (QLabel* label : labels) {
        label->setMinimumWidth(width);
    }
}

QComboBox* PreferencesDialog::makeCombo(const char* name, const QStringList& texts) {
    auto* combo = new QComboBox(this);
    combo->setObjectName(name);
    combo->addItems(texts);
    connect(combo, &QComboBox::currentIndexChanged, this, &PreferencesDialog::takeChoices);
    return combo;
}

QSpinBox* PreferencesDialog::makeNumber(const char* name, int largest, int step) {
    auto* number = new QSpinBox(this);
    number->setObjectName(name);
    number->setRange(0, largest);
    number->setSingleStep(step);
    number->setGroupSeparatorShown(true);
    number->setKeyboardTracking(false);
    connect(number, &QSpinBox::valueChanged, this, &PreferencesDialog::takeChoices);
    return number;
}

void PreferencesDialog::makeUnits(QFormLayout& form) {
    unit_ = makeCombo("lengthUnitChoice", {tr("Millimetres"), tr("Centimetres"),
                                           tr("Inches, decimals"), tr("Inches, eighths"),
                                           tr("Inches, sixteenths"), tr("Inches, thirty-seconds")});
    unit_->setToolTip(tr("Unit for lengths; you can enter other units too"));
    form.addRow(tr("&Lengths:"), unit_);
    language_ = makeCombo("languageChoice", {tr("System default"), QStringLiteral("English"),
                                             QStringLiteral("Deutsch")});
    form.addRow(tr("L&anguage:"), language_);
    restart_ = new QLabel(tr("Restart Toile to change the language."), this);
    restart_->setObjectName("restartNote");
    restart_->setWordWrap(true);
    form.addRow(QString(), restart_);
}

void PreferencesDialog::makeLook(QFormLayout& form) {
    theme_ = makeCombo("themeChoice", {tr("System default"), tr("Light"), tr("Dark")});
    form.addRow(tr("&Theme:"), theme_);
    selection_ = new ColourButton(this);
    selection_->setObjectName("selectionColour");
    connect(selection_, &ColourButton::colourChosen, this, &PreferencesDialog::takeChoices);
    form.addRow(tr("&Selected pieces:"), selection_);
    seam_ = new ColourButton(this);
    seam_->setObjectName("seamColour");
    connect(seam_, &ColourButton::colourChosen, this, &PreferencesDialog::takeChoices);
    form.addRow(tr("Selected s&eam:"), seam_);
}

void PreferencesDialog::makeWork(QFormLayout& form) {
    navigation_ =
        makeCombo("navigationChoice", {tr("Toile"), tr("Blender"), tr("CLO"), tr("Rhino")});
    navigation_->setToolTip(tr("Mouse controls like those of this program"));
    form.addRow(tr("&Mouse as in:"), navigation_);
    newGarment_ =
        makeCombo("newGarmentChoice", {tr("Exact outlines"), tr("A pattern to cut and sew")});
    newGarment_->setToolTip(
        tr("Patterns to cut and sew have fair lines, trued seam ends, equal mirrored pieces, "
           "allowances and notches. Open garments do not change"));
    form.addRow(tr("&New garments start with:"), newGarment_);
    menus_ = makeCombo("menusChoice", {tr("Everything"), tr("What pattern makers need")});
    menus_->setToolTip(
        tr("Hide research methods, their overlays and mesh commands. Those in use stay visible"));
    form.addRow(tr("M&enus show:"), menus_);
    autosave_ = makeNumber("autosaveMinutes", Choices::kMaxAutosaveMinutes, 1);
    autosave_->setSpecialValueText(tr("Never"));
    autosave_->setSuffix(tr(" min"));
    autosave_->setToolTip(tr("How often Toile saves a backup against crashes"));
    form.addRow(tr("&Back up every:"), autosave_);
    heavy_ = makeNumber("autoFlattenTriangles", kMaxTriangles, kTriangleStep);
    heavy_->setSuffix(tr(" triangles"));
    heavy_->setToolTip(tr("Larger garments are flattened only on request"));
    form.addRow(tr("&Flatten after edits up to:"), heavy_);
}

void PreferencesDialog::showChoices() {
    const QScopedValueRollback guard(showing_, true);
    const Choices& choices = preferences_.choices();
    unit_->setCurrentIndex(unitRow(choices));
    theme_->setCurrentIndex(static_cast<int>(choices.theme));
    language_->setCurrentIndex(static_cast<int>(choices.language));
    navigation_->setCurrentIndex(static_cast<int>(choices.navigation));
    newGarment_->setCurrentIndex(static_cast<int>(choices.newGarment));
    menus_->setCurrentIndex(static_cast<int>(choices.menus));
    selection_->setColour(choices.selectionColour);
    seam_->setColour(choices.seamColour);
    autosave_->setValue(choices.autosaveMinutes);
    heavy_->setValue(choices.autoFlattenTriangles);
    showRestartNote();
}

void PreferencesDialog::showRestartNote() {
    const Language chosen = resolved(preferences_.choices().language, QLocale::system());
    restart_->setVisible(chosen != languageInUse());
    if (isVisible()) {
        adjustSize();  // room for the note
    }
}

void PreferencesDialog::takeChoices() {
    if (showing_) {
        return;
    }
    Choices choices = preferences_.choices();
    const auto& unit = kUnitRows[std::max(0, unit_->currentIndex())];
    choices.lengthUnit = unit.unit;
    if (unit.unit == LengthUnit::Inch) {
        choices.inchDenominator = unit.denominator;
    }
    choices.theme = static_cast<Theme>(theme_->currentIndex());
    choices.language = static_cast<Language>(language_->currentIndex());
    choices.navigation = static_cast<Navigation>(navigation_->currentIndex());
    choices.newGarment = static_cast<NewGarment>(newGarment_->currentIndex());
    choices.menus = static_cast<Menus>(menus_->currentIndex());
    choices.selectionColour = selection_->colour();
    choices.seamColour = seam_->colour();
    choices.autosaveMinutes = autosave_->value();
    choices.autoFlattenTriangles = heavy_->value();
    preferences_.setChoices(choices);
    showRestartNote();
}

void PreferencesDialog::reject() {
    preferences_.setChoices(before_);
    QDialog::reject();
}

}  // namespace toile::app
