#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/plots/samples/Envelope.h"
#include "app/replay/LogReader.h"

namespace haptiv {

/// Curves over one time, as SignalPlot takes them.
struct Curves {
  std::vector<double> times;                 ///< [s]
  std::vector<std::vector<double>> samples;  ///< one a curve
};

/// Brings a log's curves into the plots: a block in each turn of the event loop, thinned while they are read, so that
/// the window stays alive and a log of any length takes little memory. Zooming in is answered with a finer reading of
/// that time.
class CurveLoader : public QObject {
  Q_OBJECT
 public:
  explicit CurveLoader(QObject* parent = nullptr);

  /// Starts to read; the log is not owned and must live until stop.
  void start(const SessionLog& log);
  void stop();
  /// Reads these times [s] again, finer, if that shows more.
  void refine(double from, double to);

  Curves force() const;     ///< as TickPlots' force plot has them [N]
  Curves position() const;  ///< [m]
  Curves energy() const;    ///< [J]
  bool isLoading() const { return timer_.isActive(); }

 signals:
  /// There is more to show.
  void progressed();
  void failed(const QString& message);

 private:
  /// One reading of the ticks [next, end).
  struct Pass {
    Pass(std::uint64_t first, std::uint64_t past);
    std::uint64_t next;
    std::uint64_t end;
    std::uint64_t bucket;
    Envelope envelope;
    bool done() const { return next >= end; }
  };
  void readBlock();
  void read(Pass& pass);
  Curves curves(std::size_t first, std::size_t count) const;

  QTimer timer_;
  std::optional<LogReader> reader_;
  std::optional<Pass> overview_;
  std::optional<Pass> detail_;
};

}  // namespace haptiv
