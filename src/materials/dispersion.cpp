#include "materials/dispersion.hpp"
namespace zraka {
double refractive_index(const Dispersion& d, double ior, double um) {
  if (d.kind == Dispersion::Kind::cauchy) return d.numbers[0] + d.numbers[1] / (um * um);
  return ior;
}
}
