# HDF5, as a part of what is linked with it: a module of WebAssembly loads no libraries.
file(GLOB hdf5_files RELATIVE ${MIMO_DEPENDENCIES}/hdf5/src ${MIMO_DEPENDENCIES}/hdf5/src/H5*.c)
set(hdf5_settings ${PROJECT_BINARY_DIR}/hdf5/H5build_settings.c)
configure_file(${MIMO_DEPENDENCIES}/hdf5/src/H5build_settings.off.c.in ${hdf5_settings} COPYONLY)

mimo_foreign_library(hdf5::hdf5 hdf5/src ${hdf5_files})
target_sources(hdf5_hdf5 PRIVATE ${hdf5_settings})
set_target_properties(hdf5_hdf5 PROPERTIES C_STANDARD 11 C_EXTENSIONS ON)
target_include_directories(hdf5_hdf5 SYSTEM PRIVATE ${PROJECT_SOURCE_DIR}/cmake/hdf5 ${MIMO_DEPENDENCIES}/hdf5/src/H5FDsubfiling)
target_compile_options(hdf5_hdf5 PRIVATE -O2)
target_link_libraries(hdf5_hdf5 PRIVATE ZLIB::ZLIB)
