//! Slips in the form of the code and of the XML around it.

use crate::mutation::{Mutation, slip};

pub(crate) const BLOCKS: &[Mutation] = &[
    slip("dropped endIf", "palletiser/pick.pgx", "\n    endIf\n  until", "$0\n  until$0", "V0014"),
    slip("dropped endFor", "palletiser/average.pgx", "\n  endFor\n  x_nMean", "$0\n  x_nMean$0", "V0014"),
    slip("dropped endWhile", "palletiser/total.pgx", "\n  endWhile\nend", "$0\nend$0", "V0014"),
    slip("dropped endSwitch", "palletiser/onKey.pgx", "\n  endSwitch\nend", "$0\nend$0", "V0014"),
    slip(
        "dropped until",
        "palletiser/pick.pgx",
        "\n  until x_bOk==true or bRun==false\n  io:doConveyor=false",
        "$0\n  io:doConveyor=false$0",
        "V0014",
    ),
    slip("dropped inner endFor", "palletiser/clearPallet.pgx", "\n    endFor\n  endFor", "$0\n  endFor$0", "V0014"),
    slip("dropped break", "palletiser/onOrder.pgx", "\n    break\n    case \"run\"", "$0\n    case \"run\"$0", "V0016"),
    slip("dropped begin", "palletiser/start.pgx", "begin\n  call init()", "$0\n  call init()$0", "V0028"),
    slip("dropped end", "palletiser/start.pgx", "\nend]]>", "$0]]>", "V0028"),
    slip("endIf twice", "palletiser/home.pgx", "  endIf\nend", "  endIf\n  endIf$0\nend", "V0015"),
    slip("endFor for endWhile", "palletiser/total.pgx", "  endWhile", "  endFor", "V0014"),
    slip("dropped if", "palletiser/layerFull.pgx", "  if nLayer>=part:nLayers\n", "", "V0015")
        .at(&[("palletiser/layerFull.pgx", "  endIf")]),
    slip("dropped while", "palletiser/total.pgx", "  while l_sKey!=\"\"\n", "", "V0015")
        .at(&[("palletiser/total.pgx", "  endWhile")]),
    slip("dropped for", "palletiser/average.pgx", "  for l_i=0 to size(x_nTimes)-1\n", "", "V0015")
        .at(&[("palletiser/average.pgx", "  endFor")]),
    slip("dropped do", "palletiser/pick.pgx", "  do\n", "", "V0015").at(&[("palletiser/pick.pgx", "  until")]),
    slip("dropped switch", "palletiser/onKey.pgx", "  switch x_nKey\n", "", "V0018")
        .at(&[("palletiser/onKey.pgx", "case 271")]),
    slip("else twice", "palletiser/onKey.pgx", "      else\n", "      else\n      else$0\n", "V0015"),
    slip("break outside switch", "palletiser/cycle.pgx", "    return\n", "    break\n", "V0017"),
    slip(
        "case after default",
        "palletiser/onKey.pgx",
        "\n  endSwitch",
        "\n    case 274$0\n      cls()\n    break\n  endSwitch",
        "V0019",
    ),
    slip("default twice", "palletiser/onKey.pgx", "\n  endSwitch", "\n    default$0\n    break\n  endSwitch", "V0020"),
    slip("statement before case", "palletiser/onKey.pgx", "switch x_nKey\n", "switch x_nKey\n    cls()$0\n", "V0021"),
    slip("code behind end", "palletiser/stop.pgx", "\nend]]>", "\nend\n  cls()$0]]>", "V0029"),
    slip("comma for to", "palletiser/clearPallet.pgx", "l_nRow=0 to ", "l_nRow=0, ", "V0030"),
    slip("step without a value", "palletiser/nextSlot.pgx", "step -1", "step", "V0030"),
];

