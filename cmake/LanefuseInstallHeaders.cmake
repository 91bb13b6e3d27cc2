# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# Runs while installing: copies the headers of LANEFUSE_ROOMS from LANEFUSE_SOURCE_DIR to LANEFUSE_HEADER_DIR and turns
# their includes of each other into <lanefuse/...>. Headers that need generated code belong to their room alone.
string(REPLACE ";" "|" any_room "${LANEFUSE_ROOMS}")
foreach(room IN LISTS LANEFUSE_ROOMS)
  file(GLOB headers RELATIVE ${LANEFUSE_SOURCE_DIR} ${LANEFUSE_SOURCE_DIR}/${room}/*.hpp)
  foreach(header IN LISTS headers)
    file(READ ${LANEFUSE_SOURCE_DIR}/${header} text)
    if(text MATCHES "#include \"[^\"]*\\.pb\\.h\"")
      continue()
    endif()
    string(REGEX REPLACE "#include \"((${any_room})/[^\"]+)\"" "#include <lanefuse/\\1>" text "${text}")
    file(WRITE ${LANEFUSE_HEADER_DIR}/${header} "${text}")
  endforeach()
endforeach()
