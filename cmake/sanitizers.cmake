# -DUNDERWAY_SANITIZE=address,undefined or thread; they exclude each other.
set(UNDERWAY_SANITIZE "" CACHE STRING "Sanitizers: empty, 'address,undefined' or 'thread'")
if(UNDERWAY_SANITIZE MATCHES "address" AND UNDERWAY_SANITIZE MATCHES "thread")
  message(FATAL_ERROR "UNDERWAY_SANITIZE: address and thread cannot be combined; use two build folders")
endif()
if(UNDERWAY_SANITIZE)
  add_compile_options(-fsanitize=${UNDERWAY_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${UNDERWAY_SANITIZE})
  # g++ 12 warns of uninitialised variables in its own <regex> and <functional> when it instruments them.
  add_compile_options(-Wno-maybe-uninitialized)
endif()
