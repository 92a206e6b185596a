//! `val3assert`, the library by which tests assert: plain VAL 3, so that the same tests run on a real controller.

/// The name of the library.
pub use val3_lang::test_names::ASSERTIONS as NAME;

/// The beginning of the message that a failure writes into the event log.
pub(crate) const FAILURE: &str = "val3assert failure: ";

/// The beginning of the message by which a test expects a run-time error.
pub(crate) const EXPECTATION: &str = "val3assert expects: ";

/// What a message of the library says after its beginning. Date, time and the mark `USR` precede it.
pub(crate) fn after(text: &str, beginning: &str) -> Option<String> {
    text.split_once(beginning).map(|(_, message)| message.trim().to_owned())
}

/// The files of the library: name and contents.
pub const FILES: &[(&str, &str)] = &[
    ("val3assert.pjx", include_str!("../library/val3assert/val3assert.pjx")),
    ("val3assert.dtx", include_str!("../library/val3assert/val3assert.dtx")),
    ("equalBool.pgx", include_str!("../library/val3assert/equalBool.pgx")),
    ("equalJoint.pgx", include_str!("../library/val3assert/equalJoint.pgx")),
    ("equalNum.pgx", include_str!("../library/val3assert/equalNum.pgx")),
    ("equalPose.pgx", include_str!("../library/val3assert/equalPose.pgx")),
    ("equalString.pgx", include_str!("../library/val3assert/equalString.pgx")),
    ("equalTrsf.pgx", include_str!("../library/val3assert/equalTrsf.pgx")),
    ("expectError.pgx", include_str!("../library/val3assert/expectError.pgx")),
    ("fail.pgx", include_str!("../library/val3assert/fail.pgx")),
    ("text.pgx", include_str!("../library/val3assert/text.pgx")),
    ("isTrue.pgx", include_str!("../library/val3assert/isTrue.pgx")),
];

/// The files of a first test application called `name`.
#[must_use]
pub fn first_test(name: &str) -> Vec<(String, String)> {
    let project = include_str!("../library/first/first.pjx").replace("NAME", name);
    let data = include_str!("../library/first/first.dtx").to_owned();
    let programs = [
        ("start", include_str!("../library/first/start.pgx")),
        ("stop", include_str!("../library/first/stop.pgx")),
        ("testFirst", include_str!("../library/first/testFirst.pgx")),
    ];
    let programs = programs.map(|(program, text)| (format!("{program}.pgx"), text.to_owned()));
    [(format!("{name}.pjx"), project), (format!("{name}.dtx"), data)].into_iter().chain(programs).collect()
}
