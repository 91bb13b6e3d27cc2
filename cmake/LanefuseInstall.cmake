# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs the libraries as lanefuse::core, lanefuse::pipeline, ... for find_package(lanefuse), their headers as
# <lanefuse/ROOM/...>. The program installs itself (src/cli).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

get_property(lanefuse_rooms GLOBAL PROPERTY LANEFUSE_LIBRARIES)
set(lanefuse_package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/lanefuse)

list(TRANSFORM lanefuse_rooms PREPEND lanefuse_ OUTPUT_VARIABLE lanefuse_targets)
install(TARGETS ${lanefuse_targets} EXPORT lanefuse-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT lanefuse-targets NAMESPACE lanefuse:: DESTINATION ${lanefuse_package_directory})

# Our own sources say "core/pose2.hpp"; users say <lanefuse/core/pose2.hpp>, and so do the headers that they get.
install(CODE "
  set(LANEFUSE_ROOMS \"${lanefuse_rooms}\")
  set(LANEFUSE_SOURCE_DIR \"${CMAKE_CURRENT_SOURCE_DIR}/src\")
  set(LANEFUSE_HEADER_DIR \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/lanefuse\")
  include(\"${CMAKE_CURRENT_SOURCE_DIR}/cmake/LanefuseInstallHeaders.cmake\")
")

configure_package_config_file(cmake/lanefuse-config.cmake.in ${CMAKE_BINARY_DIR}/package/lanefuse-config.cmake
                              INSTALL_DESTINATION ${lanefuse_package_directory})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/lanefuse-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
file(GLOB lanefuse_find_modules ${CMAKE_CURRENT_SOURCE_DIR}/cmake/Find*.cmake)
install(FILES ${CMAKE_BINARY_DIR}/package/lanefuse-config.cmake
              ${CMAKE_BINARY_DIR}/package/lanefuse-config-version.cmake ${lanefuse_find_modules}
        DESTINATION ${lanefuse_package_directory})
