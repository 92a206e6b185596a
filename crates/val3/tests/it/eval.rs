//! `val3 eval`.

use std::io::Write as _;
use std::process::Stdio;

use crate::support::{CLEAN, Folder};

/// Output of an evaluation, followed by the exit code.
fn answers(arguments: &[&str]) -> String {
    let run = Folder::empty().val3(&[&["eval"], arguments].concat());
    format!("{}{}{}", run.stdout, run.stderr, run.code)
}

#[test]
fn values_are_shown() {
    assert_eq!(answers(&["1+2*3", "\"a\"+\"b\"", "1<2"]), "7\n\"ab\"\ntrue\n0");
}

#[test]
fn texts_share_their_variables() {
    assert_eq!(answers(&["--local", "num nVal", "nVal=4", "nVal=nVal*2", "nVal"]), "8\n0");
}

#[test]
fn texts_declare_variables() {
    assert_eq!(answers(&["num nA", "nA", "nA=nA+2", "string sB", "nA", "sB"]), "0\n2\n\"\"\n0");
    assert_eq!(answers(&["num nA = 2", "num nB=nA*2, nC", "nB+nC", "trsf t={1,2,3}", "t.y"]), "4\n2\n0");
    assert_eq!(answers(&["point pA[3]", "size(pA)", "num nM[2,4]", "nM[1,3]=5", "nM[1,3]"]), "3\n5\n0");
    assert_eq!(answers(&["num nA=2", "num nA", "nA", "string nA", "nA"]), "0\n\"\"\n0", "declared again");
}

#[test]
fn faulty_declarations_are_explained() {
    let shown = answers(&["num nA=7", "num if", "num nB=nX", "num nA[2]=3", "nA"]);
    assert!(shown.starts_with("error: "), "{shown}");
    assert!(shown.contains("  num nB=nX\n         ^^"), "{shown}");
    assert!(shown.contains("`nA` has several values") && shown.contains("\n7\n"), "{shown}");
    assert!(shown.ends_with('1'), "{shown}");
}

#[test]
fn user_types_can_be_declared() {
    let folder =
        Folder::with("type Slot \"Disk://Slot/Slot.pjx\"\nnum nCount\nnCount=1\n--- Slot\npublic num nRow=4\n");
    let run = folder.val3(&["eval", "--app", "usrapp/main", "Slot slA", "slA.nRow", "num nCount"]);
    assert_eq!((run.code, run.stdout.lines().next()), (1, Some("4")), "{run:?}");
    assert!(run.stdout.contains("error: ") && run.stdout.contains("nCount"), "the application has it: {run:?}");
}

#[test]
fn commands_are_executed() {
    assert_eq!(answers(&["1", "exit", "2"]), "1\n0");
    assert_eq!(answers(&["1/0", "quit", "2"]), "error 10: division by zero\n1");
    assert!(answers(&["help"]).contains("declare variables"));
    assert_eq!(answers(&["num help=4", "help"]), "4\n0", "a variable has priority");
}

#[test]
fn pasted_lines_are_separate_texts() {
    let pasted = "num nSum\nfor nSum=1 to 3\n  ? nSum\nendFor\n\nnSum*2\r\n\"end\"\n";
    assert_eq!(answers(&[pasted]), "1\n2\n3\n8\n\"end\"\n0");
}

#[test]
fn a_block_continues_in_the_next_arguments() {
    assert_eq!(answers(&["num nI", "for nI=1 to 2", "  ? nI", "endFor", "nI"]), "1\n2\n3\n0");
    let shown = answers(&["if true", "? 1"]);
    assert!(shown.contains("`if` has no `endIf`") && shown.ends_with('1'), "{shown}");
}

#[test]
fn text_on_the_user_page_is_output() {
    assert_eq!(answers(&["put(\"n=\")", "put(\"n=\")\nputln(12)", "cls()", "putln(\"\")"]), "n=\nn=\n12\n\n0");
    assert_eq!(
        answers(&["if true", "put(\"n=\")", "putln(1/4)", "put(1/0)", "endIf"]),
        "n=0.25\nerror 10: division by zero\n1"
    );
}

#[test]
fn braces_can_be_multiplied() {
    assert_eq!(answers(&["{1,2,3,0,0,0}*{0,0,10,0,0,0}"]), "{1,2,13,0,0,0}\n0");
    assert_eq!(answers(&["{0,0,0,0,0,90}*{1,0,0}*{0,0,4}"]), "{0,1,4,0,0,90}\n0");
    assert!(answers(&["{1,2}+{3,4}"]).contains("error: "));
}

