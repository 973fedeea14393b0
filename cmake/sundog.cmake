# SPDX-License-Identifier: Apache-2.0
# The two ways in which this project makes targets.

add_library(sundog_options INTERFACE)
target_compile_features(sundog_options INTERFACE cxx_std_20)
target_include_directories(sundog_options INTERFACE ${CMAKE_SOURCE_DIR}/src)
target_compile_options(sundog_options INTERFACE -Wall -Wextra -Wpedantic)
if(SUNDOG_WERROR)
  target_compile_options(sundog_options INTERFACE -Werror)
endif()
if(SUNDOG_NATIVE)
  target_compile_options(sundog_options INTERFACE -march=native)
endif()
if(SUNDOG_SANITIZE)
  # All but targets with the property UNSANITIZED: the wide kernels, over which sanitizers take longer than over all the rest.
  target_compile_options(sundog_options INTERFACE
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNSANITIZED>>>:-fsanitize=address,undefined;-fno-sanitize-recover=all;-fno-omit-frame-pointer>")
  target_link_options(sundog_options INTERFACE -fsanitize=address,undefined)
endif()
# GCC takes parts of variants for uninitialised: from version 13 on, and in instrumented code before (its manual warns of
# that with -fsanitize).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND (SUNDOG_SANITIZE OR CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13))
  target_compile_options(sundog_options INTERFACE -Wno-maybe-uninitialized)
endif()
if(SUNDOG_FUZZ)
  target_compile_options(sundog_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
# The same arithmetic on every x86-64 machine: no contraction into fused multiply-adds behind our back.
target_compile_options(sundog_options INTERFACE -ffp-contract=off)

# sundog_library(name SOURCES a.cpp … DEPS targets …): a static library sundog_<name>.
function(sundog_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPS;PRIVATE_DEPS" ${ARGN})
  add_library(sundog_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(sundog_${name} PUBLIC sundog_options ${ARG_DEPS} PRIVATE ${ARG_PRIVATE_DEPS})
endfunction()

# sundog_test(name [FOREIGN_LEAKS] [SLOW] SOURCES a_test.cpp … DEPS targets …): a GoogleTest program whose cases CTest runs one by
# one. FOREIGN_LEAKS: drivers or system libraries that it loads leak (Mesa's, D-Bus), so sanitized runs don't ask for leaks. SLOW: started
# before others, so that the last ones to end aren't long.
function(sundog_test name)
  if(NOT SUNDOG_TESTS)
    return()
  endif()
  cmake_parse_arguments(ARG "FOREIGN_LEAKS;SLOW" "" "SOURCES;DEPS" ${ARGN})
  set(environment)
  if(ARG_FOREIGN_LEAKS)
    set(environment ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  endif()
  set(cost 0)
  if(ARG_SLOW)
    set(cost 100)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE sundog_options ${ARG_DEPS} GTest::gtest_main)
  # What tests do themselves is quick; building them is most of the build after the kernels.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_compile_definitions(${name} PRIVATE SUNDOG_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300 COST ${cost} ${environment})
endfunction()
