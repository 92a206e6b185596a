//! Variables of stopped tasks.

use expect_test::{Expect, expect};
use val3_debug::{Breakpoint, BreakpointId, Debugger, Format, Inside, Progress, Stop, count, scopes, values};
use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_tests::running::Running;

/// The application at its first line that prints in a program `show`.
fn stopped(listing: &str) -> (Controller, TaskNumber) {
    let mut debugger = Debugger::new(Running::start(listing).controller);
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let image = &application.image;
    let program = &image.programs[usize::from(image.program("show").unwrap())];
    let (file, row) = (image.files[program.file as usize].clone(), program.lines.last().unwrap().row);
    debugger.set_breakpoints(&file, vec![Breakpoint::new(BreakpointId(0), row)]);
    for _ in 0..1000 {
        if let Progress::Stopped(Stop::Breakpoints { task, .. }) = debugger.advance() {
            return (debugger.controller, task);
        }
    }
    panic!("it does not stop: {:?}", debugger.controller.devices.take_events());
}

/// A value with everything inside, indented.
fn tree(controller: &mut Controller, inside: &Inside, indent: usize, text: &mut String) {
    let all = count(&mut controller.vm, inside);
    for value in values(controller, inside, 0..all, Format::default()) {
        *text += &format!("{:indent$}{}: {} = {}\n", "", value.name, value.type_name, value.shown);
        if let Some(inside) = value.inside {
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
              x_nTotal: num = 4.5
              x_sNames: string[2] = 2 values
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
                  x: num = 1
                  y: num = 2
                  z: num = 3
                  rx: num = 0
                  ry: num = 0
                  rz: num = 90
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
    let names = |controller: &mut Controller, depth| {
        let mut text = String::new();
        for scope in scopes(&controller.vm, task, depth) {
            tree(controller, &scope.inside, 0, &mut text);
        }
        text
    };
    assert_eq!(names(&mut controller, 0), "x_nInner: num = 4\n");
    assert_eq!(names(&mut controller, 1), "l_nOuter: num = 4\n");
    assert!(scopes(&controller.vm, task, 2).is_empty());
}

#[test]
fn a_page_of_a_long_array_is_read_alone() {
    let (mut controller, task) = stopped(
        "num nMany[100000]\nprogram start()\nbegin\n  nMany[99999]=5\n  call show()\nend\nprogram show()\nbegin\n  ? 1\nend\n",
    );
    let globals = scopes(&controller.vm, task, 0).remove(2);
    let many = values(&mut controller, &globals.inside, 0..1, Format::default()).remove(0);
    assert_eq!((many.type_name.as_str(), many.shown.as_str()), ("num[100000]", "100000 values"));
    let inside = many.inside.unwrap();
    let page = values(&mut controller, &inside, 99_998..100_100, Format::default());
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
