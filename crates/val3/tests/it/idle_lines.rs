//! Virtual time while a line is open without a peer.

use crate::support::Folder;

/// One task reads from a server with a timeout, another task sleeps, and an operator acts.
const CELL: &str = r#"
num nByte[10]
num nCount
dio dIn
program start()
begin
  taskCreate "other",10,other()
  sioCtrl(siHost,"timeout",0.35)
  for nCount=1 to 3
    ? sioGet(siHost,nByte)
    ? clock()
  endFor
  taskKill("other")
end
program other()
  num l_nRound
begin
  while true
    l_nRound=l_nRound+1
    delay(0.123)
    ? l_nRound
    wait(dIn or l_nRound>4)
  endWhile
end
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
    <Data name="dIn" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\in" /></Data>
    <Data name="nByte" access="private" xsi:type="array" type="num" size="10" />
    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
  </Datas>
</Database>
"#;

const SCRIPT: &str = "[[at]]\nt = 0.4\nio = { 'Io\\in' = true }\n";

fn run(folder: &Folder, options: &[&str], events: &str) -> String {
    let line = ["--line", r"Socket\host=server:0", "--script", "day.toml", "--events", events];
    let run = folder.val3(&[&["run", "usrapp/main"], &line[..], options].concat());
    assert_eq!(run.code, 0, "{run:?}");
    folder.read(events)
}

#[test]
fn skipped_time_changes_no_event() {
    let folder = Folder::with(CELL);
    folder.write("day.toml", SCRIPT);
    let skipped = run(&folder, &["--until", "60"], "skipped.jsonl");
    assert!(skipped.lines().count() > 10, "{skipped}");
    assert_eq!(skipped, run(&folder, &[], "cycles.jsonl"), "without an end each cycle is executed");
    let replayed = run(&folder, &["--until", "60", "--replay", "skipped.jsonl"], "replayed.jsonl");
    assert_eq!(skipped, replayed);
}
