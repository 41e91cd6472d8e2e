# Two plugins that behave, in the folder that this folder's experiments search, and those of tests/bad_plugins.
include(${CMAKE_CURRENT_SOURCE_DIR}/bad_plugins/plugins.cmake)
set(plugins ${CMAKE_CURRENT_LIST_DIR}/plugins)
wend_add_plugin(wend-test-counting MANIFEST ${plugins}/counting.json SOURCES ${plugins}/counting.cpp)
set_target_properties(wend-test-counting PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${WEND_BAD_PLUGINS})
add_dependencies(${target} wend-worker wend-test-counting wend-test-misbehave no_symbol wrong_abi unresolved static_crash static_throw fast_math)
target_compile_definitions(${target} PRIVATE WEND_TEST_PLUGINS="${WEND_BAD_PLUGINS}" WEND_TEST_WORKER="$<TARGET_FILE:wend-worker>")
