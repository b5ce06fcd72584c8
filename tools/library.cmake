# The shared library, from the objects of the static one. It exports what include/clod declares and
# nothing else (tools/export-list.cmake); tools/check-library holds that.
if(NOT CLOD_SANITIZE)
  file(GLOB CLOD_PUBLIC_HEADERS CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/include/clod/*.h)
  set(CLOD_EXPORTS ${CMAKE_BINARY_DIR}/generated/clod.map)
  add_custom_command(OUTPUT ${CLOD_EXPORTS}
    COMMAND ${CMAKE_COMMAND} "-DHEADERS=${CLOD_PUBLIC_HEADERS}" -DOUTPUT=${CLOD_EXPORTS}
      -P ${CMAKE_SOURCE_DIR}/tools/export-list.cmake
    DEPENDS ${CLOD_PUBLIC_HEADERS} ${CMAKE_SOURCE_DIR}/tools/export-list.cmake VERBATIM)
  add_custom_target(clod_exports DEPENDS ${CLOD_EXPORTS})
  add_library(clod_shared SHARED $<TARGET_OBJECTS:clod_core> ${CLOD_KERNELS})
  add_dependencies(clod_shared clod_core clod_exports)
  # before 1.0 every minor version may change the interface: the name that programs ask for has it
  set_target_properties(clod_shared PROPERTIES OUTPUT_NAME clod LINKER_LANGUAGE C
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    LINK_DEPENDS ${CLOD_EXPORTS})
  # nodelete: OpenMP's threads wait in their library after a step, so a program that closes this one,
  # as Python does at its end, must not take their code away
  target_link_options(clod_shared PRIVATE -Wl,--version-script=${CLOD_EXPORTS} -Wl,-z,nodelete)
  target_link_libraries(clod_shared PRIVATE PkgConfig::FYAML PkgConfig::HDF5 PkgConfig::JANSSON
    PkgConfig::ZLIB PkgConfig::ASSIMP ${CLOD_MPI_TARGET} ${UDUNITS} OpenMP::OpenMP_C m)

  # The Python package: its sources, and the declarations of the headers as cffi reads them, with the
  # name under which the library is found.
  set(CLOD_PYTHON ${CMAKE_BINARY_DIR}/python/clod)
  file(GLOB CLOD_PYTHON_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/python/clod/*.py)
  add_custom_command(OUTPUT ${CLOD_PYTHON}/_cdef.py
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CLOD_PYTHON}
    COMMAND ${CMAKE_COMMAND} -E copy ${CLOD_PYTHON_SOURCES} ${CLOD_PYTHON}
    COMMAND ${CMAKE_SOURCE_DIR}/tools/make-cdef ${CMAKE_C_COMPILER} ${CMAKE_SOURCE_DIR} ${CLOD_PYTHON}/_cdef.py
      $<TARGET_SONAME_FILE_NAME:clod_shared>
    DEPENDS ${CLOD_PUBLIC_HEADERS} ${CLOD_PYTHON_SOURCES} ${CMAKE_SOURCE_DIR}/tools/make-cdef VERBATIM)
  add_custom_target(clod_python ALL DEPENDS ${CLOD_PYTHON}/_cdef.py)
endif()
