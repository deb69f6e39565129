# How every target of this house is compiled: one place for flags, so that all behave alike.
add_library(eod_flags INTERFACE)
target_include_directories(eod_flags INTERFACE ${PROJECT_SOURCE_DIR})
# No fused multiply-add: same inputs, same bits, whatever the optimiser likes.
target_compile_options(eod_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion -ffp-contract=off)
if(EOD_WERROR)
  target_compile_options(eod_flags INTERFACE -Werror)
endif()
if(EOD_SANITIZE)
  # Instrumented, g++ 12 takes moved optionals and <regex> for uninitialised; release looks at that.
  target_compile_options(eod_flags INTERFACE -Wno-maybe-uninitialized)
  target_compile_options(eod_flags INTERFACE -fsanitize=${EOD_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
  if(EOD_SANITIZE MATCHES "undefined")
    # g++ 12 miscompiles the check of LCM's calls through member pointers (lcm-cpp-impl.hpp:88).
    target_compile_options(eod_flags INTERFACE -fno-sanitize=vptr)
  endif()
  target_link_options(eod_flags INTERFACE -fsanitize=${EOD_SANITIZE})
endif()

# eod_library(NAME SOURCES a.cpp ... [DEPENDS public deps ...] [HIDES private deps ...])
function(eod_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;HIDES" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC eod_flags ${ARG_DEPENDS} PRIVATE ${ARG_HIDES})
endfunction()

# eod_program(NAME SOURCES main.cpp ... DEPENDS ...)
function(eod_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE eod_flags ${ARG_DEPENDS})
  target_compile_definitions(${name} PRIVATE EOD_VERSION="${PROJECT_VERSION}"
                                             EOD_DATA_DIR="${PROJECT_SOURCE_DIR}")
endfunction()

# eod_test(NAME SOURCES a_test.cpp ... DEPENDS ... [LABELS ...] [NETWORK])
# NETWORK: uses multicast, so it runs in a network namespace of its own (tests/netns).
function(eod_test name)
  cmake_parse_arguments(ARG "NETWORK" "TIMEOUT" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE eod_flags ${ARG_DEPENDS} GTest::gmock GTest::gtest_main)
  if(EOD_SANITIZE)
    # Optimising instrumented googletest takes longer than it saves.
    target_compile_options(${name} PRIVATE -O0)
  endif()
  target_compile_definitions(${name} PRIVATE EOD_DATA_DIR="${PROJECT_SOURCE_DIR}"
                                             EOD_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(ARG_NETWORK)
    add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/netns $<TARGET_FILE:${name}>)
  else()
    add_test(NAME ${name} COMMAND ${name})
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
