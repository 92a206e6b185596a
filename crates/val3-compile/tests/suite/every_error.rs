//! Each run-time error number is raised by a program (12.1).

use std::ops::RangeInclusive;

use val3_lang::runtime_errors::RUNTIME_ERRORS;
use val3_machine::devices::Devices;
use val3_machine::event::EventKind;
use val3_machine::io::{Direction, Signal, SignalKind};

use crate::cell::{Cell, run};

/// Error numbers with lines that raise them.
const LINES: [(u16, &str); 24] = [
    (10, "nZero=1/nZero"),
    (11, "nZero=ln(nZero)"),
    (20, "nRow[nZero+2]=1"),
    (21, "nRow[nZero-1]=1"),
    (29, r#"taskCreate "no name",10,work()"#),
    (30, r#"taskSuspend("nobody")"#),
    (
        31,
        r#"taskCreate "one",10,work()
taskCreate "one",10,work()"#,
    ),
    (
        32,
        r#"taskCreateSync "a",0.004,bLate,work()
taskCreateSync "b",0.008,bLate,work()
taskCreateSync "c",0.016,bLate,work()"#,
    ),
    (40, "append(nFull)"),
    (41, "call deeper()"),
    (70, "resize(nRow,1,nZero)"),
    (80, "nZero=absent:nWeight"),
    (82, "call part:hang(pOwn)"),
    (
        90,
        r#"taskCreate "one",10,work()
taskSuspend("one")
taskResume("one",99)"#,
    ),
    (122, "io:dioInput=true"),
    (123, "dioFree=true"),
    (124, "io:dioSystem=true"),
    (125, "io:dioBroken=true"),
    (160, "flange.trsf.z=1\nl_trPart=position(tGrip,flange)"),
    (161, "world.trsf.z=1\nl_trPart=position(fTable,world)"),
    (162, "l_trPart=position(l_pPart,world)"),
    (163, "l_trPart=position(l_fPart,world)"),
    (164, "l_trPart=position(l_tPart,flange)"),
    (165, "link(fTable,l_fPart)"),
];

/// Numbers that no program in this suite raises: errors of moves and options, which the controller does not have yet,
/// and errors that programs do not cause.
const OTHERS: [(RangeInclusive<u16>, &str); 10] = [
    (35..=35, "an error of s8 when tasks record moves at the same time, which 12.1 lacks"),
    (50..=50, "the controller's own messages, which 12.1 lacks"),
    (60..=61, "faults of the interpreter"),
    (81..=81, "positions for another arm (9.2)"),
    (100..=106, "motion descriptors (10.5)"),
    (150..=154, "moves (10.6)"),
    (170..=171, "the controller's own messages, which 12.1 lacks"),
    (200..=200, "the controller's own messages, which 12.1 lacks"),
    (250..=250, "licences of options (11)"),
    (270..=999, "the controller's own messages, which 12.1 lacks"),
];

/// Declarations for the lines. `Io` is a device with an input, a system output and an output that fails.
const SURROUNDINGS: &str = r#"
library io "Disk://io/io.pjx"
library part "Disk://part/part.pjx"
library absent "Disk://part/part.pjx" autoload=false
num nZero
num nRow[2]
num nFull[9999]
bool bLate
dio dioFree
tool tGrip
frame fTable
point pOwn
program work()
begin
  delay(1)
end
program deeper()
begin
  call deeper()
end
program lines()
  trsf l_trPart
  point l_pPart
  frame l_fPart
  tool l_tPart
begin
LINES
end
program start()
begin
  taskCreate "lines",10,lines()
end
--- part
public num nWeight
frame fOwn
public program hang(point& x_pPoint)
begin
  link(x_pPoint,fOwn)
end
--- io
public dio dioInput
=== io/io.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="dioInput" access="public" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\in" /></Data>
    <Data name="dioSystem" access="public" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\system" /></Data>
    <Data name="dioBroken" access="public" xsi:type="array" type="dio" size="1"><Value key="0" link="Bus\out" /></Data>
  </Datas>
</Database>
"#;

fn connect(devices: &mut Devices) {
    devices.state.io.declare(Signal { direction: Direction::Input, ..output("Io\\in", false) });
    devices.state.io.declare(output("Io\\system", true));
    devices.state.io.declare(output("Bus\\out", false));
    devices.state.io.set_device_fault("Bus", Some(5));
}

fn output(path: &str, protected: bool) -> Signal {
    Signal {
        path: path.to_owned(),
        description: String::new(),
        kind: SignalKind::Digital,
        direction: Direction::Output,
        protected,
    }
}

/// Runs a program with these lines, and returns the first error.
fn error(lines: &str) -> Option<u16> {
    let cell = Cell::new(&SURROUNDINGS.replace("LINES", lines));
    let events = run(&mut cell.controller_with(connect), |_| {});
    events.into_iter().find_map(|event| match event.kind {
        EventKind::Error { code, .. } => Some(code),
        _ => None,
    })
}

#[test]
fn lines_raise_their_errors() {
    let raised: Vec<_> = LINES.iter().map(|(_, lines)| (error(lines), *lines)).collect();
    let wanted: Vec<_> = LINES.iter().map(|(number, lines)| (Some(*number), *lines)).collect();
    assert_eq!(raised, wanted);
    assert_eq!(error("nZero=nRow[1]"), None);
}

#[test]
fn every_number_is_raised_or_impossible() {
    for error in &RUNTIME_ERRORS {
        let raised = LINES.iter().any(|(number, _)| *number == error.number);
        let other = OTHERS.iter().find(|(numbers, _)| numbers.contains(&error.number));
        assert!(raised != other.is_some(), "{} {}: {other:?}", error.number, error.short);
    }
}
