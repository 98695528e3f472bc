// SPDX-License-Identifier: GPL-3.0-or-later
// Whether free edges are what they look like, on garments with known panels and on garments of one
// skin that are cut as tailors do.
#include <algorithm>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/pattern/edge_kinds.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// What the free edges are, by looking at the garments: a line for each garment with its unit,
/// division and whether it is cut, then kinds with places in the middle of edges, mm. Where the
/// trade has no single answer, several kinds are right: the notch below the buttons of a coat, the
/// edge of a hood that continues a front edge, a stand collar with a zip, the top of a sock. A
/// sleeve that ends above the wrist has a hem, the edge of a hood too.
constexpr const char* kTrueEdges = R"(
= garments/dress.obj cm uv whole
armhole: 124 1148 -111, -151 1148 -126, -162 1314 -109, 141 1314 -90, -171 1184 -13, 104 1185 0
neckline: 23 1150 -157, -48 1149 -162, -153 1317 -107, 137 1320 -96, -33 1202 57
hem: -194 143 -253, -4 137 14, 144 148 -238
= garments/dress14_pieces.obj m auto whole
neckline: 31 489 -2, 25 553 -97, -30 489 -2, -26 553 -97
hem: 73 -119 42, 81 -116 -115, -231 501 -78, -56 -117 50, -82 -115 -115, 228 502 -79
= garments/longsleeve.obj cm uv whole
hem: -5 757 150, -1 771 -149, 414 1097 21, -414 1104 3
collar-edge: 2 1334 66, -1 1371 -54
= garments/polo.obj cm uv whole
hem: 325 1340 -20, -327 1333 -17, -1 887 -135, 7 911 120
front-edge: -10 1441 98, 17 1427 109
collar-edge: -4 1498 -60
= garments/polo_pieces.obj cm auto whole
hem: -1 887 -135, 7 911 120, 325 1340 -20, -327 1333 -17
collar-edge: -4 1498 -60
front-edge: -10 1441 98, 17 1427 109
= garments/skirt_clo.obj mm auto whole
waist: -137 1124 29, -89 1115 64, -38 1113 81, -143 1123 -49, -112 1117 -87, -52 1110 -106, 44 1110
    -107, 104 1116 -90, 138 1125 -53, 40 1113 80, 90 1117 62, 136 1125 25
