# Warnings for our own targets only; what third-party headers do is theirs.
add_library(underway_warnings INTERFACE)
target_compile_options(underway_warnings INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual>)
