#include "device/usb/libusb/UsbLink.h"

#include <pthread.h>

#include <utility>

#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::usb {

namespace {

constexpr int kPriority = 81;                    // just above the servo, which waits for no one
constexpr std::chrono::milliseconds kLook{500};  // between attempts to open a device that is there

}  // namespace

UsbLink::UsbLink(UsbKind kind, std::string which, UsbClient& client)
    : kind_(std::move(kind)), which_(std::move(which)), client_(client), events_(context_) {}

UsbLink::~UsbLink() {
  close();
}

void UsbLink::open() {
  if (thread_.joinable()) return;
  hotPlug_ = std::make_unique<UsbHotPlug>(context_);
  try {
    connect();
    listen();
    running_ = true;
    thread_ = std::thread([this] { run(); });
  } catch (...) {
    if (stream_) drain();
    handle_.reset();
    hotPlug_.reset();
    throw;
  }
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &parameters);  // as the servo: where it is permitted
  pthread_setname_np(thread_.native_handle(), "haptiv-usb");                // for `top -H`
}

void UsbLink::close() {
  if (!thread_.joinable()) return;
  running_ = false;
  events_.wake();
  thread_.join();
  hotPlug_.reset();
}

/// Opens the device and makes it ready; what is open at the end of a failure, the caller closes.
void UsbLink::connect() {
  const FoundUsb found = findOne(context_, kind_, which_);
  hotPlug_->left = false;
  hotPlug_->mine = found.device.get();
  handle_ = std::make_unique<UsbHandle>(found, kind_);
  endpoints_ = client_.prepare(*handle_);
  const std::lock_guard lock(mutex_);
  openedSerial_ = found.serial;
  if (which_.empty()) which_ = found.serial;
  trouble_.clear();
}

void UsbLink::run() {
  while (running_) {
    step();
    events_.wait(patience(), stream_ && stream_->rests() ? Hearing::notTransfers : Hearing::everything);
  }
  if (stream_) drain();
  handle_.reset();
  hotPlug_->mine = nullptr;
}

void UsbLink::step() {
  if (!stream_) {
    reconnect();
  } else if (stream_->lost() || hotPlug_->left) {
    leave();
  } else {
    if (events_.rang()) stream_->endRest();
    stream_->recover();
    if (stream_->send() && stream_->rest().count() > 0) events_.setAlarm(stream_->rest());
  }
  doWork();
}

/// How long there is nothing to do, if nothing happens.
std::chrono::milliseconds UsbLink::patience() const {
  if (!stream_) return kLook;
  return std::chrono::milliseconds(stream_->lost() || hotPlug_->left ? 0 : -1);
}

void UsbLink::listen() {
  try {
    stream_ = std::make_unique<UsbStream>(*handle_, endpoints_, client_);
  } catch (...) {
    client_.lost();  // it has been prepared
    throw;
  }
  stream_->start();
}

/// Cancels and handles events until every transfer is back: only then may they be freed.
void UsbLink::drain() {
  stream_->cancel();
  while (!stream_->idle()) events_.waitForTransfers();
  stream_.reset();
}

void UsbLink::leave() {
  client_.lost();
  drain();
  const std::string name = handle_->name();
  handle_.reset();
  hotPlug_->mine = nullptr;
  tell(name + " is not there any more: plug it in again");
  tryAgain_ = std::chrono::steady_clock::now() + kLook;  // it may only have failed
}

void UsbLink::reconnect() {
  if (!std::exchange(hotPlug_->arrived, false) && std::chrono::steady_clock::now() < tryAgain_) return;
  tryAgain_ = kNever;
  try {
    connect();
    listen();
  } catch (const UsbFailure& failure) {
    failed(failure.what(), failure.trouble() != UsbTrouble::notFound && failure.trouble() != UsbTrouble::wrongDevice);
  } catch (const std::exception& error) {  // of the client, or for want of memory
    failed("cannot use the " + kind_.name + " that was plugged in: " + error.what(), true);
  } catch (...) {
    failed("cannot use the " + kind_.name + " that was plugged in: switch it off and on", true);
  }
}

/// As before it was plugged in. `mayYetBe`: another attempt makes sense, though nothing is plugged in anew.
void UsbLink::failed(const std::string& trouble, bool mayYetBe) {
  handle_.reset();
  hotPlug_->mine = nullptr;
  if (mayYetBe) tryAgain_ = std::chrono::steady_clock::now() + kLook;
  tell(trouble);
}

void UsbLink::betweenStreams(std::function<void(UsbHandle&)> work) {
  std::future<void> done;
  {
    const std::lock_guard lock(mutex_);
    if (!thread_.joinable()) throw UsbFailure(UsbTrouble::gone, "the " + kind_.name + " is not open: open it first");
    work_ = Work([name = kind_.name, work = std::move(work)](UsbHandle* handle) {
      if (handle == nullptr)
        throw UsbFailure(UsbTrouble::gone, "the " + name + " is not there: plug it in and try again");
      work(*handle);
    });
    done = work_.get_future();
  }
  events_.wake();
  done.get();
}

void UsbLink::doWork() {
  Work work;
  {
    const std::lock_guard lock(mutex_);
    work.swap(work_);
  }
  if (!work.valid()) return;
  if (stream_) drain();
  work(handle_.get());
  if (!handle_) return;
  try {
    listen();
  } catch (const std::exception& error) {
    failed("cannot go on with the " + kind_.name + ": " + error.what(), true);
  }
}

void UsbLink::tell(const std::string& trouble) {
  const std::lock_guard lock(mutex_);
  trouble_ = trouble;
}

std::string UsbLink::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

std::string UsbLink::serial() const {
  const std::lock_guard lock(mutex_);
  return openedSerial_;
}

}  // namespace haptiv::usb
