//! Variables of stopped tasks.

use expect_test::{Expect, expect};
use val3_debug::{
    AdvanceResult, Breakpoint, BreakpointId, Debugger, DisplayFormat, Inside, Stop, count, scopes, values,
};
use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_tests::running::Running;

/// Runs the application to its first line that prints in a program `show`.
fn stopped(listing: &str) -> (Controller, TaskNumber) {
    let mut debugger = Debugger::new(Running::start(listing).controller);
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let image = &application.image;
    let program = &image.programs[usize::from(image.program("show").unwrap())];
    let (file, row) = (image.files[program.file as usize].clone(), program.lines.last().unwrap().row);
    debugger.set_breakpoints(&file, vec![Breakpoint::new(BreakpointId(0), row)]);
    for _ in 0..1000 {
        if let AdvanceResult::Stopped(Stop::Breakpoints { task, .. }) = debugger.advance() {
            return (debugger.controller, task);
        }
    }
    panic!("it does not stop: {:?}", debugger.controller.devices.take_events());
}

/// Appends a value and all nested values, indented.
fn tree(controller: &mut Controller, inside: &Inside, indent: usize, text: &mut String) {
    let all = count(&mut controller.vm, inside);
    for value in values(controller, inside, 0..all, DisplayFormat::default()) {
        let refers_to = value.refers_to.map_or_else(String::new, |name| format!(" -> {name}"));
        *text += &format!("{:indent$}{}{refers_to}: {} = {}\n", "", value.name, value.type_name, value.shown);
        // The fields of a transformation are in its text, and a father is listed under its own name.
        let is_shown = value.type_name != "trsf" && value.name != "father";
        if let Some(inside) = value.inside.filter(|_| is_shown) {
            tree(controller, &inside, indent + 2, text);
        }
    }
}

fn check(listing: &str, expected: Expect) {
    let (mut controller, task) = stopped(listing);
    let mut text = String::new();
    for scope in scopes(&controller.vm, task, 0) {
        text += &format!("{:?}\n", scope.kind);
        tree(&mut controller, &scope.inside, 2, &mut text);
    }
    expected.assert_eq(&text);
}

