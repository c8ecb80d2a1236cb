# SPDX-License-Identifier: Apache-2.0
# What `cpack` makes in the build tree: -G DEB a Debian package of each component, -G TGZ an archive of the program that
# runs from wherever it is unpacked, with the libraries that it needs (packaging/pack).
include(GNUInstallDirs)
set(CPACK_PACKAGE_NAME zraka)
set(CPACK_PACKAGE_VENDOR "the authors of zraka")
set(CPACK_PACKAGE_CONTACT "The authors of zraka <zraka@example.org>" CACHE STRING "Who answers for the packages")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_GENERATOR DEB)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/generator.cmake)
set(CPACK_COMPONENTS_ALL library dev)
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(what_it_is "A Whitted ray tracer: spheres, cylinders, tori and other exact shapes, meshes,
particles by the million, glass with dispersion, the same bits on every
machine. It explains how the colour of each pixel came about.")

# zraka_package(COMPONENT NAME SECTION SYNOPSIS DESCRIPTION): and what Debian wants to be in each.
set(debian ${CMAKE_CURRENT_LIST_DIR}/debian)
function(zraka_package component name section synopsis description)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${synopsis}\n${what_it_is}\n\n${description}" PARENT_SCOPE)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${name})
  install(FILES ${debian}/copyright DESTINATION ${folder} COMPONENT ${component})
  if(EXISTS ${debian}/${component}.lintian-overrides)
    install(FILES ${debian}/${component}.lintian-overrides RENAME ${name}
      DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component})
  endif()
  if(ZRAKA_GZIP)
    install(FILES ${PROJECT_BINARY_DIR}/changelog.Debian.gz DESTINATION ${folder} COMPONENT ${component})
  endif()
endfunction()

find_program(ZRAKA_GZIP gzip)
if(ZRAKA_GZIP)
  execute_process(COMMAND ${ZRAKA_GZIP} -9nc ${debian}/changelog
    OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.Debian.gz COMMAND_ERROR_IS_FATAL ANY)
endif()

zraka_package(library libzraka${soversion} libs "Whitted ray tracer, shared library"
  "This package has the library that programs run with.")
zraka_package(dev libzraka-dev libdevel "Whitted ray tracer, headers and static library"
  "This package has what other programs are compiled with, for CMake and for
pkg-config.")
set(CPACK_COMPONENT_DEV_DEPENDS library)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
# The headers include expected's; the static libraries are linked with all that they use.
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libexpected-dev, libtbb-dev, libpng-dev, zlib1g-dev, libzstd-dev, libjpeg-dev, \\
libopenexr-dev, libfmt-dev, nlohmann-json3-dev, nettle-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libarchive-dev, libqpdf-dev, libfreetype-dev, libfontconfig-dev")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${debian}/triggers)

if(TARGET zraka_program)
  list(APPEND CPACK_COMPONENTS_ALL program)
  zraka_package(program zraka graphics "Whitted ray tracer that says why each pixel has its colour"
    "This package has the program, which also draws what Tachyon draws, marks
students' pictures and asks questions about them.")
  # Loaded when they are needed: letters want a font, reports and submissions archives.
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libfreetype6, libfontconfig1, libarchive13, libqpdf29, fonts-dejavu-core")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "libzraka-dev, python3-zraka")

  get_property(late GLOBAL PROPERTY ZRAKA_LATE_FILES)
  # The archive's program, as it is built, looks for its libraries beside it; the one that is installed does not.
  install(PROGRAMS $<TARGET_FILE:zraka_program> DESTINATION bin COMPONENT portable EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/zraka-tachyon DESTINATION bin COMPONENT portable EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION . COMPONENT portable EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION . COMPONENT portable EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/share/man1 DESTINATION share/man COMPONENT portable EXCLUDE_FROM_ALL)
  install(CODE "set(program [[$<TARGET_FILE:zraka_program>]])" COMPONENT portable EXCLUDE_FROM_ALL)
  install(CODE "set(late [[${late}]])" COMPONENT portable EXCLUDE_FROM_ALL)
  install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/take_libraries.cmake COMPONENT portable EXCLUDE_FROM_ALL)
endif()

if(TARGET zraka_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  zraka_package(python python3-zraka python "Whitted ray tracer, as a module of Python"
    "This package has the module, which takes and gives NumPy arrays.")
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next}), python3-numpy")
endif()

include(CPack)
