#include "device/parsing/DescriptionFormat.h"

namespace haptiv {
namespace {

using enum Rule;

Section drives(JointDrives& drives, int joints) {
  return {"drives",
          {{"gearRatio", JointList{&drives.gearRatio, joints}, positive},
           {"countsPerTurn", JointList{&drives.countsPerTurn, joints}, positive},
           {"rateLimit", JointList{&drives.rateLimit, joints}, positive},
           {"torqueLimit", JointList{&drives.torqueLimit, joints}, positive},
           {"inertia", JointList{&drives.inertia, joints}, positive},
           {"bandwidth", JointList{&drives.bandwidth, joints}, positive},
           {"viscousFriction", JointList{&drives.viscousFriction, joints}, notNegative},
           {"coulombFriction", JointList{&drives.coulombFriction, joints}, notNegative},
           {"brakeDamping", JointList{&drives.brakeDamping, joints}, positive},
           {"brakeFriction", JointList{&drives.brakeFriction, joints}, notNegative}}};
}

Section safety(SafetyThresholds& safety, int joints) {
  return {"safety",
          {{"watchdogTime", &safety.watchdogTime, positive},
           {"velocityTimeUnit", &safety.velocityTimeUnit, positive},
           {"countThreshold", JointList{&safety.countThreshold, joints}, positive},
           {"forceClamp", &safety.forceClamp, positive},
           {"torqueClamp", &safety.torqueClamp, positive},
           {"speedClamp", &safety.speedClamp, positive},
           {"accelerationClamp", &safety.accelerationClamp, positive},
           {"handForceLimit", &safety.handForceLimit, positive},
           {"oscillationSpeed", &safety.oscillationSpeed, positive},
           {"missedTime", &safety.missedTime, positive}}};
}

Section delta(DeltaGeometry& delta) {
  return {"delta",
          {{"baseRadius", &delta.baseRadius, positive},
           {"baseOffset", &delta.baseOffset},
           {"upperArm", &delta.upperArm, positive},
           {"forearm", &delta.forearm, positive},
           {"hinges", &delta.hinges, notNegative},
           {"platformRadius", &delta.platformRadius, notNegative},
           {"legAngles", &delta.legAngles}}};
}

Section falcon(FalconWiring& falcon) {
  return {"falcon",
          {{"homedAngle", &falcon.homedAngle},
           {"torqueCounts", &falcon.torqueCounts},
           {"mostTorqueCounts", &falcon.mostTorqueCounts, positive}}};
}

Section hand(HandModel& hand) {
  return {"hand",
          {{"stiffness", &hand.stiffness, notNegative},
           {"damping", &hand.damping, notNegative},
           {"peakForce", &hand.peakForce, positive},
           {"bandwidth", &hand.bandwidth, positive},
           {"mass", &hand.mass, positive},
           {"gripStiffness", &hand.gripStiffness, positive},
           {"gripDamping", &hand.gripDamping, notNegative},
           {"gripStrength", &hand.gripStrength, positive},
           {"turnStiffness", &hand.turnStiffness, notNegative},
           {"turnDamping", &hand.turnDamping, notNegative},
           {"peakTorque", &hand.peakTorque, positive}}};
}

Section control(ControlSettings& control) {
  return {"control",
          {{"display", &control.choice.display},
           {"joints", &control.choice.joints},
           {"orientation", &control.choice.orientation},
           {"passivity", &control.choice.passivity},
           {"driftGain", &control.driftGain, notNegative},
           {"jointGain", &control.jointGain, notNegative},
           {"singularityDamping", &control.singularityDamping, positive},
           {"singularityThreshold", &control.singularityThreshold, positive},
           {"trackingErrorLimit", &control.trackingErrorLimit, positive},
           {"trackingFrequency", &control.trackingFrequency, positive},
           {"trackingDampingRatio", &control.trackingDampingRatio, notNegative},
           {"velocityBandwidth", &control.velocityBandwidth, positive},
           {"rotationalInertia", &control.rotationalInertia, positive},
           {"rotationalDamping", &control.rotationalDamping, notNegative},
           {"orientationStiffness", &control.orientationStiffness, notNegative},
           {"orientationDamping", &control.orientationDamping, notNegative},
           {"selfMotionDamping", &control.selfMotionDamping, notNegative}}};
}

Section redundancy(RedundancySettings& redundancy, int joints) {
  return {"redundancy",
          {{"strategy", &redundancy.choice.strategy},
           {"solution", &redundancy.choice.solution},
           {"stepFull", &redundancy.stepFull},
           {"stepPartitioned", &redundancy.stepPartitioned},
           {"translationWeight", &redundancy.translationWeight, notNegative},
           {"rotationWeight", &redundancy.rotationWeight, notNegative},
           {"weighByRateLimits", &redundancy.weighByRateLimits},
           {"normalisationPoses", PoseList{&redundancy.normalisationPoses, joints}}}};
}

}  // namespace

std::vector<Section> sectionsOf(DeviceDescription& d, int joints) {
  std::vector<Section> sections = {
      {"links",
       {{"scara", &d.links.scara, positive},
        {"forearm", &d.links.forearm, notNegative},
        {"lift", &d.links.lift, positive},
        {"scaraHeight", &d.links.scaraHeight, notNegative},
        {"wristBracket", &d.links.wristBracket, notNegative}}},
      {"tool", {{"xyz", &d.tool.position}, {"rpy", RollPitchYaw{&d.tool.rotation}}}},
      drives(d.drives, joints),
      {"sensor",
       {{"forceResolution", &d.sensor.forceResolution, positive},
        {"torqueResolution", &d.sensor.torqueResolution, positive},
        {"forceNoise", &d.sensor.forceNoise, notNegative},
        {"torqueNoise", &d.sensor.torqueNoise, notNegative},
        {"forceRange", &d.sensor.forceRange, positive},
        {"torqueRange", &d.sensor.torqueRange, positive},
        {"bandwidth", &d.sensor.bandwidth, positive},
        {"bias", &d.sensor.bias},
        {"matrix", SquareOfAxes{&d.sensor.matrix}}}},
      {"encoders",
       {{"zero", JointList{&d.encoders.zero, joints}}, {"reference", JointList{&d.encoders.reference, joints}}}},
      hand(d.hand),
      control(d.control),
      redundancy(d.redundancy, joints),
      safety(d.safety, joints),
      {"home", {{"angles", JointList{&d.homeAngles, joints}}}},
  };
  if (d.delta) {
    sections.push_back(delta(*d.delta));
    sections.push_back(falcon(d.falcon));
  }
  return sections;
}

}  // namespace haptiv
