# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# cmake -D BUILD=... -D WORK=... -D CONSUMER=... -D LESSON=... -D COMPILER=... [-D SANITIZE=...] -P consumer_test.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command} failed with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
file(GLOB_RECURSE own_includes ${WORK}/prefix/include/*.hpp)
foreach(header IN LISTS own_includes)
  file(STRINGS ${header} quoted REGEX "#include \"")
  if(quoted)
    message(FATAL_ERROR "${header} still has an include that only our own tree resolves: ${quoted}")
  endif()
endforeach()

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=${SANITIZE}")
endif()
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D lanefuse_INCLUDE_ROOT=${WORK}/prefix/include -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
if(NOT output MATCHES "20.00 1.75")
  message(FATAL_ERROR "The consumer said: ${output}")
endif()
run(${CMAKE_COMMAND} -S ${LESSON} -B ${WORK}/lesson -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${WORK}/lesson)
file(REMOVE_RECURSE ${WORK})
