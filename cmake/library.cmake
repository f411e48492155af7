# underway_library(geometry SOURCES ... PUBLIC ... PRIVATE ...): one target a folder, underway::geometry.
# Third-party libraries in PRIVATE stay out of the public headers; their headers are system headers to us.
function(underway_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(underway_${name} STATIC ${ARG_SOURCES})
  add_library(underway::${name} ALIAS underway_${name})
  target_include_directories(underway_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(underway_${name} PRIVATE -ffp-contract=off)  # the same sums on every processor
  target_link_libraries(underway_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} underway_warnings)
endfunction()
