#include "app/experiments/RunCsv.h"

#include <array>
#include <charconv>

namespace haptiv {
namespace {

constexpr int kDigits = 12;
constexpr std::size_t kRowBytes = 400;  // about

void append(std::string& row, double number) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number == 0 ? 0.0 : number,
                                 std::chars_format::general, kDigits);
  if (!row.empty() && row.back() != '\n') row += ',';
  row.append(text.data(), end.ptr);
}

std::string header() {
  std::string line = "t_s";
  for (int joint = 1; joint <= kJointCount; ++joint) line += ",q" + std::to_string(joint);
  line +=
      ",index_trans,index_rot,sigma_min_rot,sigma_min_trans,condition_trans,condition_rot,phi_rad,"
      "position_error_m,orientation_error_rad";
  for (int joint = 1; joint <= kJointCount; ++joint) line += ",qd" + std::to_string(joint);
  return line + "\n";
}

}  // namespace

std::string toCsv(const RunResult& result) {
  std::string table = header();
  table.reserve(table.size() + kRowBytes * result.samples.size());
  for (const RunSample& sample : result.samples) {
    append(table, sample.time);
    for (const double angle : sample.q) append(table, angle);
    for (const double number :
         {sample.indexTrans, sample.indexRot, sample.sigmaRot[2], sample.sigmaTrans[2], sample.conditionTrans,
          sample.conditionRot, result.setup.path.angle(sample.time), sample.positionError, sample.orientationError})
      append(table, number);
    for (const double rate : sample.rates) append(table, rate);
    table += '\n';
  }
  return table;
}

}  // namespace haptiv
