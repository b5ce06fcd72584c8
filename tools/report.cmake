# The scripts of the pages of `clod report`: plotly and three.js, bundled by esbuild into one file,
# which the program embeds. They come from npm; what is pinned stands in package-lock.json.
# Without npm or a network clod is built without them: its pages have figures that do not zoom and
# no 3-D view, and the program says so. Sets CLOD_REPORT_EMBEDDED, the definitions of what
# src/report/scripts.c embeds, and CLOD_REPORT_FILES, what it depends on.
option(CLOD_REPORT_SCRIPTS "Take the scripts of the report pages from npm" ON)
set(CLOD_REPORT_WEB ${CMAKE_SOURCE_DIR}/src/report/web)
set(CLOD_REPORT_WORK ${CMAKE_BINARY_DIR}/report)
file(GLOB CLOD_REPORT_SOURCES CONFIGURE_DEPENDS ${CLOD_REPORT_WEB}/*.js)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CLOD_REPORT_WEB}/package-lock.json)

# Install what the lock file names, once for each state of it. Sets CLOD_REPORT_MODULES.
function(clod_report_install)
  set(CLOD_REPORT_MODULES OFF PARENT_SCOPE)
  find_program(NPM npm)
  find_program(NODE NAMES node nodejs)
  if(NOT NPM OR NOT NODE)
    message(STATUS "Report pages without scripts: they need nodejs and npm (make setup-report)")
    return()
  endif()
  file(SHA256 ${CLOD_REPORT_WEB}/package-lock.json lock)
  if(NOT EXISTS ${CLOD_REPORT_WORK}/installed-${lock})
    file(REMOVE_RECURSE ${CLOD_REPORT_WORK})
    file(MAKE_DIRECTORY ${CLOD_REPORT_WORK})
    file(COPY ${CLOD_REPORT_WEB}/package.json ${CLOD_REPORT_WEB}/package-lock.json
      DESTINATION ${CLOD_REPORT_WORK})
    execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline
        --fetch-retries=1 --fetch-retry-mintimeout=1000 --fetch-timeout=30000
      WORKING_DIRECTORY ${CLOD_REPORT_WORK} TIMEOUT 300
      RESULT_VARIABLE result OUTPUT_FILE ${CLOD_REPORT_WORK}/npm.log
      ERROR_FILE ${CLOD_REPORT_WORK}/npm.log)
    if(NOT result STREQUAL "0")
      message(STATUS "Report pages without scripts: npm could not get them (${CLOD_REPORT_WORK}/npm.log)")
      return()
    endif()
    file(TOUCH ${CLOD_REPORT_WORK}/installed-${lock})
  endif()
  set(CLOD_REPORT_MODULES ON PARENT_SCOPE)
endfunction()

if(CLOD_REPORT_SCRIPTS)
  clod_report_install()
  if(CLOD_REPORT_MODULES)
    set(CLOD_REPORT_BUNDLE ${CLOD_REPORT_WORK}/bundle.js)
    set(CLOD_REPORT_LICENCES ${CLOD_REPORT_WORK}/licences.txt)
    # NODE_PATH: the sources lie outside of the folder with the modules
    add_custom_command(OUTPUT ${CLOD_REPORT_BUNDLE}
      COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${CLOD_REPORT_WORK}/node_modules
        ${NODE} ${CLOD_REPORT_WORK}/node_modules/esbuild/bin/esbuild ${CLOD_REPORT_WEB}/main.js
        --bundle --minify --charset=utf8 --legal-comments=none --log-level=warning
        --outfile=${CLOD_REPORT_BUNDLE}
      DEPENDS ${CLOD_REPORT_SOURCES} ${CLOD_REPORT_WORK}/package-lock.json
      COMMENT "Bundling the scripts of the report pages" VERBATIM)
    file(WRITE ${CLOD_REPORT_LICENCES} "")
    foreach(package IN ITEMS plotly.js-cartesian-dist-min three)
      file(READ ${CLOD_REPORT_WORK}/node_modules/${package}/LICENSE text)
      file(APPEND ${CLOD_REPORT_LICENCES} "${package}\n\n${text}\n")
    endforeach()
  endif()
endif()

set(CLOD_REPORT_EMBEDDED "CLOD_REPORT_STYLE=\"${CLOD_REPORT_WEB}/style.css\"")
set(CLOD_REPORT_FILES ${CLOD_REPORT_WEB}/style.css)
if(CLOD_REPORT_BUNDLE)
  list(APPEND CLOD_REPORT_EMBEDDED "CLOD_REPORT_BUNDLE=\"${CLOD_REPORT_BUNDLE}\""
    "CLOD_REPORT_LICENCES=\"${CLOD_REPORT_LICENCES}\"")
  list(APPEND CLOD_REPORT_FILES ${CLOD_REPORT_BUNDLE} ${CLOD_REPORT_LICENCES})
endif()
