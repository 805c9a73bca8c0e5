#include "tests/app/window/WindowFixture.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QScreen>
#include <QToolBar>
#include <algorithm>

#include "app/window/session/LogFolder.h"

namespace haptiv {

using testing::drag;
using testing::press;
using testing::release;
using testing::waitFor;

void Window::SetUp() {
  ASSERT_TRUE(home_.isValid());
  qputenv("HOME", home_.path().toUtf8());
  window_ = std::make_unique<MainWindow>();
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  QTest::qWait(300);
}

void Window::openScene(const std::string& text) {
  const QString path = home_.filePath("scene.iv");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(text));
  file.close();
  window_->open(path);
  ASSERT_EQ(document().path(), path);
  QTest::qWait(300);
}

void Window::clickButton(const char* action) {
  QWidget* button = find<QToolBar>("toolBar").widgetForAction(&find<QAction>(action));
  ASSERT_NE(button, nullptr) << action;
  ASSERT_TRUE(button->isEnabled()) << action;
  ASSERT_TRUE(button->isVisible()) << action << " does not fit into the tool bar";
  QTest::mouseClick(button, Qt::LeftButton);
  QTest::qWait(50);
}

void Window::type(const char* field, const QString& number) {
  auto& box = find<QDoubleSpinBox>(field);
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, number);
  QTest::keyClick(&box, Qt::Key_Return);
}

void Window::startSession() {
  clickButton("startAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
}

void Window::stopSession() {
  clickButton("stopAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));
}

SessionLog Window::feel(const Vector3& target) {
  startSession();
  QTest::qWait(500);
  const QPointF from = view().toWidget(view().overlay().ballPosition());
  const QPointF to = view().toWidget(target);
  press(view(), from);
  drag(view(), from, to, 40);
  waitUntilTheBallRests();
  reached_ = view().overlay().ballPosition();
  release(view(), to);
  QTest::qWait(500);
  stopSession();
  return SessionLog(onlyLog().toStdString());
}

void Window::waitUntilTheBallRests() {
  Vector3 before = view().overlay().ballPosition();
  EXPECT_TRUE(waitFor([&] {
    QTest::qWait(400);
    const Vector3 now = view().overlay().ballPosition();
    const bool rests = (now - before).norm() < 1e-4;
    before = now;
    return rests;
  }));
}

void Window::picture(const char* name) {
  if (!qEnvironmentVariableIsSet("HAPTIV_PICTURES")) return;
  QTest::qWait(300);
  QApplication::primaryScreen()->grabWindow(0).save(qEnvironmentVariable("HAPTIV_PICTURES") + "/" + name + ".png");
}

QString Window::onlyLog() {
  const QStringList logs = QDir(logFolder()).entryList({"*.h5"});
  return logs.size() == 1 ? logFolder() + "/" + logs.front() : QString();
}

std::uint64_t Window::hardestTick(const SessionLog& log) {
  const std::vector<TickRecord> ticks = log.ticks(0, log.tickCount());
  const auto hardest = std::max_element(ticks.begin(), ticks.end(), [](const TickRecord& a, const TickRecord& b) {
    return a.environmentForce.norm() < b.environmentForce.norm();
  });
  return static_cast<std::uint64_t>(hardest - ticks.begin());
}

}  // namespace haptiv
