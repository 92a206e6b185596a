//! The library `io` of s5 and s6, whose data are the cell's signals without a link in their file.

use crate::support::Folder;

const CELL: &str = r#"
version s6.8
library io "Disk://io/io.pjx"
program start()
begin
  wait(io:bIn2)
  io:bOut7=io:bIn2
  wait(io:bOut7)
  io:valve1=true
  putln("done")
end

=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<dataList xmlns="DataNameSpace" />
=== io/io.pjx
<?xml version="1.0" encoding="utf-8"?>
<project xmlns="ProjectNameSpace"><parameters version="s6.8" stackSize="0" millimeterUnit="true" /><programSection />
<dataSection><data file="io.dtx" /></dataSection><aliasSection /></project>
=== io/io.dtx
<?xml version="1.0" encoding="utf-8"?>
<dataList xmlns="DataNameSpace"><dioSection><dio name="bIn2" public="true" size="1" /><dio name="bOut7" public="true" size="1" />
<dio name="valve1" public="true" size="1" /></dioSection><sioSection><sio name="host" public="true" size="1" /></sioSection></dataList>
"#;

const BOARD: &str =
    r#"<bio><bioDin index="2" name="bIn2" mode="notInverted" /><bioDout index="7" name="bOut7" /></bio>"#;

const SCRIPT: &str = "[[at]]\nt = 1\nio = { 'bIn2' = true }\n";

fn signals(folder: &Folder) -> Vec<String> {
    folder.write("operator.toml", SCRIPT);
    let run = folder.val3(&["run", "usrapp/main", "--script", "operator.toml", "--until", "5", "--events", "e.jsonl"]);
    assert_eq!(run.code, 0, "{run:?}");
    let events = folder.read("e.jsonl");
    let links = events.lines().filter(|line| line.contains(r#""kind":"io""#));
    let event = |line: &str| -> serde_json::Value { serde_json::from_str(line).unwrap() };
    links.map(event).map(|event| format!("{}={}", event["link"].as_str().unwrap(), event["value"])).collect()
}

#[test]
fn signals_have_the_names_of_the_board() {
    let folder = Folder::with(CELL);
    folder.write("configs/bio.cfx", BOARD);
    assert_eq!(signals(&folder), [r"BasicIO-1\%I2=1.0", r"BasicIO-1\%Q7=1.0", "valve1=1.0"]);
}

#[test]
fn signals_without_a_board_are_simulated() {
    assert_eq!(signals(&Folder::with(CELL)), ["bIn2=1.0", "bOut7=1.0", "valve1=1.0"]);
}

#[test]
fn help_for_an_output_without_a_link_names_no_line() {
    let run = Folder::with("dio dOut\ndOut=true\n").val3(&["run"]);
    assert!(run.stderr.contains("error[123]") && !run.stderr.contains("--line"), "{run:?}");
}

#[test]
fn a_run_without_the_library_names_the_remedy() {
    let (before, rest) = CELL.split_once("=== io/io.pjx").unwrap();
    assert!(rest.contains("io.dtx"));
    let folder = Folder::with(before);
    let run = folder.val3(&["run", "usrapp/main", "--until", "5"]);
    let items = "a line that uses `io:bIn2`, `io:bOut7` or `io:valve1` stops its task with error 80\n";
    assert!(run.stderr.contains("note: the library `io` is missing") && run.stderr.contains(items), "{run:?}");
    let place = folder.path().join("usrapp/io");
    let help = format!("help: copy the folder `io` from the `usrapp` of the controller to `{}`, or", place.display());
    assert!(run.stderr.contains(&help), "{run:?}");
    assert!(run.stderr.contains("error[80]"), "{run:?}");
    let unused = Folder::with("version s6.8\nlibrary io \"Disk://io/io.pjx\"\nputln(\"done\")\n");
    assert!(!unused.val3(&["run", "usrapp/main"]).stderr.contains("is missing, whose items"));
}
