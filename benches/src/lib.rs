//! Inputs for the benchmarks: a generated workspace, the same in every run.

use xtask::workspace::{self, Generated, GeneratedFile};

/// Generates a workspace with `lines` code lines.
pub fn generated(lines: usize) -> Generated {
    workspace::generate(lines, 1)
}

/// Returns all files of a workspace with this ending (`pgx`, `dtx`, `pjx`).
pub fn texts(workspace: &Generated, ending: &str) -> Vec<String> {
    let fits = |file: &&GeneratedFile| file.path.ends_with(ending);
    workspace.files.iter().filter(fits).map(|file| file.text.clone()).collect()
}

/// Returns a program of at least `bytes` bytes: the statements of a generated program, repeated.
pub fn long_program(bytes: usize) -> String {
    const HEAD: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
        <Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  \
        <Program name=\"long\">\n    <Code><![CDATA[begin\n";
    const STATEMENTS: &str = "  // one more layer\n  for l_i=0 to size(nLayer)-1\n    \
        if (pTray[l_i].trsf.z>120.5) and bReady\n      movej(appro(pTray[l_i],{0,0,-50,0,0,0}),tGripper,mFast)\n      \
        call logbook:note(2,\"layer \"+toString(\"\",l_i))\n    endIf\n  endFor\n";
    const TAIL: &str = "end]]></Code>\n  </Program>\n</Programs>";
    let times = bytes.div_ceil(STATEMENTS.len());
    [HEAD, &STATEMENTS.repeat(times), TAIL].concat()
}
