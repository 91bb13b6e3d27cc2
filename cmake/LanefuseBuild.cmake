# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# How every target of Lanefuse is built: language, warnings, determinism, and one library a folder of src/.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

set(LANEFUSE_SANITIZE "" CACHE STRING "Sanitizers to build with, as for -fsanitize")
if(LANEFUSE_SANITIZE)
  add_compile_options(-fsanitize=${LANEFUSE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${LANEFUSE_SANITIZE})
endif()

add_library(lanefuse_options INTERFACE)
target_compile_options(lanefuse_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Werror
  # Plain structs name their defaults at the member; a braced list may leave the rest to them.
  -Wno-missing-field-initializers
  # g++ 12 sees uninitialised reads inside std::optional where there are none; the sanitizers watch instead.
  -Wno-maybe-uninitialized
  # Same input, same bytes: no contraction of a*b+c, whatever the optimisation level.
  -ffp-contract=off)
target_link_libraries(lanefuse_options INTERFACE Eigen3::Eigen fmt::fmt)

# lanefuse_library(NAME DEPENDS core ...): the library of src/NAME.
#
# Each folder sees only itself and the folders it depends on: the include path holds one directory a library, which
# contains nothing but a link to that library's folder. An include against the architecture's arrows does not compile.
function(lanefuse_library name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  set(target lanefuse_${name})
  set(view ${CMAKE_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${view}/${name} SYMBOLIC)
  if(NOT sources)
    message(FATAL_ERROR "src/${name} has no sources")
  endif()
  add_library(${target} STATIC ${sources})
  add_library(lanefuse::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:include>)
  list(TRANSFORM ARG_DEPENDS PREPEND lanefuse_)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} Eigen3::Eigen fmt::fmt ${ARG_LINKS}
                        PRIVATE $<BUILD_INTERFACE:lanefuse_options>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  lanefuse_precompile(${target})
  set_property(GLOBAL APPEND PROPERTY LANEFUSE_LIBRARIES ${name})
endfunction()

# lanefuse::public_headers lets code in the build tree say <lanefuse/core/pose2.hpp>, as users of an installation do.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/include/public)
file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/src ${CMAKE_BINARY_DIR}/include/public/lanefuse SYMBOLIC)
add_library(lanefuse_public_headers INTERFACE)
add_library(lanefuse::public_headers ALIAS lanefuse_public_headers)
target_include_directories(lanefuse_public_headers INTERFACE ${CMAKE_BINARY_DIR}/include/public)

# Eigen costs seconds a translation unit: precompile it once, in core, and share it.
function(lanefuse_precompile target)
  if(NOT LANEFUSE_PCH)
    return()
  endif()
  if(target STREQUAL "lanefuse_core")
    target_precompile_headers(${target} PRIVATE <Eigen/Dense> <cstdint> <optional> <string> <vector> <fmt/format.h>)
  else()
    target_precompile_headers(${target} REUSE_FROM lanefuse_core)
  endif()
endfunction()
