//! Snapshots of a controller whose application uses files, a socket, a library and the pendant.

use proptest::prelude::*;
use val3_machine::controller::{Controller, OperatorAction};
use val3_machine::event::Event;
use val3_machine::io::{IoChange, Signal};
use val3_machine::sio::{ChannelConfig, LineKind, LineSetting, MemoryLine, Peer};

use crate::cell::{Cell, run};

const CYCLE: u64 = 4_000_000;

/// Signal of a field bus.
const BUS: &str = r"Bus\%IW0";

const LISTING: &str = r#"
program start()
begin
  while nRound<4
    nRound=nRound+1
    sText=siHost
    nFile=$fileOpen("./log.txt","a")
    sLines[0]=sText
    ? $fileSet(nFile,sLines,1)
    ? $fileClose(nFile)
    siHost="got "+sText
    ? libSave("./copy")
    ? get()
    ? clock()
  endWhile
  ? libDelete("./copy")
  nFile=$fileOpen("./log.txt","r")
  ? $fileGet(nFile,sLines,4)
  ? sLines[3]
end
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1">
      <Value key="0" link="Socket\host" />
    </Data>
    <Data name="nRound" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nFile" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
    <Data name="sLines" access="private" xsi:type="array" type="string" size="4" />
  </Datas>
</Database>"#;

fn connected(cell: &Cell) -> (Controller, Peer) {
    let mut controller = cell.controller();
    controller.devices.lines.record();
    let (line, peer) = MemoryLine::pair(LineKind::Server);
    let config = ChannelConfig {
        link: r"Socket\host".to_owned(),
        kind: LineKind::Server,
        settings: vec![LineSetting::Timeout(0.0)],
    };
    controller.devices.lines.attach(&config, Box::new(line), false).unwrap();
    controller.devices.state.io.declare(Signal::from_path(BUS, false));
    (controller, peer)
}

/// Executes the peer's and the operator's actions before a cycle. `last` is the previous cycle with actions.
fn outside(controller: &mut Controller, peer: &Peer, last: &mut u64) {
    let cycle = controller.now() / CYCLE;
    if std::mem::replace(last, cycle) == cycle {
        return;
    }
    match cycle {
        2 => peer.connect(),
        3 => peer.send("one\rtw"),
        9 => peer.send("o\rthree\r"),
        20 => peer.disconnect(),
        22 => peer.connect(),
        24 => peer.send("four\r"),
        4 | 5 | 23 => {
            let signal = controller.devices.state.io.find(BUS).unwrap();
            controller.devices.receive(vec![IoChange { signal, value: f64::from(u8::from(cycle != 5)) }]);
        }
        cycle if cycle.is_multiple_of(8) => controller.operate(OperatorAction::Tap(270)),
        _ => {}
    }
}

fn record(events: &[Event]) -> String {
    events.iter().map(|event| serde_json::to_string(event).unwrap() + "\n").collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A restored controller repeats its events exactly, without reading or changing anything outside again.
    #[test]
    fn restored_controllers_repeat_their_inputs(cycle in 0_u64..40, rest in 0..CYCLE) {
        let cell = Cell::new(LISTING);
        let (mut controller, peer) = connected(&cell);
        let mut last = 0;
        while controller.now() < cycle * CYCLE {
            outside(&mut controller, &peer, &mut last);
            controller.step();
        }
        controller.set_limit(Some(controller.now() + rest));
        outside(&mut controller, &peer, &mut last);
        controller.step();
        controller.set_limit(None);
        controller.devices.take_events();
        let snapshot = controller.snapshot();
        let first = record(&run(&mut controller, |controller| outside(controller, &peer, &mut last)));
        prop_assert!(first.contains(r#""text":"four""#), "{}", first);
        drop(peer.take());
        controller.write_files();
        prop_assert_eq!(record(&controller.devices.take_events()), "");
        let log = cell.read("usrapp/main/log.txt");
        for _ in 0..2 {
            controller.restore(&snapshot);
            prop_assert_eq!(record(&run(&mut controller, |_| {})), first.as_str());
            prop_assert_eq!(peer.take(), b"");
            controller.write_files();
            prop_assert_eq!(record(&controller.devices.take_events()), "");
            prop_assert_eq!(cell.read("usrapp/main/log.txt"), log.as_str());
        }
    }
}
