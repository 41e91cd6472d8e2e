# Fails where the shared object FILE has no section .wend.manifest.
execute_process(COMMAND ${OBJDUMP} -h ${FILE} OUTPUT_VARIABLE sections RESULT_VARIABLE failed)
if(failed OR NOT sections MATCHES "\\.wend\\.manifest")
  message(FATAL_ERROR "${FILE}: the section .wend.manifest is missing after linking")
endif()