pub(crate) const LINES: &[Mutation] = &[
    slip("missing )", "palletiser/pick.pgx", "movej(l_pNear,tSuction,mFast)", "movej(l_pNear,tSuction,mFast", "V0011"),
    slip("missing ]", "palletiser/average.pgx", "l_nSum+x_nTimes[l_i]", "l_nSum+x_nTimes[l_i", "V0011"),
    slip("missing }", "palletiser/pick.pgx", "{0,0,-nAbove,0,0,0})", "{0,0,-nAbove,0,0,0)", "V0011"),
    slip("a ) too many", "palletiser/cycle.pgx", "call pick(x_bOk)", "call pick(x_bOk))", "V0012"),
    slip("missing closing quote", "palletiser/watchTasks.pgx", "(\"green\")", "(\"green)", "V0013"),
    slip("missing opening quote", "palletiser/watchTasks.pgx", "(\"green\")", "(green\")", "V0013"),
    slip("single quotes", "palletiser/watchTasks.pgx", "(\"green\")", "('green')", "V0010"),
    slip("= for == in a condition", "palletiser/onKey.pgx", "sWanted==\"partBox\"", "sWanted=\"partBox\"", "V0023"),
    slip("two unary operators", "palletiser/pick.pgx", "{0,0,-nAbove", "{0,0,- -nAbove", "V0022"),
    slip("comment behind code", "palletiser/place.pgx", "bHolding=false", "bHolding=false // let go", "V0024"),
    slip("&& for and", "palletiser/sensors.pgx", "==true and ", "==true && ", "V0026"),
    slip("<> for !=", "palletiser/production.pgx", "sWanted!=sLoaded", "sWanted<>sLoaded", "V0026"),
    slip("if with then", "palletiser/production.pgx", "if sWanted!=sLoaded", "if sWanted!=sLoaded then", "V0026"),
    slip("semicolon", "palletiser/start.pgx", "call init()", "call init();", "V0010"),
    slip("call without ()", "palletiser/start.pgx", "call init()", "call init", "V0010"),
    slip("keyword as a name", "palletiser/start.pgx", "call init()", "call for()", "V0025"),
    slip("return with a value", "palletiser/home.pgx", "    return", "    return false", "V0027"),
    slip(
        "missing comma",
        "palletiser/place.pgx",
        "compose(tSlots[x_nRow,x_nColumn].pPlace,",
        "compose(tSlots[x_nRow,x_nColumn].pPlace ",
        "V0010",
    ),
    slip("missing (", "palletiser/pick.pgx", "movej(l_pNear,", "movej l_pNear,", "V0010"),
    slip("else if for elseIf", "palletiser/watchTasks.pgx", "elseIf l_nStatus==1\n", "else if l_nStatus==1\n", "V0026"),
    slip(":= for =", "palletiser/init.pgx", "nLayer=0", "nLayer:=0", "V0010"),
    slip("missing operand", "palletiser/layerFull.pgx", "nLayer=nLayer+1", "nLayer=nLayer+", "V0010"),
    slip("endif", "palletiser/pick.pgx", "    endIf\n  until", "    endif\n  until", "V0701"),
    slip("merge conflict", "palletiser/place.pgx", "  bHolding=false\n", "<<<<<<< HEAD\n  bHolding=false\n", "V0004"),
];

pub(crate) const XML: &[Mutation] = &[
    slip("unclosed element", "palletiser/place.pgx", "\n    </Locals>\n", "$0\n$0", "V0001").at(&[
        ("palletiser/place.pgx", "<Locals>"),
        ("palletiser/place.pgx", "<Code>"),
        ("palletiser/place.pgx", "name=\"l_trOffset\""),
    ]),
    slip("bare &", "palletiser/palletiser.dtx", "value=\"waiting\"", "value=\"waiting & idle\"", "V0002"),
    slip("attribute without quotes", "palletiser/palletiser.dtx", "size=\"10\"", "size=10", "V0003"),
    slip("attribute twice", "palletiser/palletiser.dtx", "size=\"10\"", "size=\"10\" size=\"10\"", "V0003"),
    slip(
        "merge conflict in data",
        "palletiser/palletiser.dtx",
        "    <Data name=\"nLayer\"",
        "=======\n    <Data name=\"nLayer\"",
        "V0004",
    ),
];
