//! The sample messages in `tests/samples`, read and written again, and damaged.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;

use val3_soap::v0::{DiameterAxis3, Kinematic, LengthAxis3, MountType, Ping};
use val3_soap::v2::{ExecutionResult, ReplacementResult, SignalStatus, TaskState, TaskStepKind};
use val3_soap::v3::{
    AboveBelow, BlendType, MotionResult, MoveType, PositiveNegative, PowerResult, ReversingResult, SchedulingMode,
    Shoulder,
};
use val3_soap::{
    Envelope, ExceptionCode, SessionHeader, SoapAnswer, SoapElement, SoapFault, SoapRequest, SoapServer, SoapVersion,
    multipart, operations, v0, v3,
};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/samples")
}

/// Names and texts of the samples with this ending.
fn samples(ending: &str) -> Vec<(String, String)> {
    let files = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let mut samples: Vec<_> = files
        .filter_map(|path| {
            let name = path.file_name()?.to_str()?.strip_suffix(ending)?.to_owned();
            Some((name, fs::read_to_string(&path).unwrap()))
        })
        .collect();
    samples.sort();
    samples
}

/// Server and operation in the name of a sample, for example `V2-taskKill-fault`.
fn operation(name: &str) -> (SoapServer, &str) {
    let (server, operation) = name.split_once('-').unwrap();
    let server = SoapServer::ALL.into_iter().find(|known| known.name() == server).unwrap();
    (server, operation.split(['-', '.']).next().unwrap())
}

/// Content of a document, independent of prefixes, blanks between elements and the spelling of numbers.
fn canonical(text: &str) -> String {
    let mut lines = String::new();
    list(&SoapElement::read(text.as_bytes()).unwrap(), 0, &mut lines);
    lines
}

fn list(element: &SoapElement, depth: usize, lines: &mut String) {
    let text = if element.children.is_empty() { element.text.as_str() } else { element.text.trim() };
    let text = text.parse::<f64>().map_or_else(|_| text.to_owned(), |number| (number + 0.0).to_string());
    let attributes: Vec<String> = element
        .attributes
        .iter()
        .map(|attribute| format!(" {{{}}}{}={}", attribute.namespace, attribute.name, attribute.value))
        .collect();
    let indent = " ".repeat(depth);
    lines.push_str(&format!("{indent}{{{}}}{}{} {text}\n", element.namespace, element.name, attributes.concat()));
    element.children.iter().for_each(|child| list(child, depth + 1, lines));
}

