// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/text_outlines.h"

#include <algorithm>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <hb.h>

#include "core/base/characters.h"
#include "core/pattern/label.h"

#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace toile {
namespace {

enum class Turn { Right, Left, Number, Neutral, AsBefore };

struct Character {
    char32_t code;
    Turn turn;
    std::uint32_t script;
    bool isAttached;  ///< to the preceding character
    bool isRightToLeft = false;
    int level = 0;  ///< of nested directions, even ones to the right
};

bool isScript(std::uint32_t script) {
    return script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED &&
           script != HB_SCRIPT_UNKNOWN;
}

Turn turnOf(hb_unicode_general_category_t category, hb_script_t script) {
    switch (category) {
        case HB_UNICODE_GENERAL_CATEGORY_DECIMAL_NUMBER:
            return Turn::Number;
        case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
        case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
        case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
            return Turn::AsBefore;
        case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_LETTER:
        case HB_UNICODE_GENERAL_CATEGORY_OTHER_LETTER:
        case HB_UNICODE_GENERAL_CATEGORY_LOWERCASE_LETTER:
        case HB_UNICODE_GENERAL_CATEGORY_UPPERCASE_LETTER:
            break;
        default:
            if (!isScript(script)) {
                return Turn::Neutral;
            }
    }
    return hb_script_get_horizontal_direction(script) == HB_DIRECTION_RTL ? Turn::Left
                                                                          : Turn::Right;
}

std::vector<Character> charactersOf(std::string_view line) {
    hb_unicode_funcs_t* const unicode = hb_unicode_funcs_get_default();
    std::vector<Character> all;
    for (const char32_t code : codePoints(cleanText(line))) {
        const hb_script_t script = hb_unicode_script(unicode, code);
        const Turn turn = turnOf(hb_unicode_general_category(unicode, code), script);
        all.push_back({code, turn, script, turn == Turn::AsBefore});
    }
    return all;
}

/// Characters without a script get that of the preceding character, else of the first with one.
void settleScripts(std::vector<Character>& line) {
    const auto first =
        std::ranges::find_if(line, [](const Character& c) { return isScript(c.script); });
    std::uint32_t script = HB_SCRIPT_COMMON;
    script = first == line.end() ? script : first->script;
    for (Character& character : line) {
        script = isScript(character.script) ? character.script : script;
        character.script = script;
    }
}

bool joinsNumbers(char32_t code) {
    return code == '.' || code == ',' || code == ':' || code == '/' || code == '-' || code == '+';
}

/// Accents follow their letters, points within numbers these numbers, and numbers after letters
/// that run to the right are treated like these letters.
void settleNumbers(std::vector<Character>& line, Turn base) {
    Turn letters = base;
    for (std::size_t k = 0; k < line.size(); ++k) {
        Turn& turn = line[k].turn;
        if (turn == Turn::AsBefore) {
            turn = k > 0 ? line[k - 1].turn : Turn::Neutral;
        } else if (turn == Turn::Neutral && k > 0 && k + 1 < line.size() &&
                   joinsNumbers(line[k].code) && line[k - 1].turn == Turn::Number &&
                   line[k + 1].turn == Turn::Number) {
            turn = Turn::Number;
        } else if (turn == Turn::Number && letters == Turn::Right) {
            turn = Turn::Right;
        } else if (turn == Turn::Left || turn == Turn::Right) {
            letters = turn;
        }
    }
}

void settleNeutrals(std::vector<Character>& line, Turn base) {
    const auto asLetters = [](Turn turn) { return turn == Turn::Number ? Turn::Left : turn; };
    for (std::size_t k = 0; k < line.size();) {
        std::size_t end = k;
        while (end < line.size() && line[end].turn == Turn::Neutral) {
            ++end;
        }
        const Turn before = k > 0 ? asLetters(line[k - 1].turn) : base;
        const Turn after = end < line.size() ? asLetters(line[end].turn) : base;
        for (; k < end; ++k) {
            line[k].turn = before == after ? before : base;
        }
        ++k;
    }
}

void settleDirections(std::vector<Character>& line) {
    const auto first = std::ranges::find_if(line, [](const Character& c) -> bool {
        return c.turn == Turn::Left || c.turn == Turn::Right;
    });
    const Turn base = first == line.end() ? Turn::Right : first->turn;
    settleNumbers(line, base);
    settleNeutrals(line, base);
    for (Character& character : line) {
        character.isRightToLeft = character.turn == Turn::Left;
        character.level = character.isRightToLeft                                ? 1
                          : base == Turn::Left || character.turn == Turn::Number ? 2
                                                                                 : 0;
    }
}

struct LevelRun : TextRun {
    int level = 0;
};

/// Converts reading order to visual order: the deepest nesting is reversed first.
void reorder(std::vector<LevelRun>& runs) {
    for (const int level : {2, 1}) {
        for (auto from = runs.begin(); from != runs.end();) {
            const auto isInside = [level](const LevelRun& run) { return run.level >= level; };
            from = std::find_if(from, runs.end(), isInside);
            const auto to = std::find_if_not(from, runs.end(), isInside);
            std::reverse(from, to);
            from = to;
        }
    }
}

}  // namespace

