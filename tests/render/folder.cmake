# These tests read pixels.
target_link_libraries(${target} PRIVATE wend_opencv)
add_dependencies(${target} wend-render)
