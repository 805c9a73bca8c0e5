#pragma once

#include <QMainWindow>
#include <memory>

namespace haptiv {

struct DeviceDescription;

/// The application's window: the view in the middle, the editor's panels beside it, plots or the replay below.
///
/// It is in one of three modes, and only one: editing; a session runs (the scene can still be edited, and is felt at
/// once); a log is replayed (the document waits unchanged).
/// SoQt and the scene graph must have been initialised. Thread: GUI.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens a scene (.iv) or a session log (.h5), by its content's ending; tells the user what stands in the way.
  void open(const QString& sceneOrLog);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildActions();
  void buildMenus();
  void buildToolBar();
  void buildDocks();
  void connectFiles();
  void connectDocument();
  void connectSession();
  void connectOperator();
  void connectView();
  void connectDexterity();
  void connectDevices();
  void watchDevices();
  void buildCalibration();
  void calibrate();
  void openCalibration();
  void showOperator();
  void startSession();
  void openFalcon(const DeviceDescription& description);
  void tellOfFalcon(const QString& why);
  void chooseFirmware();
  void keepFirmware(const QString& path);
  void enterEditing();
  void enterSession();
  void enterReplay(const QString& logPath);
  /// Whether there is an arm to be stopped: emergency stop, reset and the dead-man's key.
  void setOperatorPresent(bool present);
  /// Says in the status bar what can be done with the scene.
  void showEditing();
  void showDocument(bool viewAll);
  void showAtRest();
  void showDexterityAtRest();
  void showDexterityOfSession();
  void showDexterityOfReplay();
  void updateTitle();
  bool mayDiscardChanges();
  bool save(bool askForName);
  void askToOpen();
  void tell(const QString& what);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
