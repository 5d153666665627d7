# find_package(mimo) comes here.
include(${CMAKE_CURRENT_LIST_DIR}/mimoTargets.cmake)

# The target names mingw's import library; Microsoft's linker has its own beside it.
if(MSVC)
  get_target_property(mimo_configurations mimo::mimo IMPORTED_CONFIGURATIONS)
  foreach(mimo_configuration IN LISTS mimo_configurations)
    get_target_property(mimo_import_library mimo::mimo IMPORTED_IMPLIB_${mimo_configuration})
    string(REPLACE libmimo.dll.a mimo.lib mimo_import_library "${mimo_import_library}")
    set_target_properties(mimo::mimo PROPERTIES IMPORTED_IMPLIB_${mimo_configuration} "${mimo_import_library}")
  endforeach()
endif()
