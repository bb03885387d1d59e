# SPDX-License-Identifier: Apache-2.0
# Compiler options that every target of ours shares, as one interface target.
add_library(proofmass_options INTERFACE)
# No contraction across statements: the same source must give the same bits on one SIMD target
# whatever the optimiser decides to inline. Fused products are written out where they are wanted.
target_compile_options(proofmass_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -ffp-contract=off
  $<$<BOOL:${PROOFMASS_WERROR}>:-Werror>)
# GCC 12 sees overlap in joining strings where there is none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(proofmass_options INTERFACE -Wno-restrict)
endif()
if(PROOFMASS_SANITIZE)
  target_compile_options(proofmass_options INTERFACE -fsanitize=${PROOFMASS_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(proofmass_options INTERFACE -fsanitize=${PROOFMASS_SANITIZE})
endif()

# A test program from the sources given, with the shared test support; its tests carry its name as their label.
function(proofmass_add_tests name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE proofmass proofmass_options proofmass_test_support)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 120 PROPERTIES TIMEOUT 1200 LABELS ${name})
endfunction()
