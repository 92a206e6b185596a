//! Displayed values: their expressions, assignments to them, inputs and outputs.

use expect_test::expect;
use val3_debug::{DebugValue, DisplayFormat, Inside, count, scopes, values};
use val3_lang::types::BaseType;
use val3_session::Purpose;
use val3_tests::running::Running;

use crate::stopped::Stopped;

const LISTING: &str = r#"
library part "Disk://part/part.pjx"
type Slot "Disk://Slot/Slot.pjx"
num nCount
point pMany[2]
Slot tSlots["left"]
num nGrid[2,2]
program start()
begin
  call show(nCount,pMany)
end
program show(num& x_nTotal, point& x_pMany[])
num nCount
trsf l_trAt
begin
  ? "here"
end
--- Slot
public num nSize
public string sNames[2]
--- part
public num nWeight
num nSecret
"#;

/// All children of a value.
fn children(stopped: &mut Stopped, inside: &Inside) -> Vec<DebugValue> {
    let all = count(&mut stopped.debugger.controller.vm, inside);
    values(&mut stopped.debugger.controller, inside, 0..all, DisplayFormat::default())
}

/// All values of the scopes and their children, if their names pass.
fn all_values(stopped: &mut Stopped) -> Vec<(Inside, DebugValue)> {
    let mut open: Vec<Inside> =
        scopes(&stopped.debugger.controller.vm, stopped.task, 0).into_iter().map(|scope| scope.inside).collect();
    let mut found = Vec::new();
    while let Some(inside) = open.pop() {
        for value in children(stopped, &inside) {
            open.extend(value.inside.clone().filter(|_| value.name != "father"));
            found.push((inside.clone(), value));
        }
    }
    found
}

#[test]
fn the_expression_of_a_value_yields_it() {
    let mut stopped = Stopped::on_disk(LISTING);
    let mut evaluated = 0;
    for (_, value) in all_values(&mut stopped) {
        let Some(path) = &value.path else { continue };
        let again = stopped.evaluate(0, path, Purpose::Watch).unwrap().value.unwrap();
        assert_eq!((again.type_name, again.shown), (value.type_name, value.shown), "{path}");
        evaluated += 1;
    }
    assert!(evaluated > 50, "{evaluated}");
}

