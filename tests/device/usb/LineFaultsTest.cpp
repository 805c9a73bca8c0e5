/// What befalls single packets: dropped and counted, and the arm goes on.
#include "tests/device/usb/bench/UsbBench.h"

namespace haptiv::test {
namespace {

struct LineFaultsTest : UsbBench {
  /// Ticks in which nothing more happens: the arm is still driven.
  void goesOn() {
    tick(20);
    EXPECT_TRUE(drives());
    EXPECT_TRUE(reading.connected);
    EXPECT_EQ(trips(), kNoTrip);
    EXPECT_EQ(figures().losses, 0u);
  }
};

TEST_F(LineFaultsTest, CountsNothingWhereNothingIsWrong) {
  drive();
  goesOn();
  const usb::LinkFigures f = figures();
  EXPECT_EQ(f.damaged + f.outOfOrder + f.missing + f.stalls + f.tooLong + f.errors + f.skipped, 0u);
  EXPECT_GT(f.states, 8u * 20u);
  EXPECT_EQ(board->board().report().counters.accepted, f.sent);
}

TEST_F(LineFaultsTest, DropsAStateWithAWrongCheckSum) {
  drive();
  port->faults.corrupt = 5;
  goesOn();
  EXPECT_EQ(figures().damaged, 5u);
  EXPECT_EQ(figures().missing, 5u);
}

TEST_F(LineFaultsTest, CountsStatesThatNeverCame) {
  drive();
  port->faults.lose = 3;
  goesOn();
  EXPECT_EQ(figures().missing, 3u);
}

TEST_F(LineFaultsTest, DropsAStateThatComesTwice) {
  drive();
  port->faults.repeat = 2;
  goesOn();
  EXPECT_EQ(figures().outOfOrder, 2u);
  EXPECT_EQ(figures().missing, 0u);
}

TEST_F(LineFaultsTest, DropsAStateThatCameLate) {
  drive();
  port->faults.swap = 1;
  goesOn();
  EXPECT_EQ(figures().outOfOrder, 1u);
  EXPECT_EQ(figures().missing, 1u);
}

TEST_F(LineFaultsTest, DropsStatesThatAreTooShortOrTooLong) {
  drive();
  port->faults.shorten = 2;
  goesOn();
  EXPECT_EQ(figures().damaged, 2u);
  port->faults.lengthen = 3;
  goesOn();
  EXPECT_EQ(figures().damaged, 5u);
}

TEST_F(LineFaultsTest, SurvivesABabblingBoard) {
  drive();
  port->faults.babble = 4;
  goesOn();
  EXPECT_EQ(figures().tooLong, 4u);
}

TEST_F(LineFaultsTest, SurvivesErrorsThatTheBusFinds) {
  drive();
  port->faults.damage = 4;
  goesOn();
  EXPECT_EQ(figures().errors, 4u);
}

TEST_F(LineFaultsTest, ClearsAStallOfEitherEndpoint) {
  drive();
  port->faults.stallIn = 1;
  goesOn();
  EXPECT_EQ(figures().stalls, 1u);
  port->faults.stallOut = 1;
  goesOn();
  EXPECT_EQ(figures().stalls, 2u);
}

TEST_F(LineFaultsTest, LosesAndRepeatsCommandsWithoutHarm) {
  drive();
  const std::uint32_t accepted = board->board().report().counters.accepted;
  port->faults.loseOut = 2;
  goesOn();
  EXPECT_EQ(board->board().report().counters.accepted, accepted + 20 - 2);
  port->faults.corruptOut = 2;
  goesOn();
  EXPECT_EQ(board->board().report().counters.damaged, 2u);
  EXPECT_EQ(board->board().report().counters.accepted, accepted + 40 - 4);
  port->faults.repeatOut = 3;
  goesOn();
  EXPECT_EQ(board->board().report().counters.outOfOrder, 3u);
}

TEST_F(LineFaultsTest, SkipsCommandsThatABusyBoardDoesNotTakeAndNeverQueuesThem) {
  drive();
  port->faults.holdOut = true;
  command.jointRates[0] = 0.1;
  tick(5);  // two are on their way, three skipped
  EXPECT_EQ(figures().skipped, 3u);
  port->faults.holdOut = false;
  command.jointRates[0] = 0.2;
  tick(1);
  EXPECT_EQ(figures().skipped, 4u);
  tick(1);
  EXPECT_DOUBLE_EQ(setPoint(), 0.2);
  goesOn();
}

TEST_F(LineFaultsTest, GivesUpALineThatDoesNothingButFail) {
  drive();
  port->faults.damage = 1000;
  tick(30);
  EXPECT_FALSE(reading.connected);
  EXPECT_EQ(figures().losses, 1u);
  EXPECT_FALSE(drives());
}

}  // namespace
}  // namespace haptiv::test
