//! Opening and closing of tools while the arm is at rest (9.5.4).

use val3_lang::types::BaseType;
use val3_machine::devices::Devices;
use val3_machine::io::{Direction, Signal, SignalKind};
use val3_tests::running::Running;

/// Tools on the signals of the device `Io`, each named after its purpose.
const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doValve" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\valve1" /></Data>
    <Data name="tHand" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" z="50" fatherId="flange[0]" ioLink="Io\valve1" ioOpen="0.5" ioClose="0.25" />
    </Data>
    <Data name="tAtOnce" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" fatherId="flange[0]" ioLink="Io\valve1" />
    </Data>
    <Data name="tInput" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" fatherId="flange[0]" ioLink="Io\in" />
    </Data>
    <Data name="tSystem" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" fatherId="flange[0]" ioLink="Io\system" />
    </Data>
    <Data name="tNone" access="private" xsi:type="array" type="tool" size="1"><Value key="0" fatherId="flange[0]" /></Data>
  </Datas>
</Database>
"#;

fn devices() -> Devices {
    let mut devices = Running::devices();
    devices.state.io.declare_device("Io", ["valve1"].map(|name| (name, BaseType::Dio)));
    for (path, direction, protected) in [("Io\\in", Direction::Input, false), ("Io\\system", Direction::Output, true)] {
        let (path, description) = (path.to_owned(), String::new());
        devices.state.io.declare(Signal { path, description, kind: SignalKind::Digital, direction, protected });
    }
    devices
}

#[track_caller]
fn run(body: &str) -> Running {
    Running::on(devices(), &format!("{}\n{DATA}", program(body))).to_the_end()
}

/// Returns the lines as the program `start`, unless they are programs themselves.
fn program(body: &str) -> String {
    match body.starts_with("program") {
        true => body.to_owned(),
        false => format!("program start()\n  num l_nStart\nbegin\n{body}\nend"),
    }
}

#[track_caller]
fn check(body: &str, printed: &str) {
    assert_eq!(run(body).printed(), printed, "{body}");
}

/// `waitEndMove`, the output, then `delay`, as the manual describes both instructions.
#[test]
fn the_output_is_set_and_the_time_of_the_tool_passes() {
    let running = run("  l_nStart=clock()\n  open(tHand)\n  ? clock()-l_nStart>=0.5 and clock()-l_nStart<0.51\n  \
                       ? doValve==true\n  l_nStart=clock()\n  close(tHand)\n  ? clock()-l_nStart>=0.25 and clock()-l_nStart<0.26\n  \
                       ? doValve==true");
    assert_eq!(running.printed(), "true\ntrue\ntrue\nfalse\n");
    let record = running.record();
    let written: Vec<&str> = record.lines().filter(|line| line.contains("valve1")).collect();
    assert!(
        matches!(written[..], [opened, closed] if opened.ends_with("1.0}") && closed.ends_with("0.0}")),
        "{record}"
    );
}

/// After it is set, the output can be changed by the program again.
#[test]
fn the_output_is_set_once() {
    check(
        "program other()\nbegin\n  delay(0.1)\n  doValve=false\nend\nprogram start()\nbegin\n  \
         taskCreate \"other\",100,other()\n  open(tHand)\n  ? doValve==true\nend",
        "false\n",
    );
}

#[test]
fn no_time_passes_the_turn_once() {
    check(
        "program other()\nbegin\n  ? \"other\"\nend\nprogram start()\nbegin\n  taskCreate \"other\",100,other()\n  \
         open(tAtOnce)\n  ? \"open\"\n  close(tAtOnce)\n  ? doValve==true\nend",
        "other\nopen\nfalse\n",
    );
}

#[test]
fn the_time_is_a_field_of_the_tool() {
    check(
        "  tHand.otime=2\n  l_nStart=clock()\n  open(tHand)\n  ? clock()-l_nStart>=2\n  \
         dioLink(tNone.gripper,tHand.gripper)\n  open(tNone)\n  ? tNone.gripper==true",
        "true\ntrue\n",
    );
}

#[test]
fn tools_without_output_are_errors() {
    for (tool, code) in [("tNone", 123), ("tInput", 122), ("tSystem", 124)] {
        check(&format!("  open({tool})"), &format!("error {code}\n"));
        check(&format!("  close({tool})"), &format!("error {code}\n"));
    }
}

/// In s5 and s6 a tool names the gripper's `dio`: in a library, or by the controller's name for the signal.
#[test]
fn a_tool_of_the_old_dialect_sets_its_output() {
    let tool = |alias: &str, name: &str| {
        format!(
            "<toolSection><tool name=\"tHand\" public=\"false\"><tFather alias=\"\" name=\"flange\" fatherIndex=\"0\" />\
             <valueTool index=\"0\"><ttValue x=\"0\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\" />\
             <io alias=\"{alias}\" name=\"{name}\" ioIndex=\"0\" open=\"0.5\" close=\"0.25\" /></valueTool></tool>\
             </toolSection>"
        )
    };
    let opened = |alias: &str, name: &str| {
        let data = tool(alias, name);
        let listing = format!(
            "version s6.8\n{}\n=== main/main.dtx\n<?xml version=\"1.0\"?>\n\
             <dataList xmlns=\"DataNameSpace\">{data}</dataList>\n",
            program("  l_nStart=clock()\n  open(tHand)\n  ? clock()-l_nStart>=0.5\n  ? tHand.gripper==true")
        );
        Running::on(devices(), &listing).to_the_end()
    };
    for alias in ["io", ""] {
        let running = opened(alias, "valve1");
        assert_eq!(running.printed(), "true\ntrue\n", "{alias}");
        assert!(running.record().contains("valve1"), "{}", running.record());
    }
    assert_eq!(opened("", "").printed(), "error 123\n");
}
