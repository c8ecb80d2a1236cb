# SPDX-License-Identifier: Apache-2.0
# Manual pages, completions and the schema of the scene language: the program writes them itself.
find_program(ZRAKA_GZIP gzip)
set(written ${PROJECT_BINARY_DIR}/share)
set(pack "")
if(ZRAKA_GZIP)  # as manual pages are kept
  set(pack COMMAND sh -c "exec '${ZRAKA_GZIP}' -9nf '${written}'/man1/*.1")
endif()
add_custom_command(OUTPUT ${written}/written
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${written}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${written}
  COMMAND zraka_program help --manual ${written}/man1
  ${pack}
  COMMAND zraka_program help --completions bash > ${written}/zraka.bash
  COMMAND zraka_program help --completions zsh > ${written}/_zraka
  COMMAND zraka_program help --completions fish > ${written}/zraka.fish
  COMMAND zraka_program schema > ${written}/scene.schema.json
  COMMAND ${CMAKE_COMMAND} -E touch ${written}/written
  DEPENDS zraka_program VERBATIM COMMENT "Writing manual pages, completions and the schema")
add_custom_target(zraka_written ALL DEPENDS ${written}/written)

install(DIRECTORY ${written}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES ${written}/zraka.bash RENAME zraka COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${written}/_zraka DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${written}/zraka.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(FILES ${written}/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/zraka COMPONENT program)
