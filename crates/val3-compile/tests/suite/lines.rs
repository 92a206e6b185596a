//! Serial lines and sockets (3.7).

use expect_test::{Expect, expect};
use val3_machine::controller::Controller;
use val3_machine::event::EventKind;
use val3_machine::sio::{ChannelConfig, LineKind, LineSetting, MemoryLine, Peer, replay};

use crate::cell::{Cell, run, shown};

const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1">
      <Value key="0" link="Socket\host" />
    </Data>
    <Data name="siNone" access="private" xsi:type="array" type="sio" size="1" />
    <Data name="siOther" access="private" xsi:type="array" type="sio" size="1">
      <Value key="0" link="Socket\unknown" />
    </Data>
    <Data name="nData" access="private" xsi:type="array" type="num" size="4" />
    <Data name="nByte" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>"#;

/// Creates a cell with the program `start`, which consists of these lines, and with the channel that `siHost` is linked
/// to.
fn cell(lines: &str) -> Cell {
    Cell::new(&format!("program start()\nbegin\n{lines}\nend\n{DATA}"))
}

fn config(kind: LineKind, timeout: f64) -> ChannelConfig {
    ChannelConfig { link: r"Socket\host".to_owned(), kind, settings: vec![LineSetting::Timeout(timeout)] }
}

fn connected(cell: &Cell, kind: LineKind) -> (Controller, Peer) {
    let mut controller = cell.controller();
    let (line, peer) = MemoryLine::pair(kind);
    controller.devices.lines.attach(&config(kind, 0.5), Box::new(line), false).unwrap();
    peer.connect();
    (controller, peer)
}

/// Checks the output and the sent data of a program that receives `input`.
#[track_caller]
fn check(lines: &str, input: &[u8], expected: Expect) {
    let (mut controller, peer) = connected(&cell(lines), LineKind::Client);
    peer.send(input);
    let events = run(&mut controller, |_| {});
    expected.assert_eq(&format!("{}{:?}\n", shown(&events), String::from_utf8_lossy(&peer.take())));
}

