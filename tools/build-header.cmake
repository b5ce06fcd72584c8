# Write OUTPUT, the header with the facts of this build, when any of them has changed.
# Run by the build itself (cmake -P), so that the commit is the one that is compiled.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE FAILED)
if(FAILED)
  set(COMMIT "commit unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once
// Written by the build.
#define CLOD_BUILD_VERSION "@VERSION@"
#define CLOD_BUILD_COMMIT "@COMMIT@"
#define CLOD_BUILD_COMPILER "@COMPILER@"
#define CLOD_BUILD_FLAGS "@FLAGS@"
]])
