//! An application with one long program, in which a name is used a thousand times.

/// Lines of the program.
const LINES: usize = 2_600;

/// Lines of a block; each block uses `nCount` three times.
const BLOCK: &str = "  // one more layer\n  for l_i=0 to 9\n    if nCount>l_i and bReady\n      movej(appro(pTray[l_i],{0,0,-50,0,0,0}),tGripper,mFast)\n      \
    nCount=nCount+1\n    endIf\n  endFor\n  waitEndMove()\n";

const LINES_OF_BLOCK: usize = 8;

/// Path of the program below the folder.
pub(super) const PROGRAM: &str = "usr/usrapp/long/start.pgx";

/// Name that is used a thousand times.
pub(super) const NAME: &str = "nCount";

/// Returns the files' paths and texts.
pub(super) fn files() -> [(&'static str, String); 4] {
    let project = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  \
        <Parameters version=\"s7.7.2\" stackSize=\"5000\" millimeterUnit=\"true\" />\n  <Programs>\n    \
        <Program file=\"start.pgx\" />\n    <Program file=\"stop.pgx\" />\n  </Programs>\n  <Database>\n    \
        <Data file=\"long.dtx\" />\n  </Database>\n  <Libraries />\n</Project>";
    let database = ["<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n".to_owned(),
        data("bReady", "bool", 1, "<Value key=\"0\" value=\"true\" />"),
        data("mFast", "mdesc", 1, ""),
        data(NAME, "num", 1, ""),
        data("pTray", "pointRx", 10, ""),
        data("tGripper", "tool", 1, ""),
        "  </Datas>\n</Database>".to_owned()].concat();
    let locals = "    <Locals>\n      <Local name=\"l_i\" type=\"num\" xsi:type=\"array\" size=\"1\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" />\n    </Locals>\n";
    [
        ("usr/usrapp/long/long.pjx", project.to_owned()),
        ("usr/usrapp/long/long.dtx", database),
        (PROGRAM, program("start", locals, &BLOCK.repeat(LINES / LINES_OF_BLOCK))),
        ("usr/usrapp/long/stop.pgx", program("stop", "", "  resetMotion()\n")),
    ]
}

fn data(name: &str, ty: &str, size: usize, values: &str) -> String {
    format!(
        "    <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\">{values}</Data>\n"
    )
}

fn program(name: &str, locals: &str, code: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  <Program name=\"{name}\">\n{locals}    <Code><![CDATA[begin\n{code}end]]></Code>\n  </Program>\n</Programs>"
    )
}