std::vector<TextRun> textRuns(std::string_view line,
                              const std::function<std::size_t(char32_t)>& fontOf) {
    std::vector<Character> characters = charactersOf(line);
    settleScripts(characters);
    settleDirections(characters);
    std::vector<LevelRun> runs;
    for (const Character& character : characters) {
        const std::size_t font =
            character.isAttached && !runs.empty() ? runs.back().font : fontOf(character.code);
        if (runs.empty() || runs.back().font != font || runs.back().script != character.script ||
            runs.back().level != character.level) {
            runs.push_back(
                {{{}, font, character.script, character.isRightToLeft}, character.level});
        }
        runs.back().characters += character.code;
    }
    reorder(runs);
    return {runs.begin(), runs.end()};
}

namespace {

template <class Type, void (*release)(Type*)>
struct Release {
    void operator()(Type* object) const { release(object); }
};
template <class Type, void (*release)(Type*)>
using Owned = std::unique_ptr<Type, Release<Type, release>>;

void closeFace(FT_FaceRec_* face) {
    FT_Done_Face(face);
}
void closeLibrary(FT_LibraryRec_* library) {
    FT_Done_FreeType(library);
}

/// Collects an outline as cubic curves.
struct ContourCollector {
    std::vector<std::vector<CubicCurve>>& contours;
    Eigen::Vector2d origin;
    double scale;
    Eigen::Vector2d at{0, 0};
    bool isOpen = false;

    Eigen::Vector2d place(const FT_Vector* point) const {
        return origin + scale * Eigen::Vector2d(static_cast<double>(point->x),
                                                static_cast<double>(point->y));
    }

    void close() {
        if (!isOpen) {
            return;
        }
        isOpen = false;
        std::vector<CubicCurve>& contour = contours.back();
        if (contour.empty()) {
            contours.pop_back();
        } else if (contour.front().start != at) {
            contour.push_back(straightCurve(at, contour.front().start));
        }
    }

    void add(const CubicCurve& curve) {
        contours.back().push_back(curve);
        at = curve.end;
    }
};

ContourCollector& collectorOf(void* user) {
    return *static_cast<ContourCollector*>(user);
}

int moveTo(const FT_Vector* to, void* user) {
    ContourCollector& collector = collectorOf(user);
    collector.close();
    collector.contours.emplace_back();
    collector.at = collector.place(to);
    collector.isOpen = true;
    return 0;
}

int lineTo(const FT_Vector* to, void* user) {
    ContourCollector& collector = collectorOf(user);
    const Eigen::Vector2d end = collector.place(to);
    if (end != collector.at) {
        collector.add(straightCurve(collector.at, end));
    }
    return 0;
}

int quadraticTo(const FT_Vector* handle, const FT_Vector* to, void* user) {
    ContourCollector& collector = collectorOf(user);
    const Eigen::Vector2d middle = collector.place(handle), end = collector.place(to);
    collector.add({collector.at, collector.at + (middle - collector.at) * 2 / 3,
                   end + (middle - end) * 2 / 3, end});
    return 0;
}

int cubicTo(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
    ContourCollector& collector = collectorOf(user);
    collector.add(
        {collector.at, collector.place(first), collector.place(second), collector.place(to)});
    return 0;
}

/// A font's file, for its outlines and for shaping, in its own units.
struct FontFace {
    std::size_t number = 0;
    Owned<hb_blob_t, hb_blob_destroy> file;
    Owned<FT_FaceRec_, closeFace> outlines;
    Owned<hb_font_t, hb_font_destroy> shapes;
    double units = 1;  ///< per size of the font

