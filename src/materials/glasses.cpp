// SPDX-License-Identifier: Apache-2.0
#include "materials/glasses.hpp"

#include <algorithm>

#include "materials/dispersion.hpp"

namespace zraka {
namespace {

constexpr Dispersion sellmeier(double b1, double b2, double b3, double c1, double c2, double c3) {
  return {Dispersion::Kind::sellmeier, {b1, b2, b3, c1, c2, c3}};
}
/// The same from the papers' wavelengths of resonance, in µm.
constexpr Dispersion resonant(double b1, double b2, double b3, double l1, double l2, double l3) {
  return sellmeier(b1, b2, b3, l1 * l1, l2 * l2, l3 * l3);
}
constexpr Dispersion cauchy(double a, double b, double c) {
  return {Dispersion::Kind::cauchy, {a, b, c}};
}

constexpr std::string_view kSchott = "Schott, data sheets of optical glasses, 2017";
constexpr std::string_view kMalitson = "Malitson, J. Opt. Soc. Am. 55, 1965, at 20 °C";
constexpr std::string_view kSapphire =
    "Malitson and Dodge, J. Opt. Soc. Am. 62, 1972, the ordinary ray, at 20 °C";
constexpr std::string_view kPeter = "Peter, Z. Phys. 15, 1923";
constexpr std::string_view kDaimon =
    "Daimon and Masumura, Appl. Opt. 46, 2007, at 20 °C, two of four terms as one: within 0.00004";
constexpr std::string_view kRheims = "Rheims, Köser and Wriedt, Meas. Sci. Technol. 8, 1997";
constexpr std::string_view kSultanova =
    "Sultanova, Kasarova and Nikolov, Acta Phys. Pol. A 116, 2009, fitted by Polyanskiy";
constexpr std::string_view kWarren =
    "Warren and Brandt, J. Geophys. Res. 113, 2008: through their table at 0.4, 0.5 and 0.7 µm";

constexpr Dispersion kBk7 =
    sellmeier(1.03961212, 0.231792344, 1.01046945, 0.00600069867, 0.0200179144, 103.560653);
constexpr Dispersion kBaf10 =
    sellmeier(1.5851495, 0.143559385, 1.08521269, 0.00926681282, 0.0424489805, 105.613573);
constexpr Dispersion kBak1 =
    sellmeier(1.12365662, 0.309276848, 0.881511957, 0.00644742752, 0.0222284402, 107.297751);
constexpr Dispersion kBak4 =
    sellmeier(1.28834642, 0.132817724, 0.945395373, 0.00779980626, 0.0315631177, 105.965875);
constexpr Dispersion kK5 =
    sellmeier(1.08511833, 0.199562005, 0.930511663, 0.00661099503, 0.024110866, 111.982777);
constexpr Dispersion kSk16 =
    sellmeier(1.34317774, 0.241144399, 0.994317969, 0.00704687339, 0.0229005, 92.7508526);
constexpr Dispersion kLasf9 =
    sellmeier(2.00029547, 0.298926886, 1.80691843, 0.0121426017, 0.0538736236, 156.530829);
constexpr Dispersion kSilica =
    resonant(0.6961663, 0.4079426, 0.8974794, 0.0684043, 0.1162414, 9.896161);
constexpr Dispersion kPmma = sellmeier(1.1819, 0, 0, 0.011313, 0, 0);

/// Today's glasses without lead or arsenic begin with N-; of those that are the same in name and
/// index as before, but for digits that nobody sees, the old name stands for them, too.
constexpr Glass kGlasses[] = {
    {"BK7", kBk7, kSchott},
    {"N-BK7", kBk7, kSchott},
    {"K5", kK5, kSchott},
    {"N-K5", kK5, kSchott},
    {"N-FK51A",
     sellmeier(0.971247817, 0.216901417, 0.904651666, 0.00472301995, 0.0153575612, 168.68133),
     kSchott},
    {"BAK1", kBak1, kSchott},
    {"N-BAK1", kBak1, kSchott},
    {"BAK4", kBak4, kSchott},
    {"N-BAK4", kBak4, kSchott},
    {"SK16", kSk16, kSchott},
    {"N-SK16", kSk16, kSchott},
    {"BAF10", kBaf10, kSchott},
    {"N-BAF10", kBaf10, kSchott},
    {"F2", sellmeier(1.34533359, 0.209073176, 0.937357162, 0.00997743871, 0.0470450767, 111.886764),
     kSchott},
    {"N-F2", sellmeier(1.39757037, 0.159201403, 1.2686543, 0.00995906143, 0.0546931752, 119.248346),
     kSchott},
    {"SF5", sellmeier(1.46141885, 0.247713019, 0.949995832, 0.0111826126, 0.0508594669, 112.041888),
     kSchott},
    {"SF10", sellmeier(1.61625977, 0.259229334, 1.07762317, 0.0127534559, 0.0581983954, 116.60768),
     kSchott},
    {"SF11", sellmeier(1.73848403, 0.311168974, 1.17490871, 0.0136068604, 0.0615960463, 121.922711),
     kSchott},
    {"N-SF11", sellmeier(1.73759695, 0.313747346, 1.89878101, 0.013188707, 0.0623068142, 155.23629),
     kSchott},
    {"SF6", sellmeier(1.72448482, 0.390104889, 1.04572858, 0.0134871947, 0.0569318095, 118.557185),
     kSchott},
    {"N-SF6", sellmeier(1.77931763, 0.338149866, 2.08734474, 0.0133714182, 0.0617533621, 174.01759),
     kSchott},
    {"SF57", sellmeier(1.81651371, 0.428893641, 1.07186278, 0.0143704198, 0.0592801172, 121.419942),
     kSchott},
    {"LASF9", kLasf9, kSchott},
    {"N-LASF9", kLasf9, kSchott},
    {"fused silica", kSilica, kMalitson},
    {"quartz glass", kSilica, kMalitson},
    {"sapphire", resonant(1.4313493, 0.65054713, 5.3414021, 0.0726631, 0.1193242, 18.028251),
     kSapphire},
    {"diamond", resonant(0.3306, 4.3356, 0, 0.1750, 0.1060, 0), kPeter},
    {"acrylic", kPmma, kSultanova},
    {"PMMA", kPmma, kSultanova},
    {"polycarbonate", sellmeier(1.4182, 0, 0, 0.021304, 0, 0), kSultanova},
    {"polystyrene", sellmeier(1.4435, 0, 0, 0.020216, 0, 0), kSultanova},
    {"water",
     sellmeier(0.5684027565, 0.19347963488, 0.1130748688, 0.005101829712, 0.0190736720461127,
               10.69792721),
     kDaimon},
    {"ice", cauchy(1.300024, 0.0034995, -0.0000639), kWarren},
    {"ethanol", cauchy(1.35265, 0.00306, 0.00002), kRheims},
};

bool same_name(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char one, char other) { return lower(one) == lower(other); });
}

}  // namespace

double Glass::ior() const {
  return refractive_index(dispersion, 1, kLineD);
}

std::span<const Glass> glasses() {
  return kGlasses;
}

const Glass* glass_named(std::string_view name) {
  for (const Glass& glass : kGlasses)
    if (same_name(glass.name, name)) return &glass;
  return nullptr;
}

}  // namespace zraka
