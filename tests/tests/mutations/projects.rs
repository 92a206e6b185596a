//! Slips in projects, data files and library interfaces.

use crate::mutations::mutation::{Mutation, lost, slip};

pub(crate) const FILES: &[Mutation] = &[
    lost("lost program", "palletiser/tower.pgx", "V0501").at(&[("palletiser/palletiser.pjx", "tower.pgx")]),
    lost("lost data", "io/io.dtx", "V0501").at(&[("io/io.pjx", "io.dtx")]),
    slip(
        "wrong path of a library",
        "palletiser/palletiser.pjx",
        "Disk://partBox/partBox.pjx",
        "Disk://partBx/partBox.pjx",
        "V0501",
    ),
    slip(
        "wrong path of a type",
        "palletiser/palletiser.pjx",
        "Disk://types/Slot/Slot.pjx",
        "Disk://Slot/Slot.pjx",
        "V0501",
    ),
    slip(
        "program listed twice",
        "palletiser/palletiser.pjx",
        "    <Program file=\"tower.pgx\" />",
        "    <Program file=\"tower.pgx\" />\n    <Program file=\"tower.pgx\" />$0",
        "V0503",
    ),
    slip(
        "library declared twice",
        "palletiser/palletiser.pjx",
        "    <Library alias=\"part\"",
        "    <Library alias=\"io\" path=\"Disk://io/io.pjx\" />$0\n    <Library alias=\"part\"",
        "V0503",
    ),
    slip(
        "program under another name",
        "palletiser/stop.pgx",
        "<Program name=\"stop\"",
        "<Program name=\"halt\"",
        "V0508",
    ),
    slip(
        "missing attribute",
        "palletiser/palletiser.dtx",
        "name=\"nLayer\" access=\"public\" xsi:type=\"array\" type=\"num\"",
        "name=\"nLayer\" access=\"public\" xsi:type=\"array\"",
        "V0505",
    ),
    slip(
        "unknown access",
        "palletiser/palletiser.dtx",
        "name=\"nLayer\" access=\"public\"",
        "name=\"nLayer\" access=\"protected\"",
        "V0506",
    ),
    slip(
        "unknown container",
        "palletiser/palletiser.dtx",
        "name=\"nLayer\" access=\"public\" xsi:type=\"array\"",
        "name=\"nLayer\" access=\"public\" xsi:type=\"list\"",
        "V0506",
    ),
    slip("size of the stack in words", "palletiser/palletiser.pjx", "stackSize=\"5000\"", "stackSize=\"5k\"", "V0506"),
    slip("unknown unit", "palletiser/palletiser.pjx", "millimeterUnit=\"true\"", "millimeterUnit=\"yes\"", "V0506"),
    slip("access in another letter case", "partBox/grip.pgx", "access=\"public\"", "access=\"Public\"", "V0506"),
    slip(
        "user type called as a built-in one",
        "palletiser/palletiser.pjx",
        "    <Type name=\"Slot\"",
        "    <Type name=\"num\" path=\"Disk://types/Slot/Slot.pjx\" />\n    <Type name=\"Slot\"",
        "V0111",
    ),
    slip(
        "foreign element",
        "palletiser/palletiser.dtx",
        "    <Data name=\"nLayer\"",
        "    <Remark />\n    <Data name=\"nLayer\"",
        "V0507",
    ),
    slip(
        "libraries in a circle",
        "io/io.pjx",
        "  <Libraries />",
        "  <Libraries>\n    <Library alias=\"main\" path=\"Disk://palletiser/palletiser.pjx\" />$0\n  </Libraries>",
        "V0530",
    ),
    slip(
        "misspelt attribute of data",
        "palletiser/palletiser.dtx",
        "name=\"nLayer\" access=\"public\"",
        "name=\"nLayer\" acess=\"private\"",
        "V0505",
    ),
    slip(
        "data without a size",
        "palletiser/palletiser.dtx",
        "name=\"nLayer\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\"",
        "name=\"nLayer\" access=\"public\" xsi:type=\"array\" type=\"num\"",
        "V0505",
    ),
    slip("misspelt attribute of a program", "partBox/grip.pgx", " access=\"public\"", " acces=\"public\"", "V0535"),
    slip("program without code", "palletiser/stop.pgx", STOP_CODE, "", "V0536")
        .at(&[("palletiser/stop.pgx", "<Program name")]),
    slip("namespace of another version", "palletiser/stop.pgx", "VAL3/Program/2", "VAL3/Program/3", "V0537"),
    slip("control character in a string", "palletiser/stop.pgx", "\"host\"", "\"ho\u{0}st\"", "V0007"),
    slip(
        "reserved word as a library identifier",
        "palletiser/palletiser.pjx",
        "    <Library alias=\"part\"",
        "    <Library alias=\"Default\" path=\"Disk://partBag/partBag.pjx\" />\n    <Library alias=\"part\"",
        "V0111",
    ),
    slip("empty version", "palletiser/palletiser.pjx", "version=\"s7.11.3\"", "version=\"\"", "V0506"),
    slip("project without a version", "palletiser/palletiser.pjx", " version=\"s7.11.3\"", "", "V0505"),
];

