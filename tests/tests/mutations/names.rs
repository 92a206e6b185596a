//! Slips in names.

use crate::mutations::mutation::{Mutation, slip};

pub(crate) const USES: &[Mutation] = &[
    slip("misspelt variable", "palletiser/pick.pgx", "bHolding=x_bOk", "bHoldng=x_bOk", "V0101"),
    slip("other letter case", "palletiser/pick.pgx", "l_pNear=appro", "l_pnear=appro", "V0101"),
    slip("string without quotes", "palletiser/watchTasks.pgx", "(\"green\")", "(green)", "V0101"),
    slip("local of another program", "palletiser/cycle.pgx", "call pick(x_bOk)", "call pick(l_bOk)", "V0101"),
    slip("misspelt program", "palletiser/cycle.pgx", "call layerFull(", "call layerFul(", "V0102"),
    slip("misspelt program of a task", "palletiser/start.pgx", ",supervisor()", ",supervsor()", "V0102"),
    slip("call of an instruction", "palletiser/home.pgx", "waitEndMove()", "call waitEndMove()", "V0102"),
    slip("program without call", "palletiser/start.pgx", "call init()", "init()", "V0103"),
    slip("misspelt instruction", "palletiser/pick.pgx", "waitEndMove()", "waitEndMov()", "V0103"),
    slip("moveJ for movej", "palletiser/home.pgx", "movej(", "moveJ(", "V0103"),
    slip("index in round brackets", "palletiser/drawScreen.pgx", "sState[nState]", "sState(nState)", "V0103"),
    slip("instruction of an add-on", "palletiser/stop.pgx", "resetMotion()", "$fileClose(1)", "V0104"),
    slip("misspelt library", "palletiser/pick.pgx", "io:doConveyor=true", "i0:doConveyor=true", "V0105"),
    slip("misspelt library in call", "palletiser/pick.pgx", "call part:grip(", "call prat:grip(", "V0105"),
    slip("misspelt field of a user type", "palletiser/place.pgx", ".bFull=true", ".bFul=true", "V0107"),
    slip("misspelt field of a mdesc", "palletiser/place.pgx", "l_mNear.blend=", "l_mNear.blnd=", "V0107"),
    slip("field of another type", "palletiser/home.pgx", "l_pUp.trsf.z=max", "l_pUp.z=max", "V0107"),
    slip("program as a value", "palletiser/home.pgx", "x_bOk=isInRange(jHome)", "x_bOk=total", "V0112"),
    slip("library as a value", "palletiser/home.pgx", "x_bOk=isInRange(jHome)", "x_bOk=part", "V0112"),
];

pub(crate) const DECLARATIONS: &[Mutation] = &[
    slip("misspelt type of a local", "palletiser/place.pgx", "type=\"trsf\"", "type=\"trfs\"", "V0106"),
    slip(
        "misspelt type of a parameter",
        "palletiser/tower.pgx",
        "name=\"x_sColour\" type=\"string\"",
        "name=\"x_sColour\" type=\"sting\"",
        "V0106",
    ),
    slip("misspelt user type", "palletiser/palletiser.dtx", "type=\"Slot\"", "type=\"Slto\"", "V0106"),
    slip(
        "data twice",
        "palletiser/palletiser.dtx",
        "    <Data name=\"nLayer\"",
        "    <Data name=\"nLayer\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n    \
         <Data name=\"nLayer\"$0",
        "V0108",
    ),
    slip(
        "local twice",
        "palletiser/average.pgx",
        "      <Local name=\"l_i\"",
        "      <Local name=\"l_i\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n      <Local name=\"l_i\"$0",
        "V0108",
    ),
    slip(
        "name too long",
        "palletiser/average.pgx",
        "      <Local name=\"l_i\"",
        "      <Local name=\"l_nAverageOfTimes\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n      \
         <Local name=\"l_i\"",
        "V0109",
    )
    .also("V0115"),
    slip(
        "name with a hyphen",
        "palletiser/average.pgx",
        "      <Local name=\"l_i\"",
        "      <Local name=\"l-n\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n      <Local name=\"l_i\"",
        "V0110",
    ),
    slip(
        "keyword as a local",
        "palletiser/average.pgx",
        "      <Local name=\"l_i\"",
        "      <Local name=\"step\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n      <Local name=\"l_i\"",
        "V0111",
    ),
];