hem: -94 702 52, -109 703 -91, 99 703 -92, 99 702 51
= garments/tee_sim.obj cm uv whole
hem: 436 131 -52, 437 115 5, -440 126 -59, -443 117 -6, 1 -274 -122, -1 -285 141
neckline: 0 250 -86, -1 33 152
= garments/tee_sim_pieces.obj cm auto whole
neckline: 0 250 -86, -1 33 152
hem: 1 -274 -122, -1 -285 141, -443 117 -6, 437 115 5, -440 126 -59, 436 131 -52
= garments/tshirt.obj cm uv whole
hem: 383 1411 -63, -381 1398 -63, 1 1043 91, 0 1039 -175
neckline: -3 1606 5, -4 1650 -113
= garments/suit_mh.obj - auto cut
waist: 149 207 32, -150 207 32
hem: 240 -748 -11, -247 -748 18, -140 42 142, 107 42 144, -166 47 -59, 157 47 -60, -36 44 -116
slit|front-edge: -19 117 156
collar-edge: 8 638 100, -6 702 -18
slit: 7 109 -116, -3 113 -116
cuff: 497 282 218, -503 285 220
= garments/elegant_mh.obj - auto cut
hem: 121 -290 -50, -121 -290 -50, 0 -298 141, -2 58 -87
slit: 0 -122 -85
waist: 0 122 -40, 0 96 142
cuff: -418 144 150, 432 140 137
front-edge: -1 270 154, 7 272 150, -17 488 97, 30 520 69
collar-edge: -41 530 -37
= garments/leggings.ply - auto cut
waist: 140 104 53, -140 104 52
hem: 158 -819 -43, -167 -819 -66
= garments/arcsim/tshirt.obj m uv whole
neckline: 58 350 -74, -74 350 -76, -63 336 106, 106 337 105
hem: 172 -238 -170, -174 -238 -170, 444 284 -3, -437 321 -10, -164 -241 152, 204 -241 156
= garments/arcsim/pants3.obj m uv whole
hem: -138 -1112 -164, -130 -1131 98, 125 -1134 96, 108 -1122 -164
waist: -120 -75 -91, -107 -86 82, 105 -88 82, 105 -81 -96
= garments/arcsim/robew.obj m auto whole
hem: -330 -1114 244, 335 -1134 -227, -301 -1136 -193, 313 -1120 167
front-edge: -43 -401 250, 57 -393 204
cuff: -945 514 -38, 989 413 -47
hem|front-edge|neckline: 176 539 247, -100 407 131, -142 694 183
= tailor/mh_tee_m4.obj dm auto cut
hem: 0 127 -102, 0 134 158, 275 554 28, -275 554 28
neckline: 0 689 -25, 0 649 82
= tailor/mh_trousers_f1.obj dm auto cut
waist: 151 70 34, -158 70 31
hem: 202 -734 24, -201 -734 19
= tailor/mh_jacket_elegant_f.obj dm auto cut
cuff: -418 144 150, 432 140 137
front-edge: -1 270 154, 7 272 150, -17 488 97, 30 520 69
hem: -2 58 -87
collar-edge: -41 530 -37
= tailor/mh_skirt_elegant_f.obj dm auto cut
hem: 121 -290 -50, -121 -290 -50, 0 -298 141
slit: 0 -122 -85
waist: 0 122 -40, 0 96 142
= tailor/mh_overall_m1.obj dm auto cut
cuff: -501 242 189, 509 264 204
hem: -209 -741 -40, 259 -735 10
front-edge|neckline|collar-edge: -17 593 87, 10 571 102
collar-edge: 29 700 -3
= tailor/mh_sweater_m2.obj dm auto cut
neckline: 0 689 -25, 0 649 82
hem: 3 78 -117, 0 83 151
cuff: 506 278 230, -506 278 230
= tailor/mh_jacket_m3.obj dm auto cut
cuff: -420 368 88, 414 374 74
collar-edge: 104 679 3, -98 676 7
front-edge: -10 435 165, 17 403 161, -53 659 82
hem: -12 105 -121
= tailor/mh_suitjacket.obj dm auto cut
hem: -140 42 142, 128 43 140, -157 48 -71, 144 46 -77, -21 44 -117
slit|front-edge: -19 117 156
collar-edge: -2 635 99, 5 702 -19
slit: 7 109 -116, -3 113 -116
cuff: 501 279 213, -487 282 228
= tailor/mh_fedora_cocked.obj dm auto cut
hem: -14 773 -42
= tailor/mh_croptee_sport_f.obj dm auto cut
neckline: -1 542 -22, -2 482 92
hem: 9 319 -43, 262 384 16, -15 292 155, -265 377 32
= tailor/pf_dress.obj mm auto cut
hem: 4 -287 -132, -134 -276 179, 169 -286 154
neckline: 152 431 83, 38 421 -116, -57 425 100
armhole: 219 391 79, -117 383 -70, 208 371 -78, -133 408 86
= tailor/pf_longsleeve_apose.obj m auto cut
neckline: 21 1541 180, 21 1622 99
hem: 29 889 269, 15 947 -11
cuff: 648 1184 192, -590 1233 203
= tailor/pf_wetsuit.obj m auto cut
neckline: 61 564 43, -61 562 49
hem: 229 -813 -1, -242 -807 -16
cuff: 373 4 70, -398 -2 91
= tailor/cf_puffer_zup.obj m auto cut
hem: 21009 -27 200, 21017 -19 -155
neckline|collar-edge: 21032 675 209, 20988 951 -91
cuff: 21730 66 79, 20297 67 82
= tailor/dc_skirt.obj m auto cut
hem: 0 910 177, 0 910 -157
waist: 103 1152 21
= tailor/dc_tshirt.obj 60mm auto cut
hem: -7 75 164, 0 94 -155, 315 675 63, -312 680 49
neckline: 4 756 112, -4 729 -19
= tailor/dc_sock.obj m auto cut
hem|cuff: 79 332 -99
= tailor/p_raglan_tee.obj mm auto cut
hem: -384 -171 -5, 0 -680 -110, 0 -680 110, 384 -171 -6
neckline: 2 57 -59, -9 1 85
= tailor/p_hoodie.obj mm auto cut
cuff: -619 -321 -5, 618 -322 -5
hem: -2 281 78, 0 -680 -110, -2 43 114, 0 -680 110
= tailor/p_jumpsuit_tpose.obj mm auto cut
cuff: -680 -127 -5, 680 -126 -5
hem: -190 -1400 -5, 67 -1400 36, 180 -1400 -36
neckline: -46 7 68, -1 56 -58, 74 16 44
= tailor/p_tank.obj mm auto cut
armhole: -178 -86 -71, -178 -80 69, 178 -81 70, 178 -81 -70
hem: -106 -680 -85, 0 -680 110, 106 -680 -85
neckline: -50 49 -40, 1 4 76, 50 49 -40
= tailor/p_vest_open.obj mm auto cut
armhole: -178 -146 41, 178 -154 43, -178 -16 -50, 178 -7 -47
neckline: -70 14 51, 67 43 -24
hem: 2 -680 -110
= tailor/p_leotard.obj mm auto cut
armhole: -168 -87 70, -168 -76 -70, 168 -170 -19
hem: -100 -690 86, -100 -690 -86, 178 -638 0
neckline: -6 4 77, -2 56 -57
= tailor/p_skirt_aline_zup.obj cm auto cut
waist: 132 0 0, -132 0 0
hem: 305 -620 0, -305 -620 0
= tailor/p_skirt_round_zup.obj m auto cut
waist: 110 0 0, -110 0 0
hem: 440 -402 0, -440 -438 0
= tailor/p_shorts_zup_inch.obj in auto cut
hem: -201 -393 55, -52 -407 -55, 53 -418 -57, 199 -393 58
waist: -151 30 45, -49 30 -105, 47 30 -105, 151 30 45
= tailor/p_beanie.obj mm auto cut
hem: 90 -10 28
= tailor/p_bag.obj mm auto cut
hem: 159 150 60
= tailor/v_sweater_opened.obj dm auto cut
cuff: -518 246 201, 518 246 201
neckline: 0 689 -25
hem: 4 78 -117
= tailor/v_sweater_tpose.obj dm auto cut
neckline: 0 689 -25, 0 649 82
hem: 3 78 -117, 0 83 151
cuff: 600 541 230, -600 547 230
= tailor/v_tee_60k.obj 60mm auto cut
hem: -4 75 164, -3 94 -155, 315 675 63, -312 682 53
neckline: 1 756 112, -1 729 -18
= tailor/v_trousers_wrinkled.obj dm auto cut
waist: 149 207 32, -150 207 32
hem: 247 -740 25, -247 -750 16
)";

