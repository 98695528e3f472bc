// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/pdf_reader.h"

#include <cmath>
#include <map>
#include <utility>

#include "tests/core/readers/pdf_document.h"
#include "tests/core/readers/pdf_shown.h"

namespace toile {
namespace {

using Kind = PdfValue::Kind;

constexpr std::size_t kMaxPages = 20000;
/// Of all that a file shows, bytes: ours have some megabytes.
constexpr std::size_t kMaxContent = std::size_t{1} << 27;
constexpr double kLongestSide = 1e9;  // of a page, points

/// Pages, layers and content of a document.
class PdfReader {
public:
    explicit PdfReader(const PdfDocument& document) : document_(document) {}

    Result<ReadPdf> read() {
        const auto catalog = document_.entry(document_.trailer(), "Root");
        if (!catalog) {
            return catalog.error();
        }
        if (const auto done = readLayers(*catalog); !done) {
            return done.error();
        }
        const auto root = document_.entry(*catalog, "Pages");
        if (!root) {
            return root.error();
        }
        const auto kids = document_.entry(*root, "Kids");
        const auto count = document_.entry(*root, "Count");
        if (!kids || !count || kids->items.size() > kMaxPages ||
            count->number != static_cast<double>(kids->items.size())) {
            return malformedPdf("the pages are not counted");
        }
        for (const PdfValue& kid : kids->items) {
            if (const auto done = readPage(kid); !done) {
                return done.error();
            }
        }
        if (!hasForm_) {
            return malformedPdf("no page shows the drawing");
        }
        return std::move(read_);
    }

private:
    Result<void> readLayers(const PdfValue& catalog) {
        const auto properties = document_.entry(catalog, "OCProperties");
        if (!properties) {
            return properties.error();
        }
        const auto groups = document_.entry(*properties, "OCGs");
        const auto usual = document_.entry(*properties, "D");
        if (!groups || !usual) {
            return malformedPdf("the layers are not listed");
        }
        if (const auto done = addNames(*groups, read_.layers); !done) {
            return done.error();
        }
        const auto hidden = document_.entry(*usual, "OFF");
        return hidden ? addNames(*hidden, read_.hiddenLayers) : hidden.error();
    }

    Result<void> addNames(const PdfValue& groups, std::vector<std::string>& names) const {
        for (const PdfValue& group : groups.items) {
            const auto found = document_.resolved(group);
            const PdfValue* name = found ? found->find("Name") : nullptr;
            if (!name || name->kind != Kind::String) {
                return malformedPdf("a layer has no name");
            }
            names.push_back(name->text);
        }
        return {};
    }

    /// Names of layers by their keys in a dictionary of resources.
    Result<std::map<std::string, std::string>> layerKeys(const PdfValue& resources) const {
        std::map<std::string, std::string> keys;
        const auto properties = document_.entry(resources, "Properties");
        if (!properties) {
            return properties.error();
        }
        for (std::size_t k = 0; k < properties->keys.size(); ++k) {
            const auto group = document_.resolved(properties->items[k]);
            const PdfValue* name = group ? group->find("Name") : nullptr;
            if (!name) {
                return malformedPdf("a layer has no name");
            }
            keys[properties->keys[k]] = name->text;
        }
        return keys;
    }

    Result<PdfShown> shownIn(const PdfValue& resources, const PdfValue& stream) {
        const auto keys = layerKeys(resources);
        if (!keys) {
            return keys.error();
        }
        const auto content = document_.stream(stream);
        if (!content) {
            return content.error();
        }
        length_ += content->size();
        if (length_ > kMaxContent) {
            return malformedPdf("its pages are too long");
        }
        return readPdfContent(*content, *keys);
    }

    Result<void> readPage(const PdfValue& reference) {
        const auto page = document_.resolved(reference);
        if (!page) {
            return page.error();
        }
        const auto box = document_.entry(*page, "MediaBox");
        const auto resources = document_.entry(*page, "Resources");
        const PdfValue* content = page->find("Contents");
        if (!box || box->items.size() != 4 || !resources || !content) {
            return malformedPdf("a page is incomplete");
        }
        const auto& side = box->items;
        for (const PdfValue& corner : side) {
            if (!(std::abs(corner.number) < kLongestSide)) {
                return malformedPdf("a page is too large");
            }
        }
        ReadPdfPage& made = read_.pages.emplace_back(
            ReadPdfPage{{side[2].number - side[0].number, side[3].number - side[1].number}});
        auto shown = shownIn(*resources, *content);
        if (!shown) {
            return shown.error();
        }
        made.lines = std::move(shown->lines);
        for (const auto& [key, view] : shown->forms) {
            if (key != "P") {
                continue;  // a line of text
            }
            if (const auto done = hasForm_ ? Result<void>() : readForm(*resources, key); !done) {
                return done.error();
            }
            hasForm_ = true;
            made.views.push_back(view);
        }
        return {};
    }

    Result<void> readForm(const PdfValue& resources, const std::string& key) {
        const auto forms = document_.entry(resources, "XObject");
        const PdfValue* reference = forms ? forms->find(key) : nullptr;
        const auto form = reference ? document_.resolved(*reference) : malformedPdf("no drawing");
        if (!form || form->find("Matrix")) {
            return malformedPdf("the drawing is missing");
        }
        const auto own = document_.entry(*form, "Resources");
        if (!own) {
            return own.error();
        }
        auto shown = shownIn(*own, *reference);
        if (!shown) {
            return shown.error();
        }
        read_.drawing.lines = std::move(shown->lines);
        read_.drawing.pieces = static_cast<int>(shown->pieces.size());
        return {};
    }

    const PdfDocument& document_;
    ReadPdf read_;
    bool hasForm_ = false;
    std::size_t length_ = 0;  ///< of the content so far
};

}  // namespace

Result<ReadPdf> readPdf(std::string_view bytes) {
    const auto document = PdfDocument::read(bytes);
    if (!document) {
        return document.error();
    }
    return PdfReader(*document).read();
}

}  // namespace toile
