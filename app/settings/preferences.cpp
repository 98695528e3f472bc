// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/preferences.h"

#include <QDir>
#include <QSettings>
#include <algorithm>
#include <limits>
#include <utility>

namespace toile::app {

namespace {

constexpr auto kOpenFolder = "folders/open";
constexpr auto kExportFolder = "folders/export";
constexpr auto kRecent = "files/recent";
constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";
constexpr auto kHiddenColumns = "columns/%1";
constexpr auto kLengthUnit = "choices/lengthUnit";
constexpr auto kInchDenominator = "choices/inchDenominator";
constexpr auto kTheme = "choices/theme";
constexpr auto kLanguage = "choices/language";
constexpr auto kNavigation = "choices/navigation";
constexpr auto kSelectionColour = "choices/selectionColour";
constexpr auto kSeamColour = "choices/seamColour";
constexpr auto kAutosaveMinutes = "choices/autosaveMinutes";
constexpr auto kAutoFlattenTriangles = "choices/autoFlattenTriangles";

/// Words for enumerators, so that a settings file can be read and enumerators can be moved.
template <class Value>
using Words = std::initializer_list<std::pair<const char*, Value>>;

const Words<LengthUnit> kLengthUnits = {
    {"mm", LengthUnit::Millimetre}, {"cm", LengthUnit::Centimetre}, {"in", LengthUnit::Inch}};
const Words<Theme> kThemes = {
    {"system", Theme::System}, {"light", Theme::Light}, {"dark", Theme::Dark}};
const Words<Language> kLanguages = {
    {"system", Language::System}, {"en", Language::English}, {"de", Language::German}};
const Words<Navigation> kNavigations = {{"toile", Navigation::Toile},
                                        {"blender", Navigation::Blender},
                                        {"clo", Navigation::Clo},
                                        {"rhino", Navigation::Rhino}};
constexpr int kDenominators[] = {0, 8, 16, 32};

template <class Value>
Value valueOf(const Words<Value>& words, const QVariant& word, Value otherwise) {
    for (const auto& [known, value] : words) {
        if (word.toString() == QLatin1String(known)) {
            return value;
        }
    }
    return otherwise;
}

template <class Value>
QString wordOf(const Words<Value>& words, Value value) {
    for (const auto& [word, known] : words) {
        if (known == value) {
            return QString::fromLatin1(word);
        }
    }
    return {};
}

QVariant colourWord(const QColor& colour) {
    return colour.isValid() ? colour.name() : QString();
}

/// A number that a settings file may have wrong.
int bounded(const QVariant& value, int otherwise, int least,
            int most = std::numeric_limits<int>::max()) {
    bool isNumber = false;
    const int number = value.toInt(&isNumber);
    return isNumber && number >= least ? std::min(number, most) : otherwise;
}

}  // namespace

Preferences::Preferences() : settings_(std::make_unique<QSettings>("Toile", "Toile")) {
    readChoices();
}

Preferences::Preferences(const QString& file) {
    if (!file.isEmpty()) {
        settings_ = std::make_unique<QSettings>(file, QSettings::IniFormat);
    }
    readChoices();
}

Preferences::~Preferences() = default;

QVariant Preferences::read(const QString& key, const QVariant& atFirst) const {
    return settings_ ? settings_->value(key, atFirst) : kept_.value(key, atFirst);
}

void Preferences::write(const QString& key, const QVariant& value) {
    if (settings_) {
        settings_->setValue(key, value);
    } else {
        kept_.insert(key, value);
    }
}

void Preferences::readChoices() {
    const Choices first;
    choices_.lengthUnit = valueOf(kLengthUnits, read(kLengthUnit), first.lengthUnit);
    const int denominator = bounded(read(kInchDenominator), first.inchDenominator, 0);
    const bool known = std::count(std::begin(kDenominators), std::end(kDenominators), denominator);
    choices_.inchDenominator = known ? denominator : first.inchDenominator;
    choices_.theme = valueOf(kThemes, read(kTheme), first.theme);
    choices_.language = valueOf(kLanguages, read(kLanguage), first.language);
    choices_.navigation = valueOf(kNavigations, read(kNavigation), first.navigation);
    choices_.selectionColour = QColor(read(kSelectionColour).toString());
    choices_.seamColour = QColor(read(kSeamColour).toString());
    choices_.autosaveMinutes =
        bounded(read(kAutosaveMinutes), first.autosaveMinutes, 0, Choices::kMostAutosaveMinutes);
    choices_.autoFlattenTriangles =
        bounded(read(kAutoFlattenTriangles), first.autoFlattenTriangles, 0);
}

void Preferences::writeChoices() {
    write(kLengthUnit, wordOf(kLengthUnits, choices_.lengthUnit));
    write(kInchDenominator, choices_.inchDenominator);
    write(kTheme, wordOf(kThemes, choices_.theme));
    write(kLanguage, wordOf(kLanguages, choices_.language));
    write(kNavigation, wordOf(kNavigations, choices_.navigation));
    write(kSelectionColour, colourWord(choices_.selectionColour));
    write(kSeamColour, colourWord(choices_.seamColour));
    write(kAutosaveMinutes, choices_.autosaveMinutes);
    write(kAutoFlattenTriangles, choices_.autoFlattenTriangles);
}

void Preferences::setChoices(const Choices& choices) {
    if (choices == choices_) {
        return;
    }
    const Choices before = std::exchange(choices_, choices);
    writeChoices();
    if (before.lengthUnit != choices.lengthUnit ||
        before.inchDenominator != choices.inchDenominator) {
        emit lengthUnitChanged();
    }
    if (before.theme != choices.theme) {
        emit themeChanged();
    }
    if (before.navigation != choices.navigation) {
        emit navigationChanged();
    }
    if (before.selectionColour != choices.selectionColour ||
        before.seamColour != choices.seamColour) {
        emit coloursChanged();
    }
    if (before.autosaveMinutes != choices.autosaveMinutes) {
        emit autosaveMinutesChanged();
    }
    if (before.autoFlattenTriangles != choices.autoFlattenTriangles) {
        emit autoFlattenTrianglesChanged();
    }
}

QString Preferences::openFolder() const {
    const QString folder = read(kOpenFolder).toString();
    return folder.isEmpty() || !QDir(folder).exists() ? QDir::homePath() : folder;
}

void Preferences::setOpenFolder(const QString& folder) {
    write(kOpenFolder, folder);
}

QString Preferences::exportFolder() const {
    const QString folder = read(kExportFolder).toString();
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QString();
}

void Preferences::setExportFolder(const QString& folder) {
    write(kExportFolder, folder);
}

QList<QStringList> Preferences::recentFiles() const {
    QList<QStringList> recent;
    const QVariantList list = read(kRecent).toList();
    for (const QVariant& entry : list) {
        if (const QStringList files = entry.toStringList(); !files.isEmpty()) {
            recent << files;
        }
    }
    return recent;
}

void Preferences::setRecentFiles(const QList<QStringList>& files) {
    QVariantList list;
    for (const QStringList& garment : files) {
        list << QVariant(garment);
    }
    write(kRecent, list);
    emit recentFilesChanged();
}

QByteArray Preferences::windowGeometry() const {
    return read(kGeometry).toByteArray();
}

void Preferences::setWindowGeometry(const QByteArray& geometry) {
    write(kGeometry, geometry);
}

QByteArray Preferences::windowState() const {
    return read(kState).toByteArray();
}

void Preferences::setWindowState(const QByteArray& state) {
    write(kState, state);
}

QStringList Preferences::hiddenColumns(const QString& table, const QStringList& atFirst) const {
    return read(QString(kHiddenColumns).arg(table), atFirst).toStringList();
}

void Preferences::setHiddenColumns(const QString& table, const QStringList& columns) {
    write(QString(kHiddenColumns).arg(table), columns);
}

}  // namespace toile::app