    /// @param scale  from its units  A letter without an outline, as in a picture font, adds
    /// nothing.
    void draw(std::uint32_t glyph, const Eigen::Vector2d& origin, double scale,
              std::vector<std::vector<CubicCurve>>& contours) const {
        // Without scaling there is no hinting: every version of FreeType gives the same outlines.
        if (FT_Load_Glyph(outlines.get(), glyph, FT_LOAD_NO_SCALE) != 0 ||
            outlines->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
            return;
        }
        constexpr FT_Outline_Funcs kTo{moveTo, lineTo, quadraticTo, cubicTo, 0, 0};
        ContourCollector collector{contours, origin, scale};
        FT_Outline_Decompose(&outlines->glyph->outline, &kTo, &collector);
        collector.close();
    }

    /// Height of a capital letter, in its units.
    double capital() const {
        std::vector<std::vector<CubicCurve>> letter;
        draw(FT_Get_Char_Index(outlines.get(), 'H'), {0, 0}, 1, letter);
        double height = 0;
        for (const std::vector<CubicCurve>& contour : letter) {
            for (const CubicCurve& curve : contour) {
                height = std::max(height, curve.start.y());
            }
        }
        constexpr double kUsual = 0.72;  // relative to its size, for a font without Latin letters
        return height > 0 ? height : kUsual * units;
    }
};

/// The system fonts in the order in which they are searched for a letter. For one thread.
class Fonts {
public:
    Fonts() {
        FT_Library library = nullptr;
        config_.reset(FcInitLoadConfigAndFonts());
        if (FT_Init_FreeType(&library) == 0) {
            library_.reset(library);
            sort();
        }
    }

    bool any() const { return !fonts_.empty(); }

    /// The first font with the letter; the first of all if none has it.
    std::size_t fontOf(char32_t code) const {
        const auto at = std::ranges::find_if(fonts_, [code](const FcPattern* font) {
            FcCharSet* letters = nullptr;
            return FcPatternGetCharSet(font, FC_CHARSET, 0, &letters) == FcResultMatch &&
                   FcCharSetHasChar(letters, code);
        });
        return at == fonts_.end() ? 0 : static_cast<std::size_t>(at - fonts_.begin());
    }

    /// Null if its file cannot be used. Valid until the next call.
    const FontFace* face(std::size_t number) {
        const auto held = std::ranges::find(faces_, number, &FontFace::number);
        if (held != faces_.end()) {
            faces_.splice(faces_.begin(), faces_, held);
            return &faces_.front();
        }
        FontFace opened = open(number);
        if (!opened.shapes) {
            return nullptr;
        }
        faces_.push_front(std::move(opened));
        if (faces_.size() > kMaxHeld) {
            faces_.pop_back();
        }
        return &faces_.front();
    }

private:
    static constexpr std::size_t kMaxHeld = 6;

    void sort() {
        const Owned<FcPattern, FcPatternDestroy> wanted(FcPatternCreate());
        const auto add = [&wanted](const char* object, const char* value) {
            const std::string_view text = value;
            const std::vector<FcChar8> bytes(text.begin(), text.end() + 1);
            FcPatternAddString(wanted.get(), object, bytes.data());
        };
        add(FC_FAMILY, "DejaVu Sans");
        add(FC_LANG, "en");  // otherwise the user's language would change the text
        FcConfigSubstitute(config_.get(), wanted.get(), FcMatchPattern);
        FcDefaultSubstitute(wanted.get());
        FcResult found = FcResultNoMatch;
        sorted_.reset(FcFontSort(config_.get(), wanted.get(), FcTrue, nullptr, &found));
        for (int k = 0; sorted_ && k < sorted_->nfont; ++k) {
            FcPattern* const font = sorted_->fonts[k];
            FcBool isScalable = FcFalse, isColoured = FcFalse;
            FcPatternGetBool(font, FC_SCALABLE, 0, &isScalable);
            FcPatternGetBool(font, FC_COLOR, 0, &isColoured);
            if (isScalable && !isColoured) {
                fonts_.push_back(font);
            }
        }
    }