#[test]
fn each_number_that_is_shown_can_be_assigned_to() {
    let mut stopped = Stopped::on_disk(LISTING);
    let mut refused = String::new();
    for (inside, value) in all_values(&mut stopped).into_iter().filter(|(_, value)| value.type_name == "num") {
        let controller = &mut stopped.debugger.controller;
        let assigned =
            stopped.evaluator.assign_child(controller, &inside, &value.name, "7.5", DisplayFormat::default());
        match assigned {
            Ok(assigned) => {
                assert_eq!((&assigned.name, assigned.shown.as_str()), (&value.name, "7.5"));
                let now = children(&mut stopped, &inside).into_iter().find(|known| known.name == value.name);
                assert_eq!(now.unwrap().shown, "7.5", "{:?}", value.path);
            }
            Err(error) => refused += &format!("{} {error}\n", value.name),
        }
    }
    let mut refused: Vec<_> = refused.lines().collect();
    refused.sort_unstable();
    refused.dedup();
    expect![[r#"
        rx `rx` is computed from other values and cannot be assigned to
        ry `ry` is computed from other values and cannot be assigned to
        rz `rz` is computed from other values and cannot be assigned to
        x `x` is computed from other values and cannot be assigned to
        y `y` is computed from other values and cannot be assigned to
        z `z` is computed from other values and cannot be assigned to"#]]
    .assert_eq(&refused.join("\n"));
}

#[test]
fn inputs_and_outputs_show_their_state_and_link() {
    let mut devices = Running::devices();
    devices.state.io.declare_device("Io", ["%Q0", "%I0"].map(|name| (name, BaseType::Dio)));
    devices.state.io.declare_device("Io", [("%QW1", BaseType::Aio), ("%IW1", BaseType::Aio)]);
    let mut stopped = Stopped::on(
        devices,
        r#"
program start()
begin
  call show()
end
program show()
begin
  ? 1
end
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doOut" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%Q0" /></Data>
    <Data name="diIn" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%I0" /></Data>
    <Data name="diNone" access="private" xsi:type="array" type="dio" size="1" />
    <Data name="aoOut" access="private" xsi:type="array" type="aio" size="1"><Value key="0" link="Io\%QW1" /></Data>
    <Data name="aiIn" access="private" xsi:type="array" type="aio" size="2"><Value key="1" link="Io\%IW1" /></Data>
    <Data name="siNone" access="private" xsi:type="array" type="sio" size="1" />
  </Datas>
</Database>
"#,
    );
    assert_eq!(stopped.assign("doOut", "true"), "true (Io\\%Q0)");
    assert_eq!(stopped.watch("doOut"), "dio true (Io\\%Q0)");
    assert_eq!(stopped.assign("doOut", "false (Io\\%Q0)"), "false (Io\\%Q0)");
    assert_eq!(stopped.assign("doOut", "true"), "true (Io\\%Q0)");
    assert_eq!(stopped.watch("doOut==true and diIn==false"), "bool true");
    assert_eq!(stopped.assign("diIn", "true"), "true (Io\\%I0)", "an assignment by the user forces the input");
    stopped.execute("diIn=false");
    assert_eq!(stopped.watch("diIn"), "dio false (Io\\%I0)", "the console forces inputs too");
    stopped.execute("diIn=true");
    assert_eq!(stopped.execute("aioSet(aoOut,3)"), "num 3");
    assert_eq!(stopped.assign("aiIn[1]", "2*6"), "12 (Io\\%IW1)");
    assert_eq!(stopped.assign("aiIn[1]", "12 (Io\\%IW1)"), "12 (Io\\%IW1)", "a client confirms its edit box");
    assert_eq!(stopped.execute("aiIn[1] = 13"), "aio 13 (Io\\%IW1)");
    assert_eq!(stopped.assign("aoOut", "true"), "the value of an `aio` is a `num`, such as `12.5`");
    assert_eq!(stopped.assign("aiIn[0]", "1"), "error 123: input or output not linked");
    let shown = ["diIn", "diNone", "aoOut", "siNone"].map(|name| stopped.watch(name));
    assert_eq!(shown, ["dio true (Io\\%I0)", "dio not linked", "aio 3 (Io\\%QW1)", "sio not linked"]);
}

#[test]
fn numbers_beyond_the_range_are_refused() {
    let mut stopped =
        Stopped::at("num nX\nprogram start()\nbegin\n  call show()\nend\nprogram show()\nbegin\n  nX=1\nend\n");
    let refused = "the number is too large for a num";
    assert_eq!(stopped.assign("nX", "-1e400"), refused);
    assert_eq!(stopped.watch("1e400"), refused);
    assert_eq!(stopped.execute("nX=nX+1e309"), refused);
    assert_eq!(stopped.assign("nX", "1.7e308"), "1.7e308");
}

#[test]
fn long_collections_are_paged() {
    let mut stopped = Stopped::at(
        "num nMany[\"\"]\nprogram start()\nnum l_n\nbegin\n  for l_n=1 to 3000\n    insert(nMany[toString(\"\",l_n)])\n  endFor\n  \
         delete(nMany[\"7\"])\n  call show()\nend\nprogram show()\nbegin\n  ? 1\nend\n",
    );
    let globals = scopes(&stopped.debugger.controller.vm, stopped.task, 0).remove(2).inside;
    let many = children(&mut stopped, &globals).remove(0);
    assert_eq!(many.shown, "2999 values");
    let page = values(&mut stopped.debugger.controller, &many.inside.unwrap(), 2990..5000, DisplayFormat::default());
    let paths: Vec<_> = page.iter().filter_map(|value| value.path.as_deref()).collect();
    assert_eq!((paths.len(), paths[8]), (9, "nMany[\"999\"]"));
    assert!(page.iter().all(|value| value.shown == "0"), "{page:?}");
}

#[test]
fn angles_are_shown_in_radians() {
    let mut stopped = Stopped::on_disk(LISTING);
    stopped.execute("l_trAt={1,2,3,0,0,90}");
    let value = stopped.evaluate(0, "l_trAt", Purpose::Watch).unwrap().value.unwrap();
    let format = DisplayFormat { radians: true, ..DisplayFormat::default() };
    let fields = values(&mut stopped.debugger.controller, &value.inside.unwrap(), 0..6, format);
    assert_eq!((fields[2].shown.as_str(), fields[5].shown.as_str()), ("3", "1.5707963267949 rad"));
}
