// Only there so that the headers that tests share are compiled: see tests/CMakeLists.txt.
