# What is installed, and the Debian package of it (cpack -G DEB).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME clod)
install(TARGETS clod clod_core)
if(TARGET clod_shared)
  install(TARGETS clod_shared)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/python/clod DESTINATION lib/python3/dist-packages
    COMPONENT python FILES_MATCHING PATTERN "*.py")
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-clod RENAME copyright
    COMPONENT python)
endif()
install(DIRECTORY include/clod TYPE INCLUDE FILES_MATCHING PATTERN "*.h")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
# documents lie to each other as in the source tree, for their links
install(FILES README.md CHANGELOG.md ARCHITECTURE.md CONTRIBUTING.md CITATION.cff LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY bench/results DESTINATION ${CMAKE_INSTALL_DOCDIR}/bench)
install(DIRECTORY cases examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

# pkg-config and find_package(clod): both found from where the files lie, so the tree may be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY
  ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig OUTPUT_VARIABLE CLOD_PC_UP)
set(CLOD_PC_PREFIX "\${pcfiledir}/${CLOD_PC_UP}")
set(CLOD_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/clod)
if(MPI_FOUND)
  set(CLOD_PC_MPI " mpi-c")
else()
  set(CLOD_PC_MPI "")
endif()
configure_file(tools/clod.pc.in ${CLOD_GENERATED}/clod.pc @ONLY)
configure_package_config_file(tools/clod-config.cmake.in ${CLOD_GENERATED}/clod-config.cmake
  INSTALL_DESTINATION ${CLOD_CMAKE_FOLDER} PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${CLOD_GENERATED}/clod-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CLOD_GENERATED}/clod.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${CLOD_GENERATED}/clod-config.cmake ${CLOD_GENERATED}/clod-config-version.cmake
  DESTINATION ${CLOD_CMAKE_FOLDER})

# Manual pages and completion say what the program's --help says, so it must run on this machine.
find_program(HELP2MAN help2man)
if(HELP2MAN AND TARGET clod AND NOT CMAKE_CROSSCOMPILING AND NOT CLOD_SANITIZE)
  set(CLOD_HELP ${CMAKE_BINARY_DIR}/help)
  add_custom_command(OUTPUT ${CLOD_HELP}/stamp
    COMMAND ${CMAKE_SOURCE_DIR}/tools/make-man $<TARGET_FILE:clod> ${CLOD_HELP}/man1
    COMMAND ${CMAKE_SOURCE_DIR}/tools/make-completion $<TARGET_FILE:clod> ${CLOD_HELP}/completion
    COMMAND ${CMAKE_COMMAND} -E touch ${CLOD_HELP}/stamp
    DEPENDS clod tools/make-man tools/make-completion
    COMMENT "Writing manual pages and completion" VERBATIM)
  add_custom_target(clod_help ALL DEPENDS ${CLOD_HELP}/stamp)
  install(DIRECTORY ${CLOD_HELP}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
  install(FILES ${CLOD_HELP}/completion/clod
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${CLOD_HELP}/completion/_clod
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${CLOD_HELP}/completion/clod.fish
    DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
else()
  message(STATUS "No manual pages and no completion: they need help2man and a program that runs here")
endif()

# Two packages: clod, and python3-clod, which loads the library of the same version.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL clod python)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_CONTACT "the clod developers <clod@localhost>")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_CLOD_PACKAGE_NAME clod)
set(CPACK_DEBIAN_CLOD_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CLOD_PACKAGE_SHLIBDEPS ON)
if(MPI_FOUND) # its library is a dependency that is found; mpirun is for those who want several ranks
  set(CPACK_DEBIAN_CLOD_PACKAGE_RECOMMENDS openmpi-bin)
endif()
set(CPACK_COMPONENT_CLOD_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-clod)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "clod (= ${PROJECT_VERSION}), python3, python3-cffi, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-h5py, python3-pandas")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-mpi4py")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}: simulations and results in Python")
include(CPack)
