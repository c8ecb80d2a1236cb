// SPDX-License-Identifier: Apache-2.0
#include "render/isa.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "scene/reals.hpp"

namespace zraka {
namespace {

/// Also asks the operating system, which must save the wider registers.
bool machine_has(Isa isa) {
#if defined(ZRAKA_HAVE_X86)
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  if (isa == Isa::avx2) return avx2;
  if (isa == Isa::avx512)
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#endif
  return isa == Isa::portable || (isa == Isa::oracle && ZRAKA_ORACLE != 0);
}

std::string names_of(const std::vector<Isa>& isas) {
  std::string names;
  for (const Isa isa : isas) names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(isa));
  return names;
}

}  // namespace

std::string_view name_of(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return "avx512";
    case Isa::avx2:
      return "avx2";
    case Isa::portable:
      return "portable";
    case Isa::oracle:
      return "oracle";
  }
  return "";
}

std::optional<Isa> isa_named(std::string_view name) {
  std::string plain;  // AVX-512 is avx512
  for (const char c : name)
    if (c != '-') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  for (const Isa isa : {Isa::avx512, Isa::avx2, Isa::portable, Isa::oracle})
    if (plain == name_of(isa)) return isa;
  return std::nullopt;
}

std::vector<Isa> available_isas() {
  std::vector<Isa> isas;
  for (const Isa isa : {Isa::avx512, Isa::avx2, Isa::portable})
    if (machine_has(isa)) isas.push_back(isa);
  return isas;
}

Result<Isa> choose_isa(std::optional<Isa> wanted) {
  if (!wanted) {
    const char* name = std::getenv("ZRAKA_ISA");
    if (name == nullptr || *name == '\0') return available_isas().front();
    wanted = isa_named(name);
    if (!wanted)
      return failure(
          "",
          fmt::format("the environment's ZRAKA_ISA names '{}', which is no instruction set", name),
          "use avx512, avx2 or portable");
  }
  if (*wanted == Isa::oracle && !machine_has(*wanted))
    return failure("", "this zraka was built without the oracle, which is for its tests",
                   "use " + names_of(available_isas()));
  if (!machine_has(*wanted))
    return failure(
        "", fmt::format("this machine does not have the instruction set {}", name_of(*wanted)),
        "it has " + names_of(available_isas()));
  return *wanted;
}

const Kernel<float>& kernel_of([[maybe_unused]] Isa isa) {
#if defined(ZRAKA_HAVE_X86)
  if (isa == Isa::avx512) return isa_avx512::kKernel;
  if (isa == Isa::avx2) return isa_avx2::kKernel;
#endif
  return isa_portable::kKernel;
}

RecordTile<float>& record_tile() {
  return isa_portable::record_tile;
}

RecordRays<float>& record_rays() {
  return isa_portable::record_rays;
}

}  // namespace zraka
