# Test programs, picked up by their names.
#
# tests/FOLDER/test_NAME.c  is a cmocka program of its own, labelled FOLDER; a name that ends in
#                           _slow is labelled slow as well, which `make test` leaves out, those of
#                           ranks mpi, and those that the tree with ThreadSanitizer runs threaded.
# tests/FOLDER/test_NAME.py runs the program as a user does, labelled FOLDER; _slow as above.
# tests/FOLDER/fuzz_NAME.c  is a libFuzzer target, labelled fuzz; built in the asan tree, started
#                           from the files in tests/FOLDER/seeds and from cases/.
# tests/support/preload/NAME.c is a library NAME.so that a test of tests/faults preloads to make calls
#                           fail; it lies beside the program (folder of CLOD_BINARY).
pkg_check_modules(CMOCKA REQUIRED IMPORTED_TARGET cmocka)

set(CLOD_TEST_SECONDS 1200) # only ends what hangs, on a busy machine too
# A fresh tree has the same seed each time, so that longer is not more inputs from day to day; docs/meshes.md has
# runs of hours.
set(CLOD_FUZZ_SECONDS 6)
set(CLOD_FUZZ_SECONDS_fuzz_mesh 20) # it has a library of others behind it, and three formats
set(CLOD_TEST_ENVIRONMENT CLOD_BINARY=${CMAKE_BINARY_DIR}/clod)
if(MPI_FOUND)
  list(APPEND CLOD_TEST_ENVIRONMENT CLOD_MPI=1)
endif()
if(CLOD_SANITIZE)
  set(CLOD_TEST_SECONDS 2400)
  list(APPEND CLOD_TEST_ENVIRONMENT CLOD_SANITIZED=1)
  set(NO_MEMORY allocator_may_return_null=1) # a test asks for more than there is
  # LeakSanitizer 14 takes some blocks of thread-local storage for those of glibc 2.19, and then
  # crashes on its way out (google/sanitizers#1322); without this it does not look there.
  # It finds no fewer leaks: what only such a block points to would be one too many.
  list(APPEND CLOD_TEST_ENVIRONMENT ASAN_OPTIONS=intercept_tls_get_addr=0:${NO_MEMORY}
    LSAN_OPTIONS=suppressions=${CMAKE_CURRENT_SOURCE_DIR}/tests/support/leaks.txt:print_suppressions=0)
  find_program(SYMBOLIZER NAMES llvm-symbolizer-14 llvm-symbolizer)
  find_library(ARCHER NAMES archer PATHS /usr/lib/llvm-14/lib)
  list(APPEND CLOD_TEST_ENVIRONMENT ASAN_SYMBOLIZER_PATH=${SYMBOLIZER}
    UBSAN_OPTIONS=print_stacktrace=1 OMP_TOOL_LIBRARIES=${ARCHER}
    TSAN_OPTIONS=external_symbolizer_path=${SYMBOLIZER}:ignore_noninstrumented_modules=1:${NO_MEMORY})
endif()

