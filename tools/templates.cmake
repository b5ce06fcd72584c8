# clod_templates.h: the case files and tables that `clod new` writes, as arrays of characters. A changed case file makes
# CMake run again.
set(header "#pragma once\n// Written by tools/templates.cmake from cases/.\n")
foreach(entry IN ITEMS "RING_SHEAR=copper-ore-5/case.yaml" "JENIKE=copper-ore-jenike/case.yaml"
    "UNIAXIAL=copper-ore-uniaxial/case.yaml" "WALL_FRICTION=wall-friction/case.yaml"
    "FREE_RUN=free-run/case.yaml"
    "CONTACT_BENCH=contact-bench/case.yaml" "HOPPER=hopper-design/hopper.yaml"
    "HOPPER_FLOW_FUNCTION=hopper-design/flow-function.csv" "HOPPER_WALL=hopper-design/wall.csv"
    "CALIBRATE=calibrate-kadh/plan.yaml" "CALIBRATE_RING=calibrate-kadh/ring.yaml"
    "LAB_TO_OUTLET=lab-to-outlet/hopper.yaml" "LAB_TO_OUTLET_SHEAR=lab-to-outlet/shear.csv"
    "LAB_TO_OUTLET_WALL=lab-to-outlet/wall.csv" "LAB_TO_OUTLET_PLAN=lab-to-outlet/plan.yaml"
    "LAB_TO_OUTLET_RING=lab-to-outlet/ring.yaml" "LAB_TO_OUTLET_OUTLET=lab-to-outlet/outlet.yaml"
    "LAB_TO_OUTLET_SIDE=lab-to-outlet/side.obj" "LAB_TO_OUTLET_CHUTE=lab-to-outlet/chute.yaml"
    "LAB_TO_OUTLET_CHUTE_MESH=lab-to-outlet/chute.obj"
    "LAB_TO_OUTLET_WALL_LINER=lab-to-outlet/wall-liner.csv" "LAB_TO_OUTLET_WALL_RUST=lab-to-outlet/wall-rust.csv"
    "LAB_TO_OUTLET_PLAN_WALL=lab-to-outlet/plan-wall.yaml" "LAB_TO_OUTLET_WALL_CASE=lab-to-outlet/wall.yaml"
    "TRANSFER_CHUTE=transfer-chute/case.yaml" "TRANSFER_CHUTE_DRY=transfer-chute/dry.yaml"
    "TRANSFER_CHUTE_LAYOUT=transfer-chute/chute.yaml" "TRANSFER_CHUTE_MESH=transfer-chute/chute.obj"
    "TRANSFER_CHUTE_GEOMETRY=transfer-chute/geometry" "TRANSFER_CHUTE_CHUTE=transfer-chute/chute.py"
    "TRANSFER_CHUTE_MESH_PY=transfer-chute/mesh.py" "TRANSFER_CHUTE_BELTS=transfer-chute/belts.py")
  string(REPLACE "=" ";" entry ${entry})
  list(GET entry 0 name)
  list(GET entry 1 file)
  set(source ${CMAKE_SOURCE_DIR}/cases/${file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} bytes HEX) # no literal: compilers need not take one of more than 4095 characters
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND header "\nstatic const char CLOD_TEMPLATE_${name}[] = {${bytes}0};\n")
endforeach()
file(WRITE ${CLOD_GENERATED}/clod_templates.h.new "${header}")
configure_file(${CLOD_GENERATED}/clod_templates.h.new ${CLOD_GENERATED}/clod_templates.h COPYONLY)