/// Code of the program `stop`.
const STOP_CODE: &str = "    <Code><![CDATA[begin
  // First the tasks that command the arm and the outputs, then what they left behind
  taskKill(\"production\")
  taskKill(\"supervisor\")
  taskKill(\"host\")
  taskKill(\"sensors\")
  resetMotion()
  io:doConveyor=false
  call tower(\"\")
end]]></Code>
";

pub(crate) const VALUES: &[Mutation] = &[
    slip(
        "blend of a hundredth of a millimetre",
        "palletiser/palletiser.dtx",
        "leave=\"120\" reach=\"120\"",
        "blend=\"joint\" leave=\"0.01\" reach=\"0.01\"",
        "V0419",
    ),
    slip("letter in a number", "palletiser/palletiser.dtx", "value=\"150\"", "value=\"15O\"", "V0510"),
    slip("yes for true", "partBox/partBox.dtx", "value=\"true\"", "value=\"yes\"", "V0510"),
    slip("unknown blend", "palletiser/palletiser.dtx", "blend=\"off\"", "blend=\"none\"", "V0510"),
    slip(
        "unknown shoulder",
        "palletiser/palletiser.dtx",
        "z=\"50\" rx=\"180\" shoulder=\"lefty\"",
        "z=\"50\" rx=\"180\" shoulder=\"left\"",
        "V0510",
    ),
    slip("misspelt attribute of a value", "palletiser/palletiser.dtx", "ioOpen=", "ioOpn=", "V0511"),
    slip(
        "key out of range",
        "palletiser/palletiser.dtx",
        "key=\"3\" value=\"fault\"",
        "key=\"4\" value=\"fault\"",
        "V0512",
    ),
    slip(
        "key twice",
        "palletiser/palletiser.dtx",
        "key=\"2\" value=\"running\"",
        "key=\"1\" value=\"running\"",
        "V0513",
    ),
    slip("misspelt key", "palletiser/palletiser.dtx", "<Value key=\"1,2\">", "<Value kye=\"1,2\">", "V0505"),
    slip("key of a collection twice", "io/io.dtx", "key=\"red\"", "key=\"green\"", "V0513"),
    slip("one index in a key of two", "palletiser/palletiser.dtx", "<Value key=\"1,2\">", "<Value key=\"1\">", "V0514"),
    slip(
        "unknown field of a user type",
        "palletiser/palletiser.dtx",
        "<Value key=\"0,0\">\n        <Field name=\"pPlace\"",
        "<Value key=\"0,0\">\n        <Field name=\"pPlaced\"$0",
        "V0515",
    ),
    slip(
        "field of a user type with another type",
        "palletiser/palletiser.dtx",
        "type=\"string\" size=\"1\" />\n      </Value>\n      <Value key=\"0,1\">",
        "type=\"num\" size=\"1\" />\n      </Value>\n      <Value key=\"0,1\">",
        "V0516",
    ),
    slip(
        "field twice",
        "palletiser/palletiser.dtx",
        "type=\"string\" size=\"1\" />\n      </Value>\n    </Data>",
        "type=\"string\" size=\"1\" />\n        \
         <Field name=\"bFull\" xsi:type=\"array\" type=\"bool\" size=\"1\" />$0\n      </Value>\n    </Data>",
        "V0108",
    ),
    slip(
        "string too long in data",
        "palletiser/palletiser.dtx",
        "value=\"waiting\"",
        "value=\"waiting for a part, for the pallet, for the operator, for the host, for the gripper, for the weight, \
         for the lamp, for the vacuum\"",
        "V0223",
    ),
    slip("size in words", "palletiser/palletiser.dtx", "size=\"10\"", "size=\"ten\"", "V0517"),
    slip("comma in a size", "palletiser/palletiser.dtx", "size=\"2 3\"", "size=\"2,3\"", "V0517"),
    slip("zeros too many in a size", "palletiser/palletiser.dtx", "size=\"10\"", "size=\"1000000000\"", "V0539"),
];

pub(crate) const LINKS: &[Mutation] = &[
    slip(
        "misspelt father",
        "palletiser/palletiser.dtx",
        "fatherId=\"fConveyor[0]\"",
        "fatherId=\"fConveyr[0]\"",
        "V0520",
    ),
    slip(
        "frame as father of a tool",
        "palletiser/palletiser.dtx",
        "fatherId=\"tGripper[0]\"",
        "fatherId=\"fCell[0]\"",
        "V0521",
    ),
    slip(
        "frames in a circle",
        "palletiser/palletiser.dtx",
        "z=\"-800\" fatherId=\"world[0]\"",
        "z=\"-800\" fatherId=\"fPallet[0]\"",
        "V0522",
    ),
    slip(
        "father in a library",
        "palletiser/palletiser.dtx",
        "fatherId=\"fConveyor[0]\"",
        "fatherId=\"part:fConveyor[0]\"",
        "V0523",
    ),
    slip(
        "father out of bounds",
        "palletiser/palletiser.dtx",
        "fatherId=\"fConveyor[0]\"",
        "fatherId=\"fConveyor[3]\"",
        "V0524",
    ),
    slip(
        "father with an index too many",
        "palletiser/palletiser.dtx",
        "fatherId=\"fConveyor[0]\"",
        "fatherId=\"fConveyor[0,0]\"",
        "V0524",
    ),
    slip(
        "father with a negative index",
        "palletiser/palletiser.dtx",
        "fatherId=\"fConveyor[0]\"",
        "fatherId=\"fConveyor[-1]\"",
        "V0524",
    ),
    slip("unknown input", "io/io.dtx", "BasicIO-1\\%I3", "BasicIO-1\\%I33", "V0525"),
    slip("socket for an input", "io/io.dtx", "BasicIO-1\\%I3", "Socket\\host", "V0526"),
];

/// Location at which a library that does not fulfil the interface of `part` is reported: where it is loaded.
const LOAD: (&str, &str) = ("palletiser/loadPart.pgx", "Disk://partBag");

pub(crate) const LIBRARIES: &[Mutation] = &[
    slip(
        "misspelt root of a path",
        "palletiser/palletiser.pjx",
        "Disk://partBox/partBox.pjx",
        "Disc://partBox/partBox.pjx",
        "V0608",
    ),
    slip(
        "backslash in a path",
        "palletiser/palletiser.pjx",
        "Disk://partBox/partBox.pjx",
        "Disk://partBox\\partBox.pjx",
        "V0538",
    ),
    slip("misspelt program of a library", "palletiser/pick.pgx", "call part:grip(", "call part:gripp(", "V0601"),
    slip("misspelt data of a library", "palletiser/pick.pgx", "io:doConveyor=true", "io:doConvyor=true", "V0601"),
    slip("item that the interface lacks", "palletiser/place.pgx", "part:nHeight/2", "part:nSettle/2", "V0601"),
    slip("private data of a library", "palletiser/place.pgx", "part:nHeight/2", "part:nVacuum/2", "V0602"),
    slip("private program of a library", "partBox/grip.pgx", " access=\"public\"", "", "V0602")
        .at(&[("palletiser/pick.pgx", "part:grip")]),
    slip(
        "library without libLoad",
        "palletiser/palletiser.pjx",
        "path=\"Disk://io/io.pjx\"",
        "path=\"Disk://io/io.pjx\" autoload=\"false\"",
        "V0603",
    ),
    slip("libLoad of nothing", "palletiser/loadPart.pgx", "Disk://partBag", "Disk://partBg", "V0604"),
    slip("implementation lacks a program", "partBag/partBag.pjx", "    <Program file=\"drop.pgx\" />\n", "", "V0605")
        .at(&[LOAD])
        .also("V0531"),
    slip("a library with another interface", "palletiser/loadPart.pgx", "Disk://partBag", "Disk://io", "V0605")
        .at(&[("palletiser/loadPart.pgx", "Disk://io")]),
    slip("implementation hides a program", "partBag/grip.pgx", " access=\"public\"", "", "V0606")
        .at(&[LOAD, ("partBag/grip.pgx", "<Program name=\"grip\"")]),
    slip(
        "implementation hides data",
        "partBag/partBag.dtx",
        "name=\"bVacuum\" access=\"public\"",
        "name=\"bVacuum\" access=\"private\"",
        "V0606",
    )
    .at(&[LOAD, ("partBag/partBag.dtx", "name=\"bVacuum\"")]),
    slip(
        "implementation takes another type",
        "partBag/offset.pgx",
        "name=\"x_trOffset\" type=\"trsf\"",
        "name=\"x_trOffset\" type=\"joint\"",
        "V0607",
    )
    .at(&[LOAD, ("partBag/offset.pgx", "name=\"x_trOffset\"")]),
    slip("implementation takes by value", "partBag/init.pgx", " use=\"reference\"", "", "V0607")
        .at(&[LOAD, ("partBag/init.pgx", "name=\"x_bOk\"")])
        .also("V0124"),
    slip(
        "implementation has data of another type",
        "partBag/partBag.dtx",
        "name=\"bVacuum\" access=\"public\" xsi:type=\"array\" type=\"bool\"",
        "name=\"bVacuum\" access=\"public\" xsi:type=\"array\" type=\"num\"",
        "V0607",
    )
    .at(&[LOAD, ("partBag/partBag.dtx", "name=\"bVacuum\"")]),
];
