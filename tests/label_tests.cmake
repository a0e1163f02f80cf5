# Labels of `tests`, read by CTest: those of their suites (labels_of_SUITE), of all others `unit`. A test is SUITE.NAME or
# PREFIX/SUITE.NAME/VALUE.
foreach(test IN LISTS tests)
  string(REGEX REPLACE "[.].*" "" suites "${test}")
  string(REPLACE "/" ";" suites "${suites}")
  set(labels)
  foreach(suite IN LISTS suites)
    list(APPEND labels ${labels_of_${suite}})
  endforeach()
  if(NOT labels)
    set(labels unit)
  endif()
  set_tests_properties("${test}" PROPERTIES LABELS "${labels}")
endforeach()
