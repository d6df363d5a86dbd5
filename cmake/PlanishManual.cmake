# Manual pages and completions, as the program itself prints them. As a script with -DPROGRAM (a list
# with the emulator that runs it, if any) and -DFOLDER it writes them; as a module it has
# planish_manual(), which makes them part of the build and of what is installed.

if(CMAKE_SCRIPT_MODE_FILE)
  function(planish_print file)
    execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE "${FOLDER}/${file}" COMMAND_ERROR_IS_FATAL ANY)
  endfunction()

  file(MAKE_DIRECTORY "${FOLDER}/man" "${FOLDER}/bash" "${FOLDER}/zsh" "${FOLDER}/fish")
  planish_print(man/planish.1 man)
  execute_process(COMMAND ${PROGRAM} describe --json OUTPUT_VARIABLE described COMMAND_ERROR_IS_FATAL ANY)
  string(JSON count LENGTH "${described}" verbs)
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON verb GET "${described}" verbs ${i} name)
    planish_print(man/planish-${verb}.1 man ${verb})
  endforeach()
  planish_print(bash/planish completion bash)
  planish_print(zsh/_planish completion zsh)
  planish_print(fish/planish.fish completion fish)
  return()
endif()

# Where the program cannot be run, as in a cross build without an emulator, there are none.
function(planish_manual program)
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    return()
  endif()
  set(folder "${PROJECT_BINARY_DIR}/generated/manual")
  set(script "${PROJECT_SOURCE_DIR}/cmake/PlanishManual.cmake")
  add_custom_command(
    OUTPUT "${folder}/made"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:${program}>"
            "-DFOLDER=${folder}" -P "${script}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${folder}/made"
    DEPENDS ${program} "${script}"
    COMMENT "Printing manual pages and completions"
    VERBATIM)
  add_custom_target(planish_manual ALL DEPENDS "${folder}/made")
  # What was not built is left out, as where one target alone was asked for.
  install(DIRECTORY "${folder}/man/" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program OPTIONAL)
  foreach(place bash-completion/completions zsh/vendor-completions fish/vendor_completions.d)
    string(REGEX MATCH "^(bash|zsh|fish)" shell ${place})
    install(DIRECTORY "${folder}/${shell}/" DESTINATION ${CMAKE_INSTALL_DATADIR}/${place}
            COMPONENT program OPTIONAL)
  endforeach()
endfunction()
