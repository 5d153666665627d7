# Python packages of what ./dev has built already, for whatever system.
set(MIMO_PREBUILT "" CACHE PATH "Folder of the native files that go into the package")
set(MIMO_LICENCES "" CACHE PATH "Folder of the licences of all that is inside them")

# mimo_prebuilt(<folder>): where in the package they go.
function(mimo_prebuilt folder)
  add_custom_target(native)
  install(DIRECTORY ${MIMO_PREBUILT}/ DESTINATION ${folder} USE_SOURCE_PERMISSIONS)
  install(DIRECTORY ${MIMO_LICENCES}/ DESTINATION ${SKBUILD_METADATA_DIR}/licenses)
endfunction()