#[test]
fn parameters_locals_and_globals_are_shown() {
    check(
        r#"
num nCount
string sNames[2]
program start()
bool l_bSeen
begin
  nCount=3
  sNames[1]="bolt"
  call show(nCount,sNames,1.5)
end
program show(num& x_nTotal, string& x_sNames[], num x_nFactor)
num l_nGrid[2,2]
bool l_bDone
begin
  l_nGrid[1,0]=7
  x_nTotal=x_nTotal*x_nFactor
  ? "here"
end
"#,
        expect![[r#"
            Parameters
              x_nTotal -> nCount: num = 4.5
              x_sNames -> sNames: string[2] = 2 values
                [0]: string = ""
                [1]: string = "bolt"
              x_nFactor: num = 1.5
            Locals
              l_nGrid: num[2,2] = 4 values
                [0,0]: num = 0
                [0,1]: num = 0
                [1,0]: num = 7
                [1,1]: num = 0
              l_bDone: bool = false
            Globals
              nCount: num = 4.5
              sNames: string[2] = 2 values
                [0]: string = ""
                [1]: string = "bolt"
        "#]],
    );
}

#[test]
fn points_show_their_fields() {
    check(
        "program start()\nbegin\n  call show()\nend\nprogram show()\npoint l_pNear\nbegin\n  l_pNear.trsf={1,2,3,0,0,90}\n  ? \
         1\nend\n",
        expect![[r#"
            Parameters
            Locals
              l_pNear: point = {{1,2,3,0,0,90},{ssame,esame,wsame}}
                trsf: trsf = {1,2,3,0,0,90}
                config: config = {ssame,esame,wsame}
                  shoulder: shoulder = ssame
                  elbow: elbow = esame
                  wrist: wrist = wsame
                father:  = none
                world: trsf = error 162: point without reference
            Globals
        "#]],
    );
}

#[test]
fn each_frame_has_its_own_variables() {
    let (mut controller, task) = stopped(
        "program start()\nnum l_nOuter\nbegin\n  l_nOuter=4\n  call show(l_nOuter)\nend\nprogram show(num x_nInner)\nbegin\n  \
         ? x_nInner\nend\n",
    );
    for (depth, variables) in [(0, "x_nInner: num = 4\n"), (1, "l_nOuter: num = 4\n")] {
        let mut text = String::new();
        for scope in scopes(&controller.vm, task, depth) {
            tree(&mut controller, &scope.inside, 0, &mut text);
        }
        assert_eq!(text, variables);
    }
    assert!(scopes(&controller.vm, task, 2).is_empty());
}

#[test]
fn a_page_of_a_long_array_is_read_alone() {
    let (mut controller, task) = stopped(
        "num nMany[100000]\nprogram start()\nbegin\n  nMany[99999]=5\n  call show()\nend\nprogram show()\nbegin\n  ? 1\nend\n",
    );
    let globals = scopes(&controller.vm, task, 0).remove(2);
    let many = values(&mut controller, &globals.inside, 0..1, DisplayFormat::default()).remove(0);
    assert_eq!((many.type_name.as_str(), many.shown.as_str()), ("num[100000]", "100000 values"));
    let inside = many.inside.unwrap();
    let page = values(&mut controller, &inside, 99_998..100_100, DisplayFormat::default());
    let shown: Vec<_> = page.iter().map(|value| format!("{}={}", value.name, value.shown)).collect();
    assert_eq!(shown, ["[99998]=0", "[99999]=5"]);
}

#[test]
fn collections_and_user_types_are_shown_by_keys_and_fields() {
    check(
        r#"
type Slot "Disk://Slot/Slot.pjx"
Slot tSlots["left","right"]
num nOnly["a"]
program start()
begin
  tSlots["right"].nCount=3
  tSlots["right"].sNames[1]="x"
  call show()
end
program show()
begin
  ? 1
end
--- Slot
public num nCount
public string sNames[2]
"#,
        expect![[r#"
            Parameters
            Locals
            Globals
              tSlots: Slot[""] = 2 values
                ["left"]: Slot = {nCount=0, sNames=…}
                  nCount: num = 0
                  sNames: string[2] = 2 values
                    [0]: string = ""
                    [1]: string = ""
                ["right"]: Slot = {nCount=3, sNames=…}
                  nCount: num = 3
                  sNames: string[2] = 2 values
                    [0]: string = ""
                    [1]: string = "x"
              nOnly: num[""] = 1 value
                ["a"]: num = 0
        "#]],
    );
}

#[test]
fn references_show_the_variables_that_they_refer_to() {
    check(
        r#"
type Slot "Disk://Slot/Slot.pjx"
num nGrid[2,3]
point pHome["left","right"]
Slot tSlots[2]
program start()
num l_nOwn
trsf l_trOwn
num l_nRow[4]
begin
  call middle(nGrid[1,2],pHome["right"].trsf.y,l_nOwn,l_trOwn.rz,l_nRow[1],tSlots[1].nMany[2],tSlots[1],tSlots)
end
program middle(num& x_nA, num& x_nB, num& x_nC, num& x_nD, num& x_nE, num& x_nF, Slot& x_tG, Slot& x_tH[])
begin
  call show(x_nA,x_nB,x_nC,x_nD,x_nE,x_nF,x_tG,x_tH)
end
program show(num& x_nA, num& x_nB, num& x_nC, num& x_nD, num& x_nE, num& x_nF, Slot& x_tG, Slot& x_tH[])
begin
  ? 1
end
--- Slot
public num nMany[3]
"#,
        expect![[r#"
            Parameters
              x_nA -> nGrid[1,2]: num = 0
              x_nB -> pHome["right"].trsf.y: num = 0
              x_nC -> l_nOwn: num = 0
              x_nD -> l_trOwn.rz: num = 0
              x_nE -> l_nRow[1]: num = 0
              x_nF -> tSlots[1].nMany[2]: num = 0
              x_tG -> tSlots[1]: Slot = {nMany=…}
                nMany: num[3] = 3 values
                  [0]: num = 0
                  [1]: num = 0
                  [2]: num = 0
              x_tH -> tSlots: Slot[2] = 2 values
                [0]: Slot = {nMany=…}
                  nMany: num[3] = 3 values
                    [0]: num = 0
                    [1]: num = 0
                    [2]: num = 0
                [1]: Slot = {nMany=…}
                  nMany: num[3] = 3 values
                    [0]: num = 0
                    [1]: num = 0
                    [2]: num = 0
            Locals
            Globals
              nGrid: num[2,3] = 6 values
                [0,0]: num = 0
                [0,1]: num = 0
                [0,2]: num = 0
                [1,0]: num = 0
                [1,1]: num = 0
                [1,2]: num = 0
              pHome: point[""] = 2 values
                ["left"]: point = {{0,0,0,0,0,0},{ssame,esame,wsame}}
                  trsf: trsf = {0,0,0,0,0,0}
                  config: config = {ssame,esame,wsame}
                    shoulder: shoulder = ssame
                    elbow: elbow = esame
                    wrist: wrist = wsame
                  father: frame = world
                  world: trsf = {0,0,0,0,0,0}
                ["right"]: point = {{0,0,0,0,0,0},{ssame,esame,wsame}}
                  trsf: trsf = {0,0,0,0,0,0}
                  config: config = {ssame,esame,wsame}
                    shoulder: shoulder = ssame
                    elbow: elbow = esame
                    wrist: wrist = wsame
                  father: frame = world
                  world: trsf = {0,0,0,0,0,0}
              tSlots: Slot[2] = 2 values
                [0]: Slot = {nMany=…}
                  nMany: num[3] = 3 values
                    [0]: num = 0
                    [1]: num = 0
                    [2]: num = 0
                [1]: Slot = {nMany=…}
                  nMany: num[3] = 3 values
                    [0]: num = 0
                    [1]: num = 0
                    [2]: num = 0
        "#]],
    );
}

#[test]
fn positions_show_their_fathers_and_where_they_are() {
    check(
        r#"
frame fCell
frame fTable
tool tGripper
tool tJaw
point pPick
program start()
begin
  fCell.trsf={100,0,0,0,0,0}
  fTable.trsf={0,10,0,0,0,90}
  pPick.trsf={1,2,3,0,0,0}
  tGripper.trsf.z=100
  tJaw.trsf.z=20
  link(fCell,world)
  link(fTable,fCell)
  link(pPick,fTable)
  link(tGripper,flange)
  link(tJaw,tGripper)
  call show()
end
program show()
begin
  ? 1
end
"#,
        expect![[r#"
            Parameters
            Locals
            Globals
              fCell: frame = {{100,0,0,0,0,0}}
                trsf: trsf = {100,0,0,0,0,0}
                father: frame = world
                world: trsf = {100,0,0,0,0,0}
              fTable: frame = {{0,10,0,0,0,90}}
                trsf: trsf = {0,10,0,0,0,90}
                father: frame = fCell -> world
                world: trsf = {100,10,0,0,0,90}
              tGripper: tool = {{0,0,100,0,0,0},,0,0}
                trsf: trsf = {0,0,100,0,0,0}
                gripper: dio = not linked
                otime: num = 0
                ctime: num = 0
                father: tool = flange
                flange: trsf = {0,0,100,0,0,0}
              tJaw: tool = {{0,0,20,0,0,0},,0,0}
                trsf: trsf = {0,0,20,0,0,0}
                gripper: dio = not linked
                otime: num = 0
                ctime: num = 0
                father: tool = tGripper -> flange
                flange: trsf = {0,0,120,0,0,0}
              pPick: point = {{1,2,3,0,0,0},{ssame,esame,wsame}}
                trsf: trsf = {1,2,3,0,0,0}
                config: config = {ssame,esame,wsame}
                  shoulder: shoulder = ssame
                  elbow: elbow = esame
                  wrist: wrist = wsame
                father: frame = fTable -> fCell -> world
                world: trsf = {98,11,3,0,0,90}
        "#]],
    );
}

#[test]
fn expressions_lead_to_each_value() {
    let (mut controller, task) = stopped(
        r#"
type Slot "Disk://Slot/Slot.pjx"
num nHidden
point pMany[2]
Slot tSlots["left"]
program start()
begin
  call show(tSlots)
end
program show(Slot& x_tSlots[""])
num nHidden
num l_nGrid[2,2]
begin
  ? 1
end
--- Slot
public trsf trAt[2]
"#,
    );
    let mut found = String::new();
    for scope in scopes(&controller.vm, task, 0) {
        let all = count(&mut controller.vm, &scope.inside);
        for mut value in values(&mut controller, &scope.inside, 0..all, DisplayFormat::default()) {
            found += &format!("{:?}", value.path);
            while let Some(inside) = value.inside.take() {
                let last = count(&mut controller.vm, &inside) - 1;
                let last = last.min(1);
                value = values(&mut controller, &inside, last..last + 1, DisplayFormat::default()).remove(0);
                found += &format!(" {}", value.path.as_deref().unwrap_or("-"));
            }
            found.push('\n');
        }
    }
    expect![[r#"
        Some("x_tSlots") x_tSlots["left"] x_tSlots["left"].trAt x_tSlots["left"].trAt[1] x_tSlots["left"].trAt[1].y
        Some("nHidden")
        Some("l_nGrid") l_nGrid[0,1]
        None
        Some("pMany") pMany[1] pMany[1].config pMany[1].config.elbow
        Some("tSlots") tSlots["left"] tSlots["left"].trAt tSlots["left"].trAt[1] tSlots["left"].trAt[1].y
    "#]]
    .assert_eq(&found);
}

#[test]
fn whole_numbers_are_shown_in_hexadecimal() {
    let (mut controller, task) = stopped(
        "num nMask\nnum nPart\nprogram start()\nbegin\n  nMask=255\n  nPart=0.5\n  call show()\nend\nprogram show()\nbegin\n  ? 1\nend\n",
    );
    let globals = scopes(&controller.vm, task, 0).remove(2);
    let shown: Vec<_> =
        values(&mut controller, &globals.inside, 0..2, DisplayFormat { hex: true, ..DisplayFormat::default() })
            .into_iter()
            .map(|value| value.shown)
            .collect();
    assert_eq!(shown, ["0xFF", "0.5"]);
}
