# Plugins that break the rules.  They are built into a folder that no search path has.
set(WEND_BAD_PLUGINS ${PROJECT_BINARY_DIR}/test_plugins)
set(WEND_PLUGIN_DIRECTORY "")
set(here ${CMAKE_CURRENT_LIST_DIR})

function(wend_add_bad_library name source)  # not even a manifest
  add_library(${name} MODULE ${here}/${source})
  target_link_libraries(${name} PRIVATE wend::abi)
  target_compile_definitions(${name} PRIVATE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden LIBRARY_OUTPUT_DIRECTORY ${WEND_BAD_PLUGINS}/bad)
endfunction()

wend_add_plugin(wend-test-misbehave MANIFEST ${here}/misbehave.json SOURCES ${here}/misbehave.cpp)
set_target_properties(wend-test-misbehave PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${WEND_BAD_PLUGINS})
wend_add_bad_library(no_symbol no_symbol.cpp)
wend_add_bad_library(wrong_abi wrong_abi.cpp)
wend_add_bad_library(unresolved unresolved.cpp)
wend_add_bad_library(static_crash static_crash.cpp)
wend_add_bad_library(static_throw static_crash.cpp AT_LOAD_THROW)
wend_add_bad_library(fast_math fast_math.cpp)