struct TrueEdge {
    std::string kinds;
    Eigen::Vector3d place;
};

struct LookedAt {
    std::string file;
    LoadOptions loading{};
    std::vector<TrueEdge> edges{};
};

std::vector<LookedAt> garmentsLookedAt() {
    std::vector<LookedAt> list;
    std::istringstream text(kTrueEdges);
    std::string word, kinds;
    while (text >> word) {
        if (word == "=") {
            LookedAt& added = list.emplace_back();
            std::string unit, split, cut;
            text >> added.file >> unit >> split >> cut;
            added.loading.unit = unit == "-" ? std::nullopt : parseFileUnit(unit);
            added.loading.split = *parseSplitMode(split);
            added.loading.autoCut = cut == "cut";
            added.loading.cutStyle = CutStyle::Auto;
        } else if (word.ends_with(':')) {
            kinds = word.substr(0, word.size() - 1);
        } else {
            Eigen::Vector3d place(std::stod(word), 0, 0);
            char comma = ' ';
            text >> place.y() >> place.z();
            if (text.peek() == ',') {
                text >> comma;
            }
            list.back().edges.push_back({kinds, place});
        }
    }
    return list;
}

struct Score {
    double right = 0, whole = 0;  ///< mm
};

/// Of a garment's free edges, in runs of one found kind: each against the nearest place looked at.
Score scoreOf(const LookedAt& looked, const Garment& garment, std::string& wrong) {
    const auto outlines = seam::buildOutlines(garment.pieces);
    const auto found = findEdgeKinds(garment, outlines);
    Score score;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind != SeamKind::Free) {
            continue;
        }
        const seam::Outline& outline = outlines.list[seam.left.piece];
        const int end = seam.left.first + seam.left.count;
        const auto kindAt = [&](int k) {
            return found[seam.left.piece][outline.wrapIndex(k)].kind;
        };
        for (int first = seam.left.first, k = first; k < end; ++k) {
            if (k + 1 < end && kindAt(k + 1) == kindAt(first)) {
                continue;
            }
            if (found[seam.left.piece][outline.wrapIndex(first)].opening < 0) {
                first = k + 1;  // a seam ends within this edge
                continue;
            }
            const double from = outline.arcOf(first), to = outline.arcOf(k + 1);
            const Eigen::Vector3d middle = outline.pointAt((from + to) / 2);
            const auto truth = std::ranges::min_element(
                looked.edges, {},
                [&](const TrueEdge& edge) { return (edge.place - middle).norm(); });
            const std::string kind(wordOf(kEdgeKindWords, kindAt(first)));
            const bool isRight =
                ('|' + truth->kinds + '|').find('|' + kind + '|') != std::string::npos;
            score.whole += to - from;
            score.right += isRight ? to - from : 0;
            if (!isRight) {
                wrong += "\n  " + garment.pieces[seam.left.piece]->name + ": " +
                         fixed(to - from, 0) + " mm of " + truth->kinds + " taken for " + kind;
            }
            first = k + 1;
        }
    }
    return score;
}

TEST(EdgeKindsOfGarments, AreWhatTheyLookLike) {
    TOILE_NEEDS_SHARED(test::sharedFile("garments/dress.obj"));
    Score all;
    for (const LookedAt& looked : garmentsLookedAt()) {
        Progress progress;
        const auto garment = loadGarment({test::sharedFile(looked.file)}, looked.loading, progress);
        ASSERT_TRUE(garment) << looked.file;
        std::string wrong;
        const Score score = scoreOf(looked, *garment, wrong);
        all.right += score.right;
        all.whole += score.whole;
        std::printf("%-36s %5.1f %% of %6.0f mm%s\n", looked.file.c_str(),
                    100 * score.right / score.whole, score.whole, wrong.c_str());
        EXPECT_GE(score.right, 0.8 * score.whole) << looked.file << wrong;
    }
    EXPECT_GE(all.right, 0.9 * all.whole);
}

}  // namespace
}  // namespace toile
