# find_package(wend): the target wend::abi and the function wend_add_plugin().
if(NOT TARGET wend::abi)
  add_library(wend::abi INTERFACE IMPORTED)
  get_filename_component(WEND_PREFIX "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
  set_target_properties(wend::abi PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${WEND_PREFIX}/include")
endif()
include("${CMAKE_CURRENT_LIST_DIR}/WendPlugin.cmake")