#[test]
fn requests_are_read_and_written_again() {
    let samples = samples(".req.xml");
    for (name, text) in &samples {
        let (server, operation) = operation(name);
        let envelope = Envelope::read(text.as_bytes()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let request = SoapRequest::read(server, &envelope.body).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(request.name(), operation);
        let written = Envelope { body: request.write(), ..envelope }.write();
        assert_eq!(canonical(&written), canonical(text), "{name}");
    }
    let operations = operations::OPERATIONS
        .iter()
        .filter(|(server, operation)| samples.iter().all(|(name, _)| self::operation(name) != (*server, *operation)));
    let without: Vec<_> = operations.map(|(_, operation)| *operation).collect();
    assert_eq!(without, ["loadProjectAsync", "startApplication", "stopApplication", "stopAndUnloadAll"]);
}

#[test]
fn answers_are_read_and_written_again() {
    for (name, text) in samples(".res.xml") {
        let (server, operation) = operation(&name);
        let envelope = Envelope::read(text.as_bytes()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let body = if SoapFault::is_fault(&envelope.body, envelope.version) {
            assert!(name.ends_with("fault"), "{name}");
            SoapFault::read(&envelope.body, envelope.version).unwrap().write(envelope.version)
        } else {
            let answer = SoapAnswer::read(server, operation, &envelope.body);
            answer.unwrap_or_else(|error| panic!("{name}: {error}")).write()
        };
        let written = Envelope { body, ..envelope }.write();
        assert_eq!(canonical(&written), canonical(&text), "{name}");
    }
}

#[test]
fn a_message_of_several_parts_contains_the_envelope() {
    let text = fs::read_to_string(folder().join("V3-setPower.mtom.txt")).unwrap();
    let text = text.replace("\r\n", "\n").replace('\n', "\r\n");
    let (head, body) = text.split_once("\r\n\r\n").unwrap();
    let content_type = head.lines().find_map(|line| line.strip_prefix("Content-Type: ")).unwrap();
    let envelope = multipart::envelope(content_type, body.as_bytes()).unwrap();
    let envelope = Envelope::read(envelope).unwrap();
    assert_eq!(envelope.session, Some(SessionHeader { id: 42, must_understand: false }));
    let request = SoapRequest::read(SoapServer::V3, &envelope.body).unwrap();
    assert_eq!(request, SoapRequest::SetPower(v3::SetPower { power: true }));
}

#[test]
fn enumerations_have_the_values_of_the_stubs() {
    fn texts<T: Copy>(all: &[T], text: impl Fn(T) -> &'static str) -> Vec<&'static str> {
        all.iter().map(|value| text(*value)).collect()
    }
    let enumerations = [
        ("ServerExceptionCode", texts(ExceptionCode::ALL, ExceptionCode::text)),
        ("Kinematic", texts(Kinematic::ALL, Kinematic::text)),
        ("MountType", texts(MountType::ALL, MountType::text)),
        ("LengthAxis3", texts(LengthAxis3::ALL, LengthAxis3::text)),
        ("DiameterAxis3", texts(DiameterAxis3::ALL, DiameterAxis3::text)),
        ("SoapTaskState", texts(TaskState::ALL, TaskState::text)),
        ("SoapTaskStep", texts(TaskStepKind::ALL, TaskStepKind::text)),
        ("SoapPhysicalIoEnumState", texts(SignalStatus::ALL, SignalStatus::text)),
        ("execVal3ReturnCode", texts(ExecutionResult::ALL, ExecutionResult::text)),
        ("replaceLineReturnCode", texts(ReplacementResult::ALL, ReplacementResult::text)),
        ("MoveType", texts(MoveType::ALL, MoveType::text)),
        ("BlendType", texts(BlendType::ALL, BlendType::text)),
        ("ShoulderConfig", texts(Shoulder::ALL, Shoulder::text)),
        ("PositiveNegativeConfig", texts(PositiveNegative::ALL, PositiveNegative::text)),
        ("AboveBelowConfig", texts(AboveBelow::ALL, AboveBelow::text)),
        ("MotionReturnCode", texts(MotionResult::ALL, MotionResult::text)),
        ("ReversingResult", texts(ReversingResult::ALL, ReversingResult::text)),
        ("SchedulingMode", texts(SchedulingMode::ALL, SchedulingMode::text)),
        ("PowerReturnCode", texts(PowerResult::ALL, PowerResult::text)),
    ];
    let table = fs::read_to_string(folder().join("enumerations.tsv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split('\t').collect()).collect();
    assert_eq!(rows.len(), enumerations.iter().map(|(_, values)| values.len()).sum::<usize>());
    for (name, values) in enumerations {
        let rows: Vec<&str> = rows.iter().filter(|row| row[1] == name).map(|row| row[3]).collect();
        assert_eq!(values, rows, "{name}");
    }
}

/// Reads bytes as a message to every server and as every answer. The results do not matter.
fn read_in_every_way(bytes: &[u8]) {
    let Ok(envelope) = Envelope::read(bytes) else { return };
    let _ = SoapFault::read(&envelope.body, envelope.version);
    for server in SoapServer::ALL {
        if let Ok(request) = SoapRequest::read(server, &envelope.body) {
            let written = Envelope { body: request.write(), ..envelope.clone() }.write();
            let again = Envelope::read(written.as_bytes()).unwrap();
            assert_eq!(SoapRequest::read(server, &again.body), Ok(request));
        }
    }
    for (server, operation) in operations::OPERATIONS {
        let _ = SoapAnswer::read(*server, operation, &envelope.body);
    }
}

proptest! {
    #[test]
    fn no_input_panics(bytes in prop::collection::vec(any::<u8>(), 0..400), text in "[<>/a:=\"'&;#x! \\[\\]?-]{0,80}") {
        read_in_every_way(&bytes);
        read_in_every_way(text.as_bytes());
        let _ = multipart::envelope(&text, &bytes);
        let _ = multipart::envelope(&format!("multipart/related; boundary=b; {text}"), &bytes);
    }

    #[test]
    fn no_damaged_sample_panics(index in any::<prop::sample::Index>(), at in any::<prop::sample::Index>(), edit in "\\PC{0,8}|<[a-z]{1,3}/?>|&#?[a-z0-9]{1,4};", removed in 0_usize..40) {
        let samples = [samples(".req.xml"), samples(".res.xml")].concat();
        let mut bytes = index.get(&samples).1.clone().into_bytes();
        let start = at.index(bytes.len());
        let end = (start + removed).min(bytes.len());
        bytes.splice(start..end, edit.into_bytes());
        read_in_every_way(&bytes);
    }

    #[test]
    fn any_text_is_returned(message in "[^\\x00-\\x08\\x0b\\x0c\\x0e-\\x1f\\ufffe\\uffff]{0,40}", control in "\\PC*[\\x00-\\x1f]") {
        for version in [SoapVersion::V11, SoapVersion::V12] {
            let send = |message: &str| {
                let request = SoapRequest::Ping(Ping { message: Some(message.to_owned()) });
                let text = Envelope { version, session: None, body: request.write() }.write();
                SoapRequest::read(SoapServer::V0, &Envelope::read(text.as_bytes()).unwrap().body).unwrap()
            };
            prop_assert_eq!(send(&message), SoapRequest::Ping(Ping { message: Some(message.clone()) }));
            send(&control);
        }
    }

    #[test]
    fn numbers_are_returned_exactly(number in any::<f64>().prop_filter("finite", |number| number.is_finite())) {
        let request = SoapRequest::SetRobotJointPos(v0::SetRobotJointPos { robot: -1, position: vec![number] });
        prop_assert_eq!(SoapRequest::read(SoapServer::V0, &request.write()), Ok(request));
    }
}
