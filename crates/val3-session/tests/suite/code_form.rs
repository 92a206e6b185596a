//! The form of the code has no effect on a run, tested with the palletiser example and its libraries.

use camino::Utf8Path;
use val3_analysis::system::Disk;
use val3_lang::ports::SECOND;
use val3_machine::controller::Controller;
use val3_machine::script::Script;
use val3_session::{Application, CodeForm, ControllerSettings, Pace, Tape};

const CELL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/palletiser");

/// Event record for two boxes, and the controller afterwards.
fn two_boxes(form: CodeForm) -> (String, Controller) {
    let cell = Utf8Path::new(CELL);
    let application = Application::open(&Disk, &cell.join("usr/usrapp/palletiser"), None).unwrap();
    let image = application.compile_as(form).unwrap();
    let tape = Tape { records: false, replays: None };
    let settings = ControllerSettings { form, ..ControllerSettings::default() };
    let mut controller = application.controller(&settings, tape, image).unwrap();
    controller.follow(Script::parse(&std::fs::read_to_string(cell.join("boxes.toml")).unwrap()).unwrap());
    controller.start("start").unwrap();
    let pace = Pace { until: Some(11 * SECOND), ..Pace::default() };
    controller.set_limit(pace.until);
    let mut record = String::new();
    while controller.now() < 11 * SECOND {
        let status = controller.step();
        for event in controller.devices.take_events() {
            record += &(serde_json::to_string(&event).unwrap() + "\n");
        }
        if let val3_machine::controller::RunStatus::Waiting(wake) = status {
            let _ = pace.wait(&mut controller, wake);
        }
    }
    (record, controller)
}

#[test]
fn the_palletiser_has_the_same_events_in_each_form() {
    let ((counted, controller), (plain, other)) = (two_boxes(CodeForm::Counted), two_boxes(CodeForm::Plain));
    assert!(plain.lines().count() > 100, "{plain}");
    assert!(counted == plain, "the events differ");
    assert!(two_boxes(CodeForm::Debugged).0 == plain, "the events of code for a debugger differ");
    assert!(hits(&other).is_empty());
    let found = hits(&controller);
    assert!(found.iter().any(|(name, sum)| name == "palletiser" && *sum > 1000), "{found:?}");
    assert!(found.iter().any(|(name, sum)| name == "partBox" && *sum > 2), "{found:?}");
}

/// Applications and libraries with the sums of their counters.
fn hits(controller: &Controller) -> Vec<(String, u64)> {
    let images = controller.vm.space.counts.images();
    images.map(|(image, hits)| (image.name.clone(), hits.iter().sum())).collect()
}
