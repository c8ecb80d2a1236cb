// SPDX-License-Identifier: Apache-2.0
#include "school/late/late_function.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>

namespace zraka {
namespace {

/// dlopen() counts, and gives the same library each time.
void* open_library(const char* file) {
  return ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
}

}  // namespace

Result<void> LateLibrary::load() const {
  if (open_library(file_) != nullptr) return {};
  return failure("", fmt::format("the library {} is missing", file_),
                 "install it with the system's packages");
}

void* LateLibrary::function(const char* name) const {
  void* const library = open_library(file_);
  void* const found = library == nullptr ? nullptr : ::dlsym(library, name);
  if (found != nullptr) return found;
  fmt::print(stderr, "error: the library {} {} {}\n", file_,
             library == nullptr ? "is missing, and with it" : "has no", name);
  std::abort();
}

}  // namespace zraka
