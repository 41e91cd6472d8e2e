include(support/program.cmake)
target_compile_definitions(${target} PRIVATE WEND_CMAKE="${CMAKE_COMMAND}")
