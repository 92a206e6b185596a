use proptest::prelude::*;
use serde_json::Value;

use super::*;

/// Event of a logged run.
#[derive(Debug, Clone)]
enum Step {
    Append,
    Lasting,
    BeginPart,
    /// The late viewer reads up to so many messages.
    Read(usize),
    /// The late viewer receives an older part.
    Older,
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    let step = prop_oneof![
        6 => Just(Step::Append),
        1 => Just(Step::Lasting),
        1 => Just(Step::BeginPart),
        2 => (1..9_usize).prop_map(Step::Read),
        1 => Just(Step::Older),
    ];
    prop::collection::vec(step, 1..120)
}

fn text(number: usize) -> StoredMessage {
    StoredMessage::Text(format!("{{\"n\":{number}}}").into())
}

/// Viewer that stores what it receives: the lasting messages, and the others in their order in the run.
#[derive(Debug, Default)]
struct Reader {
    cursor: Option<LogCursor>,
    lasting: Vec<StoredMessage>,
    messages: Vec<Vec<u8>>,
    /// `from` and `to` of the latest message about the past.
    past: Option<(f64, f64)>,
    /// Beginning of the oldest part.
    oldest: Option<f64>,
}

impl Reader {
    fn read(&mut self, log: &MessageLog, count: usize) -> bool {
        let messages = log.messages_since(&mut self.cursor, count);
        let has_read = !messages.is_empty();
        messages.into_iter().for_each(|message| self.receive(message));
        has_read
    }

    fn read_older(&mut self, log: &MessageLog) -> bool {
        match log.older(&mut self.cursor) {
            Some(OlderPart::Block(block)) => self.receive(block.encoded()),
            Some(OlderPart::End(message)) => self.receive(message),
            None => return false,
        }
        true
    }

    fn receive(&mut self, message: StoredMessage) {
        match message {
            StoredMessage::Binary(block) => {
                let (start, own) = messages_in(&block);
                assert!(self.oldest.is_none_or(|oldest| start < oldest));
                self.oldest = Some(start);
                self.messages.splice(0..0, own);
            }
            StoredMessage::Lasting(_) => self.lasting.push(message),
            StoredMessage::Text(text) => match serde_json::from_str::<Value>(&text).unwrap() {
                past if past["kind"] == "past" => {
                    self.past = past["from"].as_f64().zip(past["to"].as_f64());
                }
                _ => self.messages.push(text.as_bytes().to_vec()),
            },
        }
    }
}

/// Beginning of a block, and its messages without those of the state.
fn messages_in(block: &[u8]) -> (f64, Vec<Vec<u8>>) {
    let state = u32::from_le_bytes(block[4..8].try_into().unwrap()) as usize;
    let (start, mut rest) = (f64::from_le_bytes(block[8..16].try_into().unwrap()), &block[16..]);
    let mut messages = Vec::new();
    while let [_, a, b, c, d, more @ ..] = rest {
        let (message, next) = more.split_at(u32::from_le_bytes([*a, *b, *c, *d]) as usize);
        messages.push(message.to_vec());
        rest = next;
    }
    (start, messages.split_off(state))
}

proptest! {
    /// A viewer that connects at any time has in the end the messages of a viewer from the beginning, in the same order.
    #[test]
    fn late_viewers_receive_the_messages_of_early_ones(before in steps(), after in steps()) {
        let mut log = MessageLog::new(usize::MAX);
        let (mut early, mut late) = (Reader::default(), Reader::default());
        let count = before.len();
        for (number, step) in before.into_iter().chain(after).enumerate() {
            match step {
                Step::Append => log.append(text(number)),
                Step::Lasting => log.append(StoredMessage::Lasting(format!("{number}").into())),
                Step::BeginPart => log.begin_part(f64::from(u32::try_from(number).unwrap()) + 0.5, vec![text(1_000_000); 3]),
                Step::Read(most) if number >= count => { late.read(&log, most); }
                Step::Older if number >= count => { late.read_older(&log); }
                Step::Read(_) | Step::Older => {}
            }
            early.read(&log, usize::MAX);
        }
        while late.read(&log, 5) || late.read_older(&log) {}
        prop_assert_eq!(&early.messages, &late.messages);
        prop_assert_eq!(&early.lasting, &late.lasting);
        prop_assert_eq!(late.past.map_or(Some(0.0), |(from, to)| (from == to).then_some(to)), Some(0.0));
    }
}

#[test]
fn a_viewer_whose_messages_were_dropped_enters_again() {
    let mut log = MessageLog::new(60);
    log.append(StoredMessage::Lasting("0".into()));
    let mut slow = Reader::default();
    slow.read(&log, 1);
    for number in 0..100 {
        log.append(text(number));
        if number % 2 == 0 {
            log.begin_part(f64::from(u32::try_from(number).unwrap()), vec![text(number)]);
        }
    }
    assert!(log.bytes() <= 60);
    slow = Reader { cursor: slow.cursor, ..Reader::default() };
    while slow.read(&log, 5) || slow.read_older(&log) {}
    assert_eq!(slow.lasting, [StoredMessage::Lasting("0".into())]);
    let (from, to) = slow.past.unwrap();
    assert!(from > 90.0 && from == to && slow.oldest == Some(from), "{slow:?}");
    assert_eq!(slow.messages.last().unwrap(), b"{\"n\":99}");
}

#[test]
fn older_parts_of_a_previous_run_are_not_sent() {
    let mut log = MessageLog::new(usize::MAX);
    log.append(text(1));
    log.begin_part(1.0, vec![text(2)]);
    let mut late = Reader::default();
    late.read(&log, 5);
    log.begin_run();
    assert!(!late.read_older(&log));
    log.append(text(3));
    late.read(&log, 5);
    assert!(!late.read_older(&log));
    assert_eq!(late.messages, [b"{\"n\":3}"]);
}