    FontFace open(std::size_t number) const {
        FontFace face;
        face.number = number;
        FcChar8* path = nullptr;
        int index = 0;
        if (number >= fonts_.size() ||
            FcPatternGetString(fonts_[number], FC_FILE, 0, &path) != FcResultMatch) {
            return face;
        }
        FcPatternGetInteger(fonts_[number], FC_INDEX, 0, &index);
        index &= 0xFFFF;  // the bits above select named instances of a variable font
        std::string name;
        for (; *path != 0; ++path) {
            name += static_cast<char>(*path);
        }
        face.file.reset(hb_blob_create_from_file(name.c_str()));
        FT_Face opened = nullptr;
        if (FT_New_Face(library_.get(), name.c_str(), index, &opened) != 0) {
            return face;
        }
        face.outlines.reset(opened);
        face.units = std::max(1.0, static_cast<double>(opened->units_per_EM));
        const Owned<hb_face_t, hb_face_destroy> shapes(
            hb_face_create(face.file.get(), static_cast<unsigned>(index)));
        face.shapes.reset(hb_font_create(shapes.get()));
        const int units = static_cast<int>(face.units);
        hb_font_set_scale(face.shapes.get(), units, units);
        return face;
    }

    Owned<FcConfig, FcConfigDestroy> config_;
    Owned<FT_LibraryRec_, closeLibrary> library_;
    Owned<FcFontSet, FcFontSetDestroy> sorted_;
    std::vector<FcPattern*> fonts_;  ///< those with outlines
    std::list<FontFace> faces_;      ///< most recently used first
};

/// Appends a run. @param size  of the font
void addRun(const TextRun& run, const FontFace& face, double size, TextOutlines& outlines) {
    const Owned<hb_buffer_t, hb_buffer_destroy> buffer(hb_buffer_create());
    const std::vector<std::uint32_t> codes(run.characters.begin(), run.characters.end());
    const int length = static_cast<int>(codes.size());
    hb_buffer_add_utf32(buffer.get(), codes.data(), length, 0, length);
    hb_buffer_set_direction(buffer.get(), run.isRightToLeft ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer.get(), static_cast<hb_script_t>(run.script));
    hb_buffer_set_language(buffer.get(), hb_language_from_string("en", -1));  // not the user's
    hb_shape(face.shapes.get(), buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* const glyphs = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    const double scale = size / face.units;
    for (unsigned k = 0; k < count; ++k) {
        const Eigen::Vector2d origin(outlines.width + scale * places[k].x_offset,
                                     scale * places[k].y_offset);
        face.draw(glyphs[k].codepoint, origin, scale, outlines.contours);
        outlines.width += scale * places[k].x_advance;
    }
}

}  // namespace

TextOutlines textOutlines(std::string_view line, double height) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    static Fonts fonts;
    const FontFace* face = fonts.any() ? fonts.face(0) : nullptr;
    TextOutlines outlines;
    if (!face) {
        outlines.width = line.empty() ? 0 : textExtent({std::string(line)}, height).x();
        return outlines;
    }
    const double size = height * face->units / face->capital();
    for (const TextRun& run : textRuns(line, [](char32_t code) { return fonts.fontOf(code); })) {
        face = fonts.face(run.font);
        if (face) {
            addRun(run, *face, size, outlines);
        }
    }
    return outlines;
}

std::vector<std::vector<CubicCurve>> placedOutlines(const DrawnText& text) {
    std::vector<std::vector<CubicCurve>> all;
    const Eigen::Rotation2Dd turn(text.angle);
    double baseline = -0.5 * text.height;  // capitals are centred on the line's middle
    for (const std::string& line : text.lines) {
        TextOutlines outlines = textOutlines(line, text.height);
        const Eigen::Vector2d start(-0.5 * outlines.width, baseline);
        for (std::vector<CubicCurve>& contour : outlines.contours) {
            for (CubicCurve& curve : contour) {
                for (Eigen::Vector2d* point :
                     {&curve.start, &curve.startHandle, &curve.endHandle, &curve.end}) {
                    *point = text.position + turn * (start + *point);
                }
            }
            all.push_back(std::move(contour));
        }
        baseline -= kLineSpacing * text.height;
    }
    return all;
}

}  // namespace toile