function(clod_add_program name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE clod_verify clod_report ${CLOD_CALIBRATE_TARGET})
  target_include_directories(${name} PRIVATE tests)
  target_compile_definitions(${name} PRIVATE CLOD_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  # a test takes longer to compile than to run; the library in it is optimised as users have it
  target_compile_options(${name} PRIVATE $<$<CONFIG:Debug>:-O0> $<$<CONFIG:Release>:-O1>)
  # what a debugger reads of the library is seven eighths of a program, and half of the time of its link; the preset debug has it
  target_link_options(${name} PRIVATE $<$<CONFIG:Release>:-Wl,--strip-debug>)
  if(CLOD_LLD)
    target_link_options(${name} PRIVATE -fuse-ld=lld)
  endif()
endfunction()

# All that the tests with the label threaded need: folders and programs in which several threads work,
# among them ranks as threads of one process.
add_custom_target(threaded DEPENDS clod)
set(CLOD_THREADED "^(parallel|step)$|^test_(deal|deal_again|deal_random|run_ranks|sim_ranks|sim_ranks_mistakes)$")

file(GLOB CLOD_TEST_SOURCES CONFIGURE_DEPENDS tests/*/test_*.c)
if(NOT TARGET clod_calibrate)
  list(FILTER CLOD_TEST_SOURCES EXCLUDE REGEX "tests/calibrate/")
endif()
if(CLOD_SANITIZE)
  # Shares of hundreds of repeats: numbers that do not depend on the build. The code is run by
  # calibrate/test_posterior.c, and by calibrate/test_calibrate.py, a study to its end.
  list(FILTER CLOD_TEST_SOURCES EXCLUDE REGEX
    "calibrate/test_coverage(_growing|_specimens|_specimens_slow|_four_slow|)\\.c$")
endif()
# The name, the folder and most labels of a test from its file.
macro(clod_name_test)
  cmake_path(GET source STEM name)
  cmake_path(GET source PARENT_PATH folder)
  cmake_path(GET folder FILENAME folder)
  set(labels ${folder})
  if(name MATCHES "_slow$")
    list(APPEND labels slow)
  endif()
  if(name MATCHES "(_ranks|ranks_.*|rank_messages|_partition|_balance|mpirun.*)$")
    list(APPEND labels mpi)
  endif()
endmacro()

foreach(source IN LISTS CLOD_TEST_SOURCES)
  clod_name_test()
  clod_add_program(${name} ${source})
  target_link_libraries(${name} PRIVATE PkgConfig::CMOCKA)
  # One thread has no races: a test that names neither ranks nor threads, but for `threads = 1`, is not threaded.
  file(STRINGS ${source} several REGEX "thread|rank|omp_|step_options\\){")
  list(FILTER several EXCLUDE REGEX "threads = 1[^0-9]")
  if(several AND (folder MATCHES "${CLOD_THREADED}" OR name MATCHES "${CLOD_THREADED}"))
    list(APPEND labels threaded)
    add_dependencies(threaded ${name})
  endif()
  add_test(NAME ${folder}/${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${folder}/${name} PROPERTIES LABELS "${labels}"
    TIMEOUT ${CLOD_TEST_SECONDS} ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}")
endforeach()

# It tests what only the program has.
target_sources(test_duration PRIVATE app/duration.c)
target_include_directories(test_duration PRIVATE app)

# They let calls for memory fail, or look at them.
foreach(name test_sim_memory test_ranks_memory test_ranks_slabs test_ranks_write test_deal test_deal_random)
  target_link_options(${name} PRIVATE -Wl,--wrap=aligned_alloc)
endforeach()
target_link_options(test_ranks_memory PRIVATE -Wl,--wrap=clod_spread_cut)
foreach(name open write_at sync)
  target_link_options(test_ranks_write PRIVATE -Wl,--wrap=clod_file_${name})
endforeach()
foreach(name test_deal test_deal_random)
  target_link_options(${name} PRIVATE -Wl,--wrap=free)
endforeach()

# examples/NAME.c: each says on its last line what it found beside what should be, and fails when
# they differ. tools/check-library builds them as users do.
file(GLOB CLOD_EXAMPLES CONFIGURE_DEPENDS examples/*.c)
foreach(source IN LISTS CLOD_EXAMPLES)
  cmake_path(GET source STEM name)
  clod_add_program(example_${name} ${source})
  add_test(NAME examples/${name} COMMAND example_${name})
  set_tests_properties(examples/${name} PROPERTIES LABELS examples TIMEOUT ${CLOD_TEST_SECONDS}
    ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}")
endforeach()

# tests/support/vocabulary.c once per instruction set, with the flags of the kernels.
foreach(set IN LISTS CLOD_SETS)
  string(TOUPPER ${set} SET_UPPER)
  add_library(clod_vocabulary_${set} OBJECT tests/support/vocabulary.c)
  target_compile_options(clod_vocabulary_${set} PRIVATE ${CLOD_SCALAR} ${CLOD_${SET_UPPER}})
  target_compile_definitions(clod_vocabulary_${set} PRIVATE CLOD_SIMD_${SET_UPPER}=1
    CLOD_SIMD_SUFFIX=${set})
  target_link_libraries(clod_vocabulary_${set} PRIVATE clod_flags)
  target_sources(test_simd PRIVATE $<TARGET_OBJECTS:clod_vocabulary_${set}>)
endforeach()

# Preloaded into the program, so without the sanitizers, which would have to come first.
file(GLOB CLOD_FAULT_SOURCES CONFIGURE_DEPENDS tests/support/preload/*.c)
foreach(source IN LISTS CLOD_FAULT_SOURCES)
  cmake_path(GET source STEM name)
  add_library(${name} MODULE ${source})
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wshadow $<$<BOOL:${CLOD_WERROR}>:-Werror>)
  target_link_libraries(${name} PRIVATE ${CMAKE_DL_LIBS})
endforeach()

find_package(Python3 REQUIRED COMPONENTS Interpreter)
file(GLOB CLOD_TEST_SCRIPTS CONFIGURE_DEPENDS tests/*/test_*.py)
if(NOT TARGET clod_calibrate)
  list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "tests/calibrate/")
