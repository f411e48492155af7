#include "apps/stop_signals.hpp"

#include <pthread.h>

#include <csignal>

namespace underway {
namespace {

sigset_t stopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

StopSignals::StopSignals() {
  const sigset_t signals = stopSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  waiter_ = std::thread([this] {
    const sigset_t awaited = stopSignals();
    int signal = 0;
    sigwait(&awaited, &signal);
    stop_.request_stop();
  });
}

StopSignals::~StopSignals() {
  pthread_kill(waiter_.native_handle(), SIGTERM);  // for the waiter alone; it may still be waiting
  waiter_.join();
}

}  // namespace underway
