# Checks of the sources beside the test programs; in ctest with -DCLOD_CHECKS=ON (make test).
# Labels: lint, build, sanitize, mutation, bench, package. The times only end what hangs: they are ten
# times what two cores need, and more, so that a busy machine fails nothing.
file(GLOB_RECURSE CLOD_LAYERED CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}
  src/*.[ch] include/*.h app/*.[ch])
file(GLOB_RECURSE CLOD_BESIDE CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}
  tests/*.[ch] bench/*.[ch] examples/*.[ch])
set(CLOD_ALL ${CLOD_LAYERED} ${CLOD_BESIDE})
file(GLOB_RECURSE CLOD_PYTHON CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}
  tests/*.py bench/*.py cases/*.py python/*.py tools/*.py)
set(CLOD_HEADERS ${CLOD_LAYERED})
list(FILTER CLOD_HEADERS INCLUDE REGEX "^(src|include)/.*\\.h$")
if(NOT neon IN_LIST CLOD_SETS) # its intrinsics are the compiler's for ARM; tools/check-arm builds it
  list(FILTER CLOD_HEADERS EXCLUDE REGEX "simd/neon\\.h$")
endif()
set(CLOD_COMPILED ${CLOD_LAYERED})
list(FILTER CLOD_COMPILED INCLUDE REGEX "\\.c$")

function(clod_add_check name seconds)
  string(REGEX REPLACE "/.*" "" label ${name})
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${seconds})
endfunction()

clod_add_check(lint/format 600 clang-format-14 --dry-run -Werror ${CLOD_ALL})
clod_add_check(lint/layers 600 tools/check-layers ${CLOD_ALL})
clod_add_check(lint/layers-selftest 600 tools/check-layers-selftest)
clod_add_check(lint/style 600 tools/check-style ${CLOD_ALL} ${CLOD_PYTHON})
clod_add_check(lint/words 600 tools/check-words)
clod_add_check(lint/links 600 tools/check-links .)
clod_add_check(lint/subjects 600 tools/check-subjects)
clod_add_check(lint/headers-gcc 1200 tools/check-headers gcc ${CLOD_HEADERS})
clod_add_check(lint/headers-clang 1200 tools/check-headers clang-14 ${CLOD_HEADERS})
set(CLOD_PUBLIC ${CLOD_LAYERED})
list(FILTER CLOD_PUBLIC INCLUDE REGEX "^include/")
clod_add_check(lint/public 600 tools/check-public ${CLOD_PUBLIC})
# uninitvar is left to gcc, clang and the sanitizers: cppcheck does not follow arrays filled in loops.
# One configuration with all parts, in the scalar vocabulary: every subset takes five times as long.
clod_add_check(lint/cppcheck 1800 cppcheck --enable=warning,performance,portability --inline-suppr
  -D__linux__=1 -D__x86_64__=1 -DCLOD_MPI=1 -DCLOD_GSL=1 -DCLOD_REPORT_BUNDLE=1
  --suppress=missingIncludeSystem --suppress=uninitvar --error-exitcode=1 --quiet -j2 -Iinclude -Isrc ${CLOD_COMPILED})

# Two more trees: clang without any warning, all unit tests under AddressSanitizer and
# UndefinedBehaviorSanitizer, the fuzz targets, and the threaded tests under ThreadSanitizer.
set(CLOD_CTEST ${CMAKE_CTEST_COMMAND} --output-on-failure --no-tests=error -j2 -LE "^slow$")
clod_add_check(build/asan 3600 tools/build-tree asan ${CMAKE_BINARY_DIR}/asan)
clod_add_check(build/tsan 3600 tools/build-tree tsan ${CMAKE_BINARY_DIR}/tsan threaded)
clod_add_check(lint/tidy 1800 tools/check-tidy ${CMAKE_BINARY_DIR}/asan ${CLOD_COMPILED})
clod_add_check(sanitize/asan 5400 ${CLOD_CTEST} --test-dir ${CMAKE_BINARY_DIR}/asan)
clod_add_check(sanitize/tsan 3600 ${CLOD_CTEST} --test-dir ${CMAKE_BINARY_DIR}/tsan
  -L "^threaded$")
set_tests_properties(build/asan PROPERTIES FIXTURES_SETUP asan_tree)
set_tests_properties(build/tsan PROPERTIES FIXTURES_SETUP tsan_tree)
set_tests_properties(lint/tidy sanitize/asan PROPERTIES FIXTURES_REQUIRED asan_tree)
set_tests_properties(sanitize/tsan PROPERTIES FIXTURES_REQUIRED tsan_tree)
set_tests_properties(build/asan build/tsan lint/tidy sanitize/asan sanitize/tsan lint/cppcheck
  PROPERTIES PROCESSORS 2)

# Every sign and factor of the laws broken in turn (300 s of the processor, on two cores), when a law or
# a test of laws has changed since tests/law/mutants.txt was recorded.
clod_add_check(mutation/law 3600 tools/mutate-law $<TARGET_FILE:clod_core> --as-recorded)
set_tests_properties(mutation/law PROPERTIES PROCESSORS 2)

# What the clock cannot show on a busy machine: instructions per grain and step, against the record.
clod_add_check(bench/instructions 1200 bench/count-instructions ${CMAKE_BINARY_DIR}/bench/bench_step)
set_tests_properties(bench/instructions PROPERTIES SKIP_RETURN_CODE 77)

# That the program which measures measures the step (tests/bench has the tests of its table).
clod_add_check(bench/step 600 bench/check-step ${CMAKE_BINARY_DIR}/bench/bench_step)

# Memory of 300 000 grains (2 s of the processor): arrays that grow fail no other test.
clod_add_check(bench/memory 600 bench/check-memory ${CMAKE_BINARY_DIR}/bench/bench_step)

clod_add_check(package/deb 1200 tools/check-package ${CMAKE_BINARY_DIR})

# Installed into a folder of its own: what the libraries export, examples built by pkg-config and CMake.
clod_add_check(package/library 1200 tools/check-library ${CMAKE_BINARY_DIR})
