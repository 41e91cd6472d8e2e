# An oracle of the elementary functions; the tests that need it are compiled in where its header is.
find_library(SLEEF sleef)
if(SLEEF)
  target_link_libraries(${target} PRIVATE ${SLEEF})
endif()
