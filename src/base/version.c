#include "clod/version.h"

#include "clod_build.h" // written by the build: tools/build-header.cmake

const char *clod_version_text(void)
{
    return "clod " CLOD_BUILD_VERSION " (" CLOD_BUILD_COMMIT "), " CLOD_BUILD_COMPILER
           ", " CLOD_BUILD_FLAGS;
}
