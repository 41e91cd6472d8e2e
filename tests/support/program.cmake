# For tests that start programs of this build: all of it is built before they run, and they get support/.
target_sources(${target} PRIVATE ${CMAKE_CURRENT_LIST_DIR}/program.cpp ${CMAKE_CURRENT_LIST_DIR}/wend.cpp)
target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_LIST_DIR}/..)
add_dependencies(${target} wend_product)
set(WEND_PLUGIN_DIRECTORY "")  # plugins of tests are neither found by default nor installed