endif()
if(CLOD_SANITIZE)
  # What these look at (numbers, progress lines) does not depend on the build, and takes long.
  list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "cli/test_(ring_shear|jenike|uniaxial|wall_friction|fields_testers|grids_testers|terminal)\\.py$")
  # Outlets over ranges of margins and walls, and wall friction on a ridged plate: tests/hopper has tests of the same functions,
  # tests/setup/test_ridged_plate.c of the plate.
  list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "(hopper/test_(margin|outlet)|cli/test_wall_roughness)\\.py$")
  # What a browser draws does not depend on the build; all pages are written in the other tests of reports too.
  list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "report/test_(browser|print|view)\\.py$")
  # Simulations of a minute, and clod started a hundred times; tests/calibrate/test_plan.c has the texts of wrong plans,
  # test_number_path.c the names of numbers.
  list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "calibrate/test_calibrate_(plan|runs|paths)\\.py$")
  # Faults are injected by a preloaded library, which the sanitizers do not go with.
  list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "faults/test_")
endif()
# The Python package and what reads snapshots need packages of Debian's own Python, and the shared
# library, which a tree with sanitizers does not have.
list(FILTER CLOD_TEST_SCRIPTS EXCLUDE REGEX "tests/python/")
if(TARGET clod_shared)
  foreach(name IN ITEMS test_python test_null test_rising test_surface_names test_ranks test_mpi4py
                          test_chute_study test_copper_ore_study test_outlet_study test_slices
                          test_part_measures test_inside_density test_wall_contacts)
    add_test(NAME python/${name}
      COMMAND /usr/bin/python3 -B ${CMAKE_SOURCE_DIR}/tests/python/${name}.py)
    set_tests_properties(python/${name} PROPERTIES LABELS python TIMEOUT ${CLOD_TEST_SECONDS}
      ENVIRONMENT "${CLOD_TEST_ENVIRONMENT};CLOD_PYTHON=${CMAKE_BINARY_DIR}/python;CLOD_LIBRARY=$<TARGET_FILE:clod_shared>")
  endforeach()
  set_tests_properties(python/test_ranks python/test_mpi4py PROPERTIES LABELS "python;mpi" PROCESSORS 2)
  set_tests_properties(python/test_mpi4py PROPERTIES SKIP_RETURN_CODE 77)
  file(GLOB CLOD_PYTHON_EXAMPLES CONFIGURE_DEPENDS examples/*.py)
  foreach(script IN LISTS CLOD_PYTHON_EXAMPLES)
    cmake_path(GET script STEM name)
    add_test(NAME examples/python_${name} COMMAND /usr/bin/python3 -B ${script})
    set_tests_properties(examples/python_${name} PROPERTIES LABELS examples
      TIMEOUT ${CLOD_TEST_SECONDS} ENVIRONMENT
      "PYTHONPATH=${CMAKE_BINARY_DIR}/python;CLOD_LIBRARY=$<TARGET_FILE:clod_shared>")
  endforeach()
endif()

foreach(source IN LISTS CLOD_TEST_SCRIPTS)
  clod_name_test()
  if(folder MATCHES "${CLOD_THREADED}")
    list(APPEND labels threaded)
  endif()
  add_test(NAME ${folder}/${name} COMMAND ${Python3_EXECUTABLE} -B ${source})
  set_tests_properties(${folder}/${name} PROPERTIES LABELS "${labels}"
    TIMEOUT ${CLOD_TEST_SECONDS} ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}")
endforeach()

# The program with messages cut into small pieces, as those beyond 1 GiB are.
if(MPI_FOUND AND NOT CLOD_SANITIZE)
  add_executable(clod_pieces ${CLOD_APP} src/parallel/ranks_mpi.c)
  target_include_directories(clod_pieces PRIVATE ${CLOD_GENERATED})
  target_link_libraries(clod_pieces PRIVATE clod_verify clod_report ${CLOD_CALIBRATE_TARGET})
  target_compile_definitions(clod_pieces PRIVATE CLOD_MPI_PIECE=1021)
  set_property(TEST parallel/test_mpirun_pieces APPEND PROPERTY ENVIRONMENT
    CLOD_PIECES=$<TARGET_FILE:clod_pieces>)
endif()

if(NOT CLOD_SANITIZE)
  set_tests_properties(report/test_browser report/test_view PROPERTIES SKIP_REGULAR_EXPRESSION "OK \\(skipped=")
  set_tests_properties(report/test_browser cli/test_grids_testers faults/test_io_faults faults/test_alloc_faults PROPERTIES COST 100)
endif()
# Long ones begin early, so that they end beside others.
set_tests_properties(hopper/test_wall_decides restart/test_restart step/test_ranks_clumps PROPERTIES COST 100)
if(TARGET clod_calibrate)
  set_tests_properties(calibrate/test_lab_to_outlet PROPERTIES COST 100)
endif()

# MPI's ranks look for messages without a rest: beside another test they take three to five times as long.
# With sanitizers they are left out.
if(NOT CLOD_SANITIZE)
  set_tests_properties(parallel/test_mpirun parallel/test_mpirun_limits parallel/test_mpirun_library
    parallel/test_mpirun_groups parallel/test_mpirun_from parallel/test_mpirun_pieces
    parallel/test_mpirun_shapes_slow parallel/test_mpirun_disk faults/test_mpirun_faults PROPERTIES PROCESSORS 2)
endif()

# The verification suite as users run it; it fails when any quantity misses its tolerance. With sanitizers
# without passivity, which takes three quarters of the time and runs what the others run.
if(CLOD_SANITIZE)
  foreach(number RANGE 1 8)
    list(APPEND CLOD_SUITE chung-ooi-${number})
  endforeach()
  list(APPEND CLOD_SUITE mepa-cycle mepa-restitution hooke-restitution rolling chute luding-cycle
    luding-collision eepa-cycle)
endif()
add_test(NAME verify/suite COMMAND clod verify -o ${CMAKE_BINARY_DIR}/verify ${CLOD_SUITE})
set_tests_properties(verify/suite PROPERTIES LABELS verify TIMEOUT ${CLOD_TEST_SECONDS}
  COST 100
  ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}")

# Whole beds of grains, minutes each; not in `make test`.
add_test(NAME verify/slow COMMAND clod verify --slow -o ${CMAKE_BINARY_DIR}/validate)
set_tests_properties(verify/slow PROPERTIES LABELS "verify;slow" TIMEOUT 36000
  ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}")

# The same grains in LIGGGHTS and LAMMPS (tools/cross-check); skipped where they are not installed.
if(NOT CLOD_SANITIZE)
  foreach(part IN ITEMS forces bed)
    add_test(NAME cross/${part} COMMAND ${CMAKE_SOURCE_DIR}/tools/cross-check
      -o ${CMAKE_BINARY_DIR}/cross-${part} ${part})
    set_tests_properties(cross/${part} PROPERTIES LABELS cross SKIP_RETURN_CODE 77
      ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}" TIMEOUT ${CLOD_TEST_SECONDS})
  endforeach()
  set_tests_properties(cross/bed PROPERTIES LABELS "cross;slow" TIMEOUT 7200)
endif()

if(NOT CLOD_FUZZ)
  return()
endif()
# libFuzzer needs its counters in what reads; what steps is that of all tests. A library of their own:
# with counters the sanitized tests would take 1.6 times as long.
set(CLOD_READERS ${CLOD_SOURCES})
list(FILTER CLOD_READERS INCLUDE REGEX "src/((analysis|base|config|mesh|output|setup)/|sim/check)")
list(FILTER CLOD_READERS EXCLUDE REGEX # tables, and what only writes
  "src/(config/(params_|manual|explain|schema)|output/(eventlog|folder|paraview|series|snapshot|voxels|vtk_cells|wall_mesh)|mesh/mesh_(json|report)|sim/check_(cost|ranks|rate))")
add_library(clod_readers OBJECT ${CLOD_READERS})
add_dependencies(clod_readers clod_build_header)
target_compile_options(clod_readers PRIVATE -fsanitize=fuzzer-no-link)
target_link_libraries(clod_readers PRIVATE $<TARGET_PROPERTY:clod_core,INTERFACE_LINK_LIBRARIES>)
file(GLOB CLOD_FUZZ_SOURCES CONFIGURE_DEPENDS tests/*/fuzz_*.c)
foreach(source IN LISTS CLOD_FUZZ_SOURCES)
  cmake_path(GET source STEM name)
  cmake_path(GET source PARENT_PATH folder)
  set(seeds ${CMAKE_SOURCE_DIR}/cases)
  if(IS_DIRECTORY ${folder}/seeds)
    list(PREPEND seeds ${folder}/seeds)
  endif()
  add_executable(${name} ${source} $<TARGET_OBJECTS:clod_readers>)
  target_link_libraries(${name} PRIVATE clod_core)
  target_compile_options(${name} PRIVATE -fsanitize=fuzzer-no-link)
  target_include_directories(${name} PRIVATE tests)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  set(seconds ${CLOD_FUZZ_SECONDS})
  if(DEFINED CLOD_FUZZ_SECONDS_${name})
    set(seconds ${CLOD_FUZZ_SECONDS_${name}})
  endif()
  set(work ${CMAKE_BINARY_DIR}/fuzz/${name})
  file(MAKE_DIRECTORY ${work})
  add_test(NAME fuzz/${name} WORKING_DIRECTORY ${work} COMMAND ${name} -seed=1 -timeout=30
    -rss_limit_mb=2048 -max_len=65536 -max_total_time=${seconds} ${work} ${seeds})
  set_tests_properties(fuzz/${name} PROPERTIES LABELS fuzz TIMEOUT ${CLOD_TEST_SECONDS}
    COST ${seconds} # the longest first, so that none runs alone at the end
    ENVIRONMENT "${CLOD_TEST_ENVIRONMENT}")
endforeach()
