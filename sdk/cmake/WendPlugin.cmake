# wend_add_plugin(<name> MANIFEST <file.json> SOURCES <file>... [LIBRARIES <target>...])
#
# A plugin: a shared object whose only symbol is wend_plugin_1 and whose manifest lies in the section .wend.manifest.
# After linking, the section is checked to be there.

function(wend_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MANIFEST" "SOURCES;LIBRARIES")
  if(NOT arg_MANIFEST OR NOT arg_SOURCES)
    message(FATAL_ERROR "wend_add_plugin(${name}): expected MANIFEST <file.json> and SOURCES <file>...")
  endif()
  get_filename_component(manifest "${arg_MANIFEST}" ABSOLUTE)
  file(READ "${manifest}" json)
  string(JSON ignored ERROR_VARIABLE error GET "${json}" components)
  if(error)
    message(FATAL_ERROR "${manifest}: ${error}")
  endif()
  enable_language(CXX)  # the section comes from a C++ source, which a project in C alone would drop in silence

  set(section "${CMAKE_CURRENT_BINARY_DIR}/${name}.manifest.cpp")
  file(CONFIGURE OUTPUT "${section}" @ONLY CONTENT [[
asm(".section .wend.manifest,\"a\",@progbits\n.incbin \"@manifest@\"\n.previous\n");
]])
  set_source_files_properties("${section}" PROPERTIES OBJECT_DEPENDS "${manifest}")

  add_library(${name} MODULE ${arg_SOURCES} "${section}")
  target_link_libraries(${name} PRIVATE wend::abi ${arg_LIBRARIES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_options(${name} PRIVATE -ffp-contract=off -fno-math-errno -fno-trapping-math -ffunction-sections -fdata-sections)
  set_target_properties(${name} PROPERTIES PREFIX "" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  if(WEND_PLUGIN_DIRECTORY)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${WEND_PLUGIN_DIRECTORY})
    install(TARGETS ${name} DESTINATION lib/wend/plugins)
    set_property(GLOBAL APPEND PROPERTY WEND_PLUGINS ${name})
  endif()
  # The linker may not drop the manifest, which nothing refers to; everything but the one symbol stays local, or two
  # plugins would share their inline statics.
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${name}.map" "{ global: wend_plugin_1; local: *; };\n")
  target_link_options(${name} PRIVATE -Wl,--version-script,${CMAKE_CURRENT_BINARY_DIR}/${name}.map)
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_link_options(${name} PRIVATE -Wl,-z,defs)
  endif()
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DOBJDUMP=${CMAKE_OBJDUMP} -DFILE=$<TARGET_FILE:${name}> -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/check_manifest.cmake
    VERBATIM)
endfunction()
