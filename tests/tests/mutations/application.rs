//! Slips that only the entire application shows: unused items, names, tasks, files.

use crate::mutations::mutation::{Mutation, slip};

pub(crate) const UNUSED: &[Mutation] = &[
    slip(
        "data left over",
        "palletiser/palletiser.dtx",
        "    <Data name=\"nLayer\"",
        "    <Data name=\"nSpare\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />$0\n    <Data name=\"nLayer\"",
        "V0113",
    ),
    slip("the wrong one of two similar data", "palletiser/home.pgx", "l_jAway<jTolerance", "l_jAway<jHome", "V0113")
        .at(&[("palletiser/palletiser.dtx", "name=\"jTolerance\"")]),
    slip("data that nothing reads any more", "palletiser/drawScreen.pgx", "sState[nState]", "sState[0]", "V0116")
        .at(&[("palletiser/palletiser.dtx", "name=\"nState\"")]),
    slip(
        "local left over",
        "palletiser/home.pgx",
        "      <Local name=\"l_jAway\"",
        "      <Local name=\"l_nTry\" type=\"num\" xsi:type=\"array\" size=\"1\" />$0\n      <Local name=\"l_jAway\"",
        "V0115",
    ),
    slip("start time that nothing reads", "palletiser/cycle.pgx", "clock()-l_nStart", "clock()", "V0120")
        .at(&[("palletiser/cycle.pgx", "name=\"l_nStart\"")]),
    slip("forgotten parameter", "palletiser/host.pgx", "delay(x_nPause)", "delay(0.5)", "V0114")
        .at(&[("palletiser/host.pgx", "name=\"x_nPause\"")]),
    slip(
        "result by value",
        "palletiser/average.pgx",
        "name=\"x_nMean\" type=\"num\" xsi:type=\"element\" use=\"reference\"",
        "name=\"x_nMean\" type=\"num\" xsi:type=\"element\"",
        "V0124",
    ),
    slip("forgotten call", "palletiser/supervisor.pgx", "    call drawScreen()\n", "", "V0117")
        .at(&[("palletiser/drawScreen.pgx", "<Program name=\"drawScreen\"")]),
    slip(
        "library left over",
        "palletiser/palletiser.pjx",
        "    <Library alias=\"part\"",
        "    <Library alias=\"valves\" path=\"Disk://io/io.pjx\" />$0\n    <Library alias=\"part\"",
        "V0118",
    ),
    slip(
        "type left over",
        "palletiser/palletiser.pjx",
        "    <Type name=\"Slot\"",
        "    <Type name=\"Tray\" path=\"Disk://types/Slot/Slot.pjx\" />$0\n    <Type name=\"Slot\"",
        "V0119",
    ),
];

/// The parameter of `onKey` with its first use.
const KEY: &str = "name=\"x_nKey\" type=\"num\" xsi:type=\"element\" />\n    </Parameters>\n    <Code><![CDATA[begin\n  switch x_nKey";

pub(crate) const HIDDEN: &[Mutation] = &[
    slip(
        "parameter called like global data",
        "palletiser/onKey.pgx",
        KEY,
        "name=\"nLayer\" type=\"num\" xsi:type=\"element\" />\n    </Parameters>\n    <Code><![CDATA[begin\n  switch nLayer",
        "V0121",
    ),
    slip(
        "parameter called like an instruction",
        "palletiser/onKey.pgx",
        KEY,
        "name=\"find\" type=\"num\" xsi:type=\"element\" />\n    </Parameters>\n    <Code><![CDATA[begin\n  switch find",
        "V0122",
    ),
    slip(
        "parameter called like a frame of the language",
        "palletiser/onKey.pgx",
        KEY,
        "name=\"world\" type=\"num\" xsi:type=\"element\" />\n    </Parameters>\n    <Code><![CDATA[begin\n  switch world",
        "V0122",
    ),
    slip(
        "parameter called like a program",
        "palletiser/onKey.pgx",
        KEY,
        "name=\"pick\" type=\"num\" xsi:type=\"element\" />\n    </Parameters>\n    <Code><![CDATA[begin\n  switch pick",
        "V0123",
    ),
];

pub(crate) const TASKS: &[Mutation] = &[
    slip(
        "task in another letter case",
        "palletiser/watchTasks.pgx",
        "taskStatus(\"production\")",
        "taskStatus(\"Production\")",
        "V0341",
    ),
    slip("misspelt task", "palletiser/stop.pgx", "taskKill(\"host\")", "taskKill(\"hots\")", "V0341"),
    slip(
        "task of another application",
        "palletiser/stop.pgx",
        "taskKill(\"sensors\")",
        "taskKill(\"welder\")",
        "V0341",
    ),
    slip(
        "task created twice",
        "palletiser/start.pgx",
        "  taskCreate \"production\"",
        "  taskCreate \"host\",10,host(1)$0\n  taskCreate \"production\"",
        "V0342",
    ),
    slip(
        "name of a task taken twice",
        "palletiser/init.pgx",
        "end]]>",
        "  taskCreate \"host\",10,host(1)$0\nend]]>",
        "V0345",
    ),
    slip(
        "wait and set for setMutex",
        "palletiser/report.pgx",
        "setMutex(bReport)\n",
        "wait(bReport==false)\n  bReport=true$0\n",
        "V0340",
    ),
    slip(
        "loop and set for setMutex",
        "palletiser/report.pgx",
        "setMutex(bReport)\n",
        "while bReport\n    delay(0)\n  endWhile\n  bReport=true$0\n",
        "V0340",
    ),
    slip(
        "test and set for setMutex",
        "palletiser/report.pgx",
        "setMutex(bReport)\n",
        "if !bReport\n    bReport=true$0\n  endIf\n",
        "V0340",
    ),
];

pub(crate) const VERSIONS: &[Mutation] = &[
    slip("unlisted program", "palletiser/palletiser.pjx", "    <Program file=\"stop.pgx\" />\n", "", "V0531")
        .at(&[("palletiser/palletiser.pjx", "<Programs>")])
        .also("V0534"),
    slip("version before the form of the files", "io/io.pjx", "s7.11.3", "s6.8", "V0533"),
    slip(
        "instruction of s8",
        "palletiser/init.pgx",
        "  nLayer=0\n",
        "  nLayer=0\n  opcuaExport(nLayer,false)$0\n",
        "V0532",
    ),
];
