# bench/bench_NAME.c is a program that measures; the other sources of bench are shared by them.
# Built by `ninja bench` (make bench), and with the checks, which count the instructions of a step.
file(GLOB CLOD_BENCHES CONFIGURE_DEPENDS bench/bench_*.c)
if(NOT CLOD_CALIBRATE_TARGET)
  list(FILTER CLOD_BENCHES EXCLUDE REGEX bench_fit)
endif()
add_library(clod_bench STATIC EXCLUDE_FROM_ALL bench/bed.c bench/rank_watch.c bench/resident.c bench/stages.c)
target_link_libraries(clod_bench PUBLIC clod_core)
add_custom_target(bench)
foreach(source IN LISTS CLOD_BENCHES)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} EXCLUDE_FROM_ALL ${source})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
  target_link_libraries(${name} PRIVATE clod_bench)
  add_dependencies(bench ${name})
  if(CLOD_CHECKS)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL OFF)
  endif()
endforeach()

target_include_directories(bench_ranks PRIVATE tests) # ranks as threads
if(TARGET bench_fit)
  target_include_directories(bench_fit PRIVATE tests) # plans without files
  target_link_libraries(bench_fit PRIVATE clod_calibrate)
endif()

# bench/machine_set.c once per instruction set, with the flags of the kernels; once more where
# the set has fused multiply-add, with leave to use it.
foreach(set IN LISTS CLOD_SETS)
  string(TOUPPER ${set} SET_UPPER)
  foreach(kind IN ITEMS "" _fused)
    if(kind AND set STREQUAL "scalar")
      continue()
    endif()
    set(name clod_machine_${set}${kind})
    add_library(${name} OBJECT EXCLUDE_FROM_ALL bench/machine_set.c)
    target_include_directories(${name} PRIVATE src)
    target_compile_options(${name} PRIVATE ${CLOD_SCALAR} ${CLOD_${SET_UPPER}})
    if(kind)
      target_compile_options(${name} PRIVATE -fno-math-errno -ffp-contract=fast)
    else()
      target_link_libraries(${name} PRIVATE clod_flags)
    endif()
    target_compile_definitions(${name} PRIVATE CLOD_SIMD_${SET_UPPER}=1
      CLOD_SIMD_SUFFIX=${set}${kind})
    target_sources(bench_machine PRIVATE $<TARGET_OBJECTS:${name}>)
  endforeach()
endforeach()
