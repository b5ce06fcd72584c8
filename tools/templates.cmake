# clod_templates.h: the case files that `clod new` writes, as C strings. A changed case file makes
# CMake run again.
set(header "#pragma once\n// Written by tools/templates.cmake from cases/.\n")
foreach(entry IN ITEMS "RING_SHEAR=copper-ore-5" "JENIKE=copper-ore-jenike"
    "UNIAXIAL=copper-ore-uniaxial"
    "FREE_RUN=free-run" "CONTACT_BENCH=contact-bench")
  string(REPLACE "=" ";" entry ${entry})
  list(GET entry 0 name)
  list(GET entry 1 folder)
  set(source ${CMAKE_SOURCE_DIR}/cases/${folder}/case.yaml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\n" "\\n\" \\\n    \"" text "${text}")
  string(APPEND header "\n#define CLOD_TEMPLATE_${name} \\\n    \"${text}\"\n")
endforeach()
file(WRITE ${CLOD_GENERATED}/clod_templates.h.new "${header}")
configure_file(${CLOD_GENERATED}/clod_templates.h.new ${CLOD_GENERATED}/clod_templates.h COPYONLY)