/// A variable of a program has its declared sizes and the initial values of the manual (2.3, 9.4 to 10.5).
#[test]
fn variables_of_every_container_and_type() {
    let locals =
        ["num nGrid[2,3]", "num nCube[2,3,4]", "num nNames[\"\"]", "mdesc mMove", "frame fTable", "tool tHand"];
    let texts = [
        "nGrid[1,2]=7",
        "nGrid[1,2]",
        "nGrid[2,0]",
        "size(nCube,3)",
        "size(nNames)",
        "mMove",
        "position(fTable,world)",
        "position(tHand,flange)",
    ];
    let arguments: Vec<&str> = locals.iter().flat_map(|local| ["--local", *local]).chain(texts).collect();
    assert_eq!(
        answers(&arguments),
        "7\nerror 20: index too large\n4\n0\n{100,100,100,9999,9999,joint,50,50}\n\
         error 163: frame without reference\nerror 164: tool without reference\n1"
    );
}

#[test]
fn the_application_with_start_is_chosen() {
    let folder = Folder::with("num nCount=3\nreturn\n--- part\npublic num nParts\nprogram drop()\nbegin\nend");
    let run = folder.val3(&["eval", "--app", "usrapp", "nCount"]);
    assert_eq!(run.stdout, "3\n", "{run:?}");
}

#[test]
fn evaluation_continues_after_a_faulty_text() {
    insta::assert_snapshot!(answers(&["1/0", "sqrt(-1)", "2+", "\"a\"+1", "nNothing", "5"]));
}

#[test]
fn texts_can_use_the_data_of_an_application() {
    let folder = Folder::with(CLEAN);
    let run = folder.val3(&["eval", "--app", "usrapp/main", "nCount", "nCount=nCount+2", "nCount"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "0\n2\n"), "{run:?}");
}

/// Expressions for all external state of a program.
const WORLD: [&str; 13] = [
    "getLanguage()",
    "getVersion(\"ArmType\")",
    "getVersion(\"alter\")",
    "getProfile()",
    "getMonitorSpeed()",
    "getDate(\"%Y-%m-%d\")",
    "ioStatus(dKnown)",
    "ioStatus(dUnknown)",
    "libList(\"USB0://\",sNames)",
    "sNames[0]",
    "part:libExist(\"nParts\")",
    "part:nParts",
    "sioCtrl(siHost,\"port\",2000)",
];

/// A cell with all the files that an application accesses on a controller.
fn cell() -> Folder {
    let lines: Vec<String> = WORLD.iter().map(|text| format!("?{text}")).collect();
    let folder = Folder::with(&format!(
        "dio dKnown\ndio dUnknown\nsio siHost\nstring sNames[1]\n\
         library part \"Disk://part/part.pjx\"\n{}\n\
         --- part\npublic num nParts = 7\n\
         === /configs/cell.cfx\n<cell><String name=\"language\" value=\"suomi\" /></cell>\n\
         === /configs/arm.cfx\n<arm><String name=\"arm\" value=\"tx2-90l\" /></arm>\n",
        lines.join("\n")
    ));
    folder.link("dKnown", "BasicIO-1\\%I0");
    folder.link("siHost", "Socket\\host");
    folder.write(
        "val3.toml",
        "roots = { USB0 = \"stick\" }\n[run]\nmonitor-speed = 40\nprofile = \"operator\"\n\
         licences = { alter = \"demo\" }\nlines = { 'Socket\\host' = \"server:0\" }\n",
    );
    folder.write("stick/note.txt", "");
    folder
}

#[test]
fn an_expression_has_the_value_that_it_has_in_a_run() {
    let folder = cell();
    for options in [&[][..], &["--monitor-speed", "30", "--date", "2007-01-01T13:45:23", "--root", "USB0=usrapp"]] {
        let run = folder.val3(&[&["run"], options, &["usrapp/main"]].concat());
        let eval = folder.val3(&[&["eval", "--app", "usrapp/main"], options, &WORLD].concat());
        assert_eq!((run.code, eval.code), (0, 0), "{run:?} {eval:?}");
        assert_eq!(eval.stdout.replace('"', ""), run.stdout);
        insta::assert_snapshot!(eval.stdout);
    }
}

#[test]
fn lines_of_the_standard_input_are_evaluated() {
    let folder = Folder::empty();
    let mut command = folder.command(&["eval"]);
    command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(b"1+1\n\nif true\n? 2+2\nendIf\n1/0\nexit\n5\n").unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(String::from_utf8(output.stdout).unwrap(), "2\n4\nerror 10: division by zero\n");
}

#[test]
fn wrong_usage_is_refused() {
    for (arguments, word) in [
        (&["eval", "--app", "no/such", "1"][..], "no/such"),
        (&["eval", "--local", "number n", "1"], "number"),
        (&["eval", "--arm", "none", "1"], "none"),
    ] {
        let run = Folder::empty().val3(arguments);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?} {run:?}");
        assert!(run.stderr.contains(word), "{arguments:?} {run:?}");
    }
}
