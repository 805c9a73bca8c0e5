#include "app/devicecheck/SpecificationTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace haptiv {
namespace {

const SpecificationRow& rowNamed(const std::vector<SpecificationRow>& rows, const std::string& property) {
  for (const SpecificationRow& row : rows) {
    if (row.property == property) return row;
  }
  throw std::runtime_error("no row " + property);
}

TourSample good() {
  TourSample sample;
  sample.position = Vector3(0.5, 0, 0);
  sample.figures = {1, 1, 1, 1, 1, 1000, 1000, 1000, 1000};
  return sample;
}

TEST(SpecificationTable, HoldsWhereEverythingIsGood) {
  Tour tour;
  tour.samples = {good(), good()};
  for (const SpecificationRow& row : judge(tour, {}, loadDeviceDescription("vishard10")))
    EXPECT_TRUE(row.holds()) << row.property;
}

TEST(SpecificationTable, NamesTheWorstPoseOfEachProperty) {
  Tour tour;
  tour.samples = {good(), good(), good()};
  tour.samples[1].figures.force = 169;
  tour.samples[1].position = Vector3(0.1, 0.2, 0.3);
  tour.samples[2].placeError = 0.5;
  tour.samples[2].q[3] = 4;
  const auto rows = judge(tour, {}, loadDeviceDescription("vishard10"));
  EXPECT_FALSE(rowNamed(rows, "force_N").holds());
  EXPECT_EQ(rowNamed(rows, "force_N").worst, 169);
  EXPECT_EQ(rowNamed(rows, "force_N").where.position, Vector3(0.1, 0.2, 0.3));
  EXPECT_FALSE(rowNamed(rows, "place_error_m").holds());
  EXPECT_EQ(rowNamed(rows, "place_error_m").where.q[3], 4);
  EXPECT_TRUE(rowNamed(rows, "speed_m_per_s").holds());
}

TEST(SpecificationTable, WhatIsNotFiniteDoesNotHold) {
  Tour tour;
  tour.samples = {good(), good(), good()};
  tour.samples[1].placeError = NAN;
  tour.samples[1].figures.force = NAN;
  const auto rows = judge(tour, {}, loadDeviceDescription("vishard10"));
  EXPECT_FALSE(rowNamed(rows, "place_error_m").holds());
  EXPECT_FALSE(rowNamed(rows, "force_N").holds());
}

TEST(SpecificationTable, NamesTheSingularityInTheShoulder) {
  Tour tour;
  tour.samples = {good(), good()};
  tour.samples[1].position = Vector3(0.01, 0, 0.02);
  tour.samples[1].figures.sigmaTranslation = 0.001;
  const auto remark = [&](const char* name) {
    return rowNamed(judge(tour, {}, loadDeviceDescription(name)), "sigma_min_trans_m").remark;
  };
  EXPECT_THAT(remark("anthropomorphic7"), testing::HasSubstr("interior singularity at the shoulder"));
  EXPECT_EQ(remark("vishard10"), "");  // it has no shoulder
  tour.samples[1].position = Vector3(0.9, 0, 0);
  EXPECT_EQ(remark("anthropomorphic7"), "");
}

}  // namespace
}  // namespace haptiv
