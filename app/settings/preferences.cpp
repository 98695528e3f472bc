// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/preferences.h"

#include <QDir>
#include <QSettings>
#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/wording.h"
#include "core/formats/format_options.h"

namespace toile::app {

namespace {

constexpr auto kOpenFolder = "folders/open";
constexpr auto kExportFolder = "folders/export";
constexpr auto kSewingRate = "marker/minutesPerMetre";
constexpr auto kExportFormat = "export/format";
constexpr auto kExportOption = "export/%1";
constexpr auto kRecent = "files/recent";
constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";
constexpr auto kHiddenColumns = "columns/%1";
constexpr auto kChoice = "choices/%1";

// Stored as words, so that settings files are readable and enumerators can be reordered.
constexpr Word<LengthUnit> kLengthUnits[] = {
    {LengthUnit::Millimetre, "mm"}, {LengthUnit::Centimetre, "cm"}, {LengthUnit::Inch, "in"}};
constexpr Word<int> kDenominators[] = {{0, "0"}, {8, "8"}, {16, "16"}, {32, "32"}};
constexpr Word<Theme> kThemes[] = {
    {Theme::System, "system"}, {Theme::Light, "light"}, {Theme::Dark, "dark"}};
constexpr Word<Language> kLanguages[] = {
    {Language::System, "system"}, {Language::English, "en"}, {Language::German, "de"}};
constexpr Word<Navigation> kNavigations[] = {{Navigation::Toile, "toile"},
                                             {Navigation::Blender, "blender"},
                                             {Navigation::Clo, "clo"},
                                             {Navigation::Rhino, "rhino"}};
constexpr Word<NewGarment> kNewGarments[] = {{NewGarment::Exact, "exact"},
                                             {NewGarment::Pattern, "pattern"}};
constexpr Word<Menus> kMenus[] = {{Menus::All, "all"}, {Menus::Plain, "plain"}};

/// Numbers from 0 to `most`.
struct UpTo {
    int most;
};
struct AnyColour {};

/// Visits every choice with its setting name and its allowed values.
template <class Some, class Visit>
void forEachChoice(Some& choices, const Visit& visit) {
    visit("lengthUnit", choices.lengthUnit, kLengthUnits);
    visit("inchDenominator", choices.inchDenominator, kDenominators);
    visit("theme", choices.theme, kThemes);
    visit("language", choices.language, kLanguages);
    visit("navigation", choices.navigation, kNavigations);
    visit("newGarment", choices.newGarment, kNewGarments);
    visit("menus", choices.menus, kMenus);
    visit("selectionColour", choices.selectionColour, AnyColour{});
    visit("seamColour", choices.seamColour, AnyColour{});
    visit("autosaveMinutes", choices.autosaveMinutes, UpTo{Choices::kMaxAutosaveMinutes});
    visit("autoFlattenTriangles", choices.autoFlattenTriangles,
          UpTo{std::numeric_limits<int>::max()});
}

template <class Value, std::size_t n>
QVariant keptForm(Value value, const Word<Value> (&words)[n]) {
    return QString::fromUtf8(wordOf(words, value));
}
QVariant keptForm(const QColor& colour, AnyColour) {
    return colour.isValid() ? colour.name() : QString();
}
QVariant keptForm(int number, UpTo) {
    return number;
}

// Invalid stored values leave the choice unchanged.
template <class Value, std::size_t n>
void take(const QVariant& kept, Value& value, const Word<Value> (&words)[n]) {
    value = parseWord(words, kept.toString().toStdString()).value_or(value);
}
void take(const QVariant& kept, QColor& colour, AnyColour) {
    colour = QColor(kept.toString());
}
void take(const QVariant& kept, int& number, UpTo limit) {
    bool isNumber = false;
    const int read = kept.toInt(&isNumber);
    number = isNumber && read >= 0 ? std::min(read, limit.most) : number;
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
    forEachChoice(choices_, [this](const char* name, auto& value, const auto& allowed) {
        take(read(QString(kChoice).arg(name)), value, allowed);
    });
}

void Preferences::setChoices(const Choices& choices) {
    if (choices == choices_) {
        return;
    }
    const Choices before = std::exchange(choices_, choices);
    forEachChoice(choices_, [this](const char* name, const auto& value, const auto& allowed) {
        write(QString(kChoice).arg(name), keptForm(value, allowed));
    });
    emit choicesChanged(before);
}

QString Preferences::openFolder() const {
    const QString folder = read(kOpenFolder).toString();
    return folder.isEmpty() || !QDir(folder).exists() ? QDir::homePath() : folder;
}

void Preferences::setOpenFolder(const QString& folder) {
    write(kOpenFolder, folder);
}

QString Preferences::exportFormat() const {
    return read(kExportFormat, ".svg").toString();
}

void Preferences::setExportFormat(const QString& ending) {
    write(kExportFormat, ending);
}

ExportOptions Preferences::exportOptions() const {
    ExportOptions options;
    for (const FormatOption& row : formatOptions()) {
        row.set(options, read(QString(kExportOption).arg(row.name)).toString().toStdString());
    }
    return options;
}

void Preferences::setExportOptions(const ExportOptions& options) {
    for (const FormatOption& row : formatOptions()) {
        write(QString(kExportOption).arg(row.name), QString::fromStdString(row.get(options)));
    }
}

QString Preferences::exportFolder() const {
    const QString folder = read(kExportFolder).toString();
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QString();
}

void Preferences::setExportFolder(const QString& folder) {
    write(kExportFolder, folder);
}

std::optional<double> Preferences::sewingRate() const {
    bool isNumber = false;
    const double minutes = read(kSewingRate).toDouble(&isNumber);
    return isNumber && minutes >= 0 ? std::optional(minutes) : std::nullopt;
}

void Preferences::setSewingRate(double minutes) {
    write(kSewingRate, minutes);
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

std::optional<QStringList> Preferences::hiddenColumns(const QString& table) const {
    const QVariant kept = read(QString(kHiddenColumns).arg(table));
    return kept.isValid() ? std::optional(kept.toStringList()) : std::nullopt;
}

void Preferences::setHiddenColumns(const QString& table, const QStringList& columns) {
    write(QString(kHiddenColumns).arg(table), columns);
}

}  // namespace toile::app
