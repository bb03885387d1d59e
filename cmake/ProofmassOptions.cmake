# SPDX-License-Identifier: Apache-2.0
# Compiler options that every target of ours shares, as one interface target.
add_library(proofmass_options INTERFACE)
# No contraction across statements: the same source must give the same bits on one SIMD target
# whatever the optimiser decides to inline. Fused products are written out where they are wanted.
target_compile_options(proofmass_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -Wzero-as-null-pointer-constant -ffp-contract=off
  $<$<BOOL:${PROOFMASS_WERROR}>:-Werror>)
# GCC 12 sees overlap in joining strings where there is none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(proofmass_options INTERFACE -Wno-restrict)
endif()
if(PROOFMASS_SANITIZE)
  # A null pointer that is used ends the program under AddressSanitizer too: checking each use takes a tenth of the
  # compiler's time. Of the instruction sets with vectors of one length, one is enough; threads share the rows of any
  # in the same way, and one with vectors is enough for ThreadSanitizer.
  target_compile_options(proofmass_options INTERFACE -fsanitize=${PROOFMASS_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(PROOFMASS_SANITIZE MATCHES undefined)
    target_compile_options(proofmass_options INTERFACE -fno-sanitize=null)
  endif()
  if(PROOFMASS_SANITIZE MATCHES thread)
    target_compile_definitions(proofmass_options INTERFACE "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4|HWY_AVX3)")
  else()
    target_compile_definitions(proofmass_options INTERFACE HWY_DISABLED_TARGETS=HWY_SSSE3)
  endif()
  target_link_options(proofmass_options INTERFACE -fsanitize=${PROOFMASS_SANITIZE})
endif()

# proofmass_compile_together(TARGET SOURCE…): where a preset asks for it (CMAKE_UNITY_BUILD), the sources of one module are
# compiled as one, so that their headers are read once and their templates made once. Highway compiles a file of kernels
# once for each instruction set; such a file stays by itself.
function(proofmass_compile_together target)
  foreach(source IN LISTS ARGN)
    if(NOT source MATCHES "_kernels?\\.cpp$")
      cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
      cmake_path(GET path PARENT_PATH folder)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
      string(REGEX REPLACE "^([^/]*/[^/]*)/.*" "\\1" module "${folder}")
      string(MAKE_C_IDENTIFIER "${module}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  # To GCC a source that another includes is a header, whose types should not be made of a source's own.
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# proofmass_precompile(TARGET HEADER…): where a preset asks for it (PROOFMASS_PRECOMPILE), headers of others are read
# once for all sources of the targets that list the same ones.
function(proofmass_precompile target)
  if(NOT PROOFMASS_PRECOMPILE)
    return()
  endif()
  string(MD5 group "${ARGN}")
  get_property(first GLOBAL PROPERTY proofmass_precompiled_${group})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY proofmass_precompiled_${group} ${target})
  endif()
endfunction()

# What ThreadSanitizer has tests for: the programs with tests of several threads.
if(PROOFMASS_BUILD_TESTS)
  add_custom_target(thread_tests)
endif()

# proofmass_keep_suites(SOURCES FILTER…): leaves in the list SOURCES the files with a suite that one of gtest's filters
# names.
function(proofmass_keep_suites sources)
  set(kept)
  foreach(filter IN LISTS ARGN)
    string(REGEX REPLACE "^(\\*/)?([^.]*)\\..*" "\\2" suite "${filter}")
    set(files)
    foreach(source IN LISTS ${sources})
      file(STRINGS ${source} tests REGEX "^[A-Z_]+\\(${suite}, ")
      if(tests)
        list(APPEND files ${source})
      endif()
    endforeach()
    if(NOT files)
      message(FATAL_ERROR "No source has a test suite of the filter ${filter}")
    endif()
    list(APPEND kept ${files})
  endforeach()
  list(REMOVE_DUPLICATES kept)
  set(${sources} ${kept} PARENT_SCOPE)
endfunction()

# proofmass_add_tests(NAME SOURCES FILE… [STATISTICS FILTER…] [THREADS FILTER…] [ALONE FILE…]): a test program with the
# shared test support. A filter is gtest's and matches names of tests. Each test has one label, by which the presets
# choose what a sanitizer runs:
#   NAME.statistics  statistics over many repeats, whose code other tests run too: the optimised build alone runs them
#   NAME.threads     runs several threads: what ThreadSanitizer runs; of the sources, it compiles those that have some
#   NAME             any other
# ALONE are sources that are never compiled together with others, for want of names of their own.
function(proofmass_add_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;STATISTICS;THREADS;ALONE")
  if(PROOFMASS_SANITIZE STREQUAL thread AND arg_THREADS)
    proofmass_keep_suites(arg_SOURCES ${arg_THREADS})
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE proofmass proofmass_options proofmass_test_support)
  # What is tested is optimised, not the tests: that would take most of the time to build them.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-Og>)
  proofmass_compile_together(${name} ${arg_SOURCES})
  proofmass_precompile(${name} <gmock/gmock.h> <gtest/gtest.h>)
  if(arg_ALONE)
    set_source_files_properties(${arg_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()

  list(JOIN arg_STATISTICS : statistics)
  list(JOIN arg_THREADS : threads)
  proofmass_discover_tests(${name} ${name} "*-${statistics}:${threads}")
  if(arg_STATISTICS)
    proofmass_discover_tests(${name} ${name}.statistics "${statistics}")
  endif()
  if(arg_THREADS)
    proofmass_discover_tests(${name} ${name}.threads "${threads}-${statistics}")
    add_dependencies(thread_tests ${name})
  endif()
  if(arg_STATISTICS OR arg_THREADS)
    add_test(NAME structure.filters_of_${name} COMMAND bash ${PROJECT_SOURCE_DIR}/tests/filters_match.sh
      $<TARGET_FILE:${name}> ${arg_STATISTICS} ${arg_THREADS})
    set_tests_properties(structure.filters_of_${name} PROPERTIES LABELS structure)
  endif()
endfunction()

function(proofmass_discover_tests program label filter)
  gtest_discover_tests(${program} TEST_FILTER "${filter}" DISCOVERY_TIMEOUT 120
    PROPERTIES TIMEOUT 1200 LABELS ${label})
endfunction()

# proofmass_header_closure(HEADER RESULT): the header, whose path is that of an include, and all of ours that it includes
# directly or through others, as absolute paths.
function(proofmass_header_closure header result)
  set(waiting ${header})
  set(found)
  while(waiting)
    list(POP_FRONT waiting next)
    if(next IN_LIST found)
      continue()
    endif()
    list(APPEND found ${next})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${next})
    file(STRINGS ${PROJECT_SOURCE_DIR}/${next} lines REGEX "^#include \"proofmass/")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" include "${line}")
      list(APPEND waiting ${include})
    endforeach()
  endwhile()
  list(TRANSFORM found PREPEND ${PROJECT_SOURCE_DIR}/)
  set(${result} ${found} PARENT_SCOPE)
endfunction()