#[test]
fn texts_go_out_and_come_in_with_their_end() {
    check(
        "sText=siHost\n? sText\nsiHost=\"got \"+sText\nsioCtrl(siHost,\"endOfString\",10)\nsText=siHost\n? sText",
        "grün\rnext\n".as_bytes(),
        expect![[r#"
            grün
            next
            "got grün\r"
        "#]],
    );
}

#[test]
fn numbers_go_out_modulo_256_and_come_in_as_bytes() {
    check(
        "nByte=siHost\n? nByte\nsiHost=65.6\nsiHost=256+67\nsiHost=-188\nnData[2]=siHost\n? nData[2]",
        b"Z\xff",
        expect![[r#"
            90
            255
            "BCD"
        "#]],
    );
}

#[test]
fn bytes_fill_an_array_from_an_index_on() {
    check(
        "? sioGet(siHost,nData[1])\n? nData[0]\n? nData[3]\n? sioGet(siHost,nByte)\n? nByte\n? sioGet(siHost,nByte)\n? sioSet(siHost,nData)\n? sioSet(siHost,nData[2])",
        b"ABCD",
        expect![[r#"
            3
            0
            67
            1
            68
            -1
            4
            2
            "\0ABCBC"
        "#]],
    );
}

#[test]
fn a_timeout_is_an_error_of_assignments_alone() {
    check(
        "? sioGet(siHost,nData)\n? clock()\nsText=siHost",
        b"",
        expect![[r#"
        -1
        0.5
        error 125 in start
        ""
    "#]],
    );
}

#[test]
fn a_variable_needs_a_link_that_the_controller_knows() {
    for line in ["siNone=1", "siOther=\"a\"", "nByte=siNone", "clearBuffer(siNone)", "sioSet(siOther,nData)"] {
        check(line, b"", expect![["error 123 in start\n\"\"\n"]]);
    }
    check("? sioCtrl(siNone,\"port\",1)", b"", expect![["error 123 in start\n\"\"\n"]]);
    check(
        "sioLink(siNone,siHost)\nsiNone=65\nsioLink(siNone,siOther)\nsiNone=66",
        b"",
        expect![["error 123 in start\n\"A\"\n"]],
    );
}

#[test]
fn parameters_have_results() {
    check(
        "? sioCtrl(siHost,\"timeout\",0.1)\n? sioCtrl(siHost,\"speed\",1)\n? sioCtrl(siHost,\"nagle\",1)\n\
         ? sioCtrl(siHost,\"endOfString\",256)\n? sioCtrl(siHost,\"port\",2000)\n? sioCtrl(siHost,\"baudRate\",9600)",
        b"",
        expect![[r#"
            0
            -1
            -2
            -3
            -4
            -5
            ""
        "#]],
    );
}

#[test]
fn clearing_closes_a_socket() {
    check(
        "nByte=siHost\n? clearBuffer(siHost)\n? clearBuffer(siHost)",
        b"ABCD",
        expect![[r#"
            3
            -1
            ""
        "#]],
    );
}

#[test]
fn other_tasks_run_while_one_waits() {
    let cell = Cell::new(&format!(
        "program start()\nbegin\n  taskCreate \"other\",10,count()\n  sText=siHost\n  ? sText+toString(\"\",nByte)\n  \
         taskKill(\"other\")\nend\n\
         program count()\nbegin\n  while true\n    nByte=nByte+1\n    delay(0.1)\n  endWhile\nend\n{DATA}"
    ));
    let (mut controller, peer) = connected(&cell, LineKind::Server);
    let events = run(&mut controller, |controller| {
        if controller.now() == 450_000_000 / 4_000_000 * 4_000_000 {
            peer.send(b"five \r");
        }
    });
    assert_eq!(shown(&events), "five 5\n");
}

/// Two tasks send while the peer receives nothing: the task that exceeds the limit fails.
#[test]
fn the_bytes_that_tasks_have_to_send_are_limited() {
    let [within, beyond] = [20, 19].map(|bytes| {
        let cell = Cell::new(&format!(
            "program other()\nbegin\nsiHost=\"123456789\"\nend\nprogram start()\nbegin\n\
             taskCreate \"o\",10,other()\ndelay(0)\nsiHost=\"123456789\"\nend\n{DATA}"
        ));
        let (mut controller, peer) = connected(&cell, LineKind::Client);
        controller.devices.limits.pending = bytes;
        peer.stall_after(0);
        (0..10).for_each(|_| _ = controller.step());
        shown(&controller.devices.take_events())
    });
    assert_eq!(within, "");
    assert!(beyond.starts_with("error 40"), "{beyond}");
}

/// If the events of a cycle need too much memory, it stops until the caller has read them. The events are the same.
#[test]
fn a_cycle_with_too_many_events_is_suspended() {
    let cell = cell("while nByte<100\nnByte=nByte+1\n? nByte\nendWhile");
    let whole = run(&mut cell.controller(), |_| {});
    let mut controller = cell.controller();
    controller.devices.limits.recorded = 1000;
    controller.step();
    assert!(controller.devices.take_events().len() < 20);
    let mut controller = cell.controller();
    controller.devices.limits.recorded = 1000;
    assert_eq!(run(&mut controller, |_| {}), whole);
}

#[test]
fn data_on_lines_are_events() {
    let (mut controller, peer) = connected(&cell("sText=siHost\nsiHost=sText\nnByte=siHost"), LineKind::Client);
    peer.send(b"hi\r\x07");
    let told: Vec<_> = run(&mut controller, |_| {})
        .into_iter()
        .filter_map(|event| match event.kind {
            EventKind::Sio { link, dir, bytes } => Some(format!("{link} {dir} {bytes:?}")),
            _ => None,
        })
        .collect();
    assert_eq!(told, [r"Socket\host in [104, 105]", r"Socket\host out [104, 105, 13]", r"Socket\host in [7]"]);
}

#[test]
fn a_recorded_run_goes_the_same_way_without_the_line() {
    let cell = cell("while nByte<3\nnByte=nByte+1\nsText=siHost\n? sText\n? clock()\nsiHost=\"ok\"\nendWhile");
    let mut controller = cell.controller();
    controller.devices.lines.record();
    let (line, peer) = MemoryLine::pair(LineKind::Server);
    let config = config(LineKind::Server, 0.0);
    controller.devices.lines.attach(&config, Box::new(line), false).unwrap();
    let events = run(&mut controller, |controller| match controller.now() / 4_000_000 {
        10 => peer.connect(),
        20 => peer.send("one\rtw"),
        30 => peer.send("o\r"),
        70 => peer.send("three\r"),
        _ => {}
    });
    let record: String = events.iter().map(|event| serde_json::to_string(event).unwrap() + "\n").collect();
    let answers = replay(&record).unwrap();
    let mut again = cell.controller();
    again.devices.lines.replay(answers);
    again.devices.lines.configure(&[config], val3_machine::sio::NetworkAccess::Loopback, &|_| None).unwrap();
    assert_eq!(shown(&run(&mut again, |_| {})), shown(&events));
    assert!(shown(&events).starts_with("one\n0.08"), "{}", shown(&events));
}
