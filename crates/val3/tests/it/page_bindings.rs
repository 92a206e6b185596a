//! Bindings of user pages (`interface/<page>.bindings.json`) in `val3 check`.

use crate::support::Folder;

const APPLICATION: &str = r#"
version s8.10
type Slot "Disk://Slot/Slot.pjx"
num nCount
point pPick
Slot tSlot[2]
dio diDoor
num nSpeed[3]
num nGrown[1]
program start()
begin
  nCount=userPage("main")
  nCount=userPage("mian")
  resize(nGrown,1,8)
  ? nSpeed[0]+nGrown[0]
end
program clkReset()
begin
  nCount=0
end
program setTo(num x_n)
begin
  nCount=x_n
end

=== main/interface/main.html
<html><body><label id="lblCount"></label><button id="btnReset"/>
<!-- <p id="lblOld"/> --><p id="btnStop"/><p id="btnStop"/><p id="free"/><p id="free"/></body></html>
--- Slot
public num nHeight
public trsf trPlace
"#;

fn findings(bindings: &str) -> String {
    let folder = Folder::with(APPLICATION);
    folder.write("usrapp/main/interface/main.bindings.json", bindings);
    let run = folder.val3(&["check", "--format", "concise"]);
    run.stdout.lines().filter(|line| line.contains("V0560")).map(|line| format!("{line}\n")).collect()
}

#[test]
fn names_that_lead_nowhere_are_found_at_their_places() {
    let data = |path: &str| format!(r#"{{"id":"lblCount","attribute":"innerHTML","data":"{path}","direction":"r"}}"#);
    let data = ["nCount[0]", "nSpeed[2]", "nGrown[7]", "nSpeed[3]", "nSped[0]"].map(data).join(",\n");
    let callback = |id: &str, program: &str| format!(r#"{{"id":"{id}","event":"click","data":"{program}"}}"#);
    let callbacks = [("btnReset", "clkReset"), ("btnReste", "clkRest"), ("btnReset", "setTo")];
    let callbacks = callbacks.map(|(id, program)| callback(id, program)).join(",\n");
    let text = format!("{{\"version\":\"1.0\",\"bindings\":[\n{data}],\n\"callbacks\":[\n{callbacks}],\"events\":[]}}");
    expect_test::expect![[r#"
        usrapp/main/interface/main.bindings.json:5:50: warning[V0560] `nSpeed` has no element `[3]`
        usrapp/main/interface/main.bindings.json:6:50: warning[V0560] the application has no data `nSped`
        usrapp/main/interface/main.bindings.json:9:8: warning[V0560] the page has no element with the id `btnReste`
        usrapp/main/interface/main.bindings.json:9:42: warning[V0560] the application has no program `clkRest`
        usrapp/main/interface/main.bindings.json:10:42: warning[V0560] the page calls `setTo` without arguments, but the program has parameters
        usrapp/main/start.pgx:6:19: warning[V0560] the application has no page `mian`
    "#]].assert_eq(&findings(&text));
}

#[test]
fn a_file_that_is_no_json_is_found() {
    expect_test::expect![[r#"
        usrapp/main/interface/main.bindings.json:1:3: warning[V0560] the bindings of this page are no JSON: a string is expected
        usrapp/main/start.pgx:6:19: warning[V0560] the application has no page `mian`
    "#]].assert_eq(&findings("{ broken"));
}

#[test]
fn the_type_of_data_suits_an_attribute() {
    let data = |path: &str| format!(r#"{{"id":"lblCount","attribute":"innerHTML","data":"{path}","direction":"r"}}"#);
    let paths = ["pPick[0]", "tSlot[1]", "tSlot[1].trPlace", "tSlot[1].nHigth[0]", "tSlot[1].nHeight[1]"];
    let silent = ["tSlot[1].nHeight[0]", "diDoor", "pPick[0].trsf.x", "part:pPick[0]", "nCount"];
    let data = paths.into_iter().chain(silent).map(data).collect::<Vec<_>>().join(",\n");
    expect_test::expect![[r#"
        usrapp/main/interface/main.bindings.json:2:50: warning[V0560] the attribute `innerHTML` has one value, and `pPick[0]` is a value of the type `pointRx`
        usrapp/main/interface/main.bindings.json:3:50: warning[V0560] the attribute `innerHTML` has one value, and `tSlot[1]` is a value of the type `Slot`
        usrapp/main/interface/main.bindings.json:4:50: warning[V0560] the attribute `innerHTML` has one value, and `tSlot[1].trPlace` is a value of the type `trsf`
        usrapp/main/interface/main.bindings.json:5:50: warning[V0560] the type `Slot` has no field `nHigth`
        usrapp/main/interface/main.bindings.json:6:50: warning[V0560] `nHeight` has no element `[1]`
        usrapp/main/start.pgx:6:19: warning[V0560] the application has no page `mian`
    "#]].assert_eq(&findings(&format!("{{\"bindings\":[\n{data}]}}")));
}

#[test]
fn an_element_has_an_id_of_its_own() {
    let ids =
        ["btnStop", "lblOld", "lblCount"].map(|id| format!(r#"{{"id":"{id}","event":"click","data":"clkReset"}}"#));
    expect_test::expect![[r#"
        usrapp/main/interface/main.bindings.json:3:8: warning[V0560] the page has no element with the id `lblOld`
        usrapp/main/interface/main.html:2:50: warning[V0560] two elements of the page have the id `btnStop`
        usrapp/main/start.pgx:6:19: warning[V0560] the application has no page `mian`
    "#]]
    .assert_eq(&findings(&format!("{{\"callbacks\":[\n{}]}}", ids.join(",\n"))));
}
