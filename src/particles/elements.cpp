// SPDX-License-Identifier: Apache-2.0
#include "particles/elements.hpp"

#include <iterator>

namespace zraka {
namespace {

constexpr Element kElements[] = {
    {"H", 1.20f, 0.31f, 0xFFFFFF},  {"He", 1.40f, 0.28f, 0xD9FFFF}, {"Li", 1.81f, 1.28f, 0xCC80FF},
    {"Be", 1.53f, 0.96f, 0xC2FF00}, {"B", 1.92f, 0.84f, 0xFFB5B5},  {"C", 1.70f, 0.76f, 0x909090},
    {"N", 1.55f, 0.71f, 0x3050F8},  {"O", 1.52f, 0.66f, 0xFF0D0D},  {"F", 1.47f, 0.57f, 0x90E050},
    {"Ne", 1.54f, 0.58f, 0xB3E3F5}, {"Na", 2.27f, 1.66f, 0xAB5CF2}, {"Mg", 1.73f, 1.41f, 0x8AFF00},
    {"Al", 1.84f, 1.21f, 0xBFA6A6}, {"Si", 2.10f, 1.11f, 0xF0C8A0}, {"P", 1.80f, 1.07f, 0xFF8000},
    {"S", 1.80f, 1.05f, 0xFFFF30},  {"Cl", 1.75f, 1.02f, 0x1FF01F}, {"Ar", 1.88f, 1.06f, 0x80D1E3},
    {"K", 2.75f, 2.03f, 0x8F40D4},  {"Ca", 2.31f, 1.76f, 0x3DFF00}, {"Sc", 2.58f, 1.70f, 0xE6E6E6},
    {"Ti", 2.46f, 1.60f, 0xBFC2C7}, {"V", 2.42f, 1.53f, 0xA6A6AB},  {"Cr", 2.45f, 1.39f, 0x8A99C7},
    {"Mn", 2.45f, 1.39f, 0x9C7AC7}, {"Fe", 2.44f, 1.32f, 0xE06633}, {"Co", 2.40f, 1.26f, 0xF090A0},
    {"Ni", 2.40f, 1.24f, 0x50D050}, {"Cu", 2.38f, 1.32f, 0xC88033}, {"Zn", 2.39f, 1.22f, 0x7D80B0},
    {"Ga", 1.87f, 1.22f, 0xC28F8F}, {"Ge", 2.11f, 1.20f, 0x668F8F}, {"As", 1.85f, 1.19f, 0xBD80E3},
    {"Se", 1.90f, 1.20f, 0xFFA100}, {"Br", 1.83f, 1.20f, 0xA62929}, {"Kr", 2.02f, 1.16f, 0x5CB8D1},
    {"Rb", 3.03f, 2.20f, 0x702EB0}, {"Sr", 2.49f, 1.95f, 0x00FF00}, {"Y", 2.75f, 1.90f, 0x94FFFF},
    {"Zr", 2.52f, 1.75f, 0x94E0E0}, {"Nb", 2.56f, 1.64f, 0x73C2C9}, {"Mo", 2.45f, 1.54f, 0x54B5B5},
    {"Tc", 2.44f, 1.47f, 0x3B9E9E}, {"Ru", 2.46f, 1.46f, 0x248F8F}, {"Rh", 2.44f, 1.42f, 0x0A7D8C},
    {"Pd", 2.15f, 1.39f, 0x006985}, {"Ag", 2.53f, 1.45f, 0xC0C0C0}, {"Cd", 2.49f, 1.44f, 0xFFD98F},
    {"In", 1.93f, 1.42f, 0xA67573}, {"Sn", 2.17f, 1.39f, 0x668080}, {"Sb", 2.06f, 1.39f, 0x9E63B5},
    {"Te", 2.06f, 1.38f, 0xD47A00}, {"I", 1.98f, 1.39f, 0x940094},  {"Xe", 2.16f, 1.40f, 0x429EB0},
    {"Cs", 3.43f, 2.44f, 0x57178F}, {"Ba", 2.68f, 2.15f, 0x00C900}, {"La", 2.98f, 2.07f, 0x70D4FF},
    {"Ce", 2.88f, 2.04f, 0xFFFFC7}, {"Pr", 2.92f, 2.03f, 0xD9FFC7}, {"Nd", 2.95f, 2.01f, 0xC7FFC7},
    {"Pm", 2.4f, 1.99f, 0xA3FFC7},  {"Sm", 2.90f, 1.98f, 0x8FFFC7}, {"Eu", 2.87f, 1.98f, 0x61FFC7},
    {"Gd", 2.83f, 1.96f, 0x45FFC7}, {"Tb", 2.79f, 1.94f, 0x30FFC7}, {"Dy", 2.87f, 1.92f, 0x1FFFC7},
    {"Ho", 2.81f, 1.92f, 0x00FF9C}, {"Er", 2.83f, 1.89f, 0x00E675}, {"Tm", 2.79f, 1.90f, 0x00D452},
    {"Yb", 2.80f, 1.87f, 0x00BF38}, {"Lu", 2.74f, 1.87f, 0x00AB24}, {"Hf", 2.63f, 1.75f, 0x4DC2FF},
    {"Ta", 2.53f, 1.70f, 0x4DA6FF}, {"W", 2.57f, 1.62f, 0x2194D6},  {"Re", 2.49f, 1.51f, 0x267DAB},
    {"Os", 2.48f, 1.44f, 0x266696}, {"Ir", 2.41f, 1.41f, 0x175487}, {"Pt", 2.29f, 1.36f, 0xD0D0E0},
    {"Au", 2.32f, 1.36f, 0xFFD123}, {"Hg", 2.45f, 1.32f, 0xB8B8D0}, {"Tl", 1.96f, 1.45f, 0xA6544D},
    {"Pb", 2.02f, 1.46f, 0x575961}, {"Bi", 2.07f, 1.48f, 0x9E4FB5}, {"Po", 1.97f, 1.40f, 0xAB5C00},
    {"At", 2.02f, 1.50f, 0x754F45}, {"Rn", 2.20f, 1.50f, 0x428296}, {"Fr", 3.48f, 2.60f, 0x420066},
    {"Ra", 2.83f, 2.21f, 0x007D00}, {"Ac", 2.80f, 2.15f, 0x70ABFA}, {"Th", 2.93f, 2.06f, 0x00BAFF},
    {"Pa", 2.88f, 2.00f, 0x00A1FF}, {"U", 2.71f, 1.96f, 0x008FFF},  {"Np", 2.82f, 1.90f, 0x0080FF},
    {"Pu", 2.81f, 1.87f, 0x006BFF}, {"Am", 2.83f, 1.80f, 0x545CF2}, {"Cm", 3.05f, 1.69f, 0x785CE3},
    {"Bk", 3.40f, 1.6f, 0x8A4FE3},  {"Cf", 3.05f, 1.6f, 0xA136D4},  {"Es", 2.70f, 1.6f, 0xB31FD4},
    {"Fm", 2.4f, 1.6f, 0xB31FBA},   {"Md", 2.4f, 1.6f, 0xB30DA6},   {"No", 2.4f, 1.6f, 0xBD0D87},
    {"Lr", 2.4f, 1.6f, 0xC70066},   {"Rf", 2.4f, 1.6f, 0xCC0059},   {"Db", 2.4f, 1.6f, 0xD1004F},
    {"Sg", 2.4f, 1.6f, 0xD90045},   {"Bh", 2.4f, 1.6f, 0xE00038},   {"Hs", 2.4f, 1.6f, 0xE6002E},
    {"Mt", 2.4f, 1.6f, 0xEB0026}};
static_assert(std::size(kElements) == 109);

constexpr char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}
constexpr bool is_letter(char c) {
  return upper(c) >= 'A' && upper(c) <= 'Z';
}

/// By one letter, or two.
const Element* find(char first, char second) {
  for (const Element& element : kElements) {
    const std::string_view symbol = element.symbol;
    if (symbol[0] == upper(first) &&
        (symbol.size() == 1 ? second == '\0' : upper(symbol[1]) == upper(second)))
      return &element;
  }
  return second == '\0' && upper(first) == 'D' ? &kElements[0] : nullptr;
}

}  // namespace

const Element* element_of_number(unsigned number) {
  return number >= 1 && number <= std::size(kElements) ? &kElements[number - 1] : nullptr;
}

const Element* element_of_symbol(std::string_view symbol) {
  if (symbol.empty() || symbol.size() > 2) return nullptr;
  return find(symbol[0], symbol.size() == 2 ? symbol[1] : '\0');
}

const Element* element_of_label(std::string_view label) {
  std::size_t letters = 0;
  while (letters < label.size() && is_letter(label[letters])) ++letters;
  if (letters == 0) return nullptr;
  const Element* const one = find(label[0], '\0');
  const Element* const two = letters > 1 ? find(label[0], label[1]) : nullptr;
  if (letters == 2 && label[1] != upper(label[1])) return two != nullptr ? two : one;
  return one != nullptr ? one : two;
}

}  // namespace zraka
