# SPDX-License-Identifier: Apache-2.0
# Puts the libraries beside the archive's program that it needs: all but the C library's own, which belong to the kernel
# and to each other. `program` and `late`, what it loads when it needs it, are set by packages.cmake.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${program} LIBRARIES ${late}
  RESOLVED_DEPENDENCIES_VAR found
  PRE_EXCLUDE_REGEXES "^(libc|libm|libdl|libpthread|librt|libresolv|ld-linux.*)\\.so")
foreach(library ${found} ${late})
  file(INSTALL DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/zraka TYPE SHARED_LIBRARY FOLLOW_SYMLINK_CHAIN FILES ${library})
endforeach()
