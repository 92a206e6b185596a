use super::*;
use crate::sio::{MemoryLine, Peer};

fn channel(kind: LineKind) -> (Channel, Peer) {
    let (line, peer) = MemoryLine::pair(kind);
    (Channel::new(Box::new(line)), peer)
}

fn connected(kind: LineKind) -> (Channel, Peer) {
    let (channel, peer) = channel(kind);
    peer.connect();
    (channel, peer)
}

fn text(channel: &mut Channel) -> Attempt<Result<String, SioFault>> {
    channel.read_text(0.0)
}

fn done(text: &str) -> Attempt<Result<String, SioFault>> {
    Attempt::Done(Ok(text.to_owned()))
}

const TIMED_OUT: Attempt<Result<String, SioFault>> = Attempt::Done(Err(SioFault::TimedOut));

#[test]
fn received_bytes_are_an_unfinished_string_until_its_end() {
    let (mut channel, peer) = connected(LineKind::Client);
    assert_eq!(channel.unfinished_string(), None);
    peer.send(b"GO\n");
    assert_eq!(text(&mut channel), Attempt::Wait);
    assert_eq!(channel.unfinished_string(), Some(UnfinishedString { bytes: 3, end: b'\r' }));
    peer.send(b"\r");
    channel.attend();
    assert_eq!(channel.unfinished_string(), None);
}

#[test]
fn numbers_become_bytes() {
    let bytes = [0.0, 255.0, 256.0, 300.0, -1.0, -256.5, 64.4, 64.5, 1e20, -0.4].map(byte_of);
    assert_eq!(bytes, [0, 255, 0, 44, 255, 0, 64, 65, 0, 0]);
}

#[test]
fn a_string_is_complete_with_its_end() {
    let (mut channel, peer) = connected(LineKind::Server);
    assert_eq!(text(&mut channel), Attempt::Wait);
    peer.send("hel");
    assert_eq!(text(&mut channel), Attempt::Wait);
    peer.send("lo\rnext\r\r");
    assert_eq!(text(&mut channel), done("hello"));
    assert_eq!(text(&mut channel), done("next"));
    assert_eq!(text(&mut channel), done(""));
    assert_eq!(text(&mut channel), Attempt::Wait);
}

#[test]
fn the_end_of_string_is_a_parameter() {
    let (mut channel, peer) = connected(LineKind::Client);
    assert_eq!(channel.control("endOfString", SettingValue::Num(10.0)), 0);
    peer.send("a\rb\nc");
    assert_eq!(text(&mut channel), done("a\rb"));
    let mut sending = channel.text("été");
    assert_eq!(channel.send(&mut sending, 0.0), Attempt::Done(Ok(6)));
    assert_eq!(peer.take(), "été\n".as_bytes());
}

#[test]
fn a_string_holds_128_bytes() {
    let (mut channel, peer) = connected(LineKind::Server);
    peer.send("x".repeat(127));
    assert_eq!(text(&mut channel), Attempt::Wait);
    peer.send("y");
    assert_eq!(text(&mut channel), done(&("x".repeat(127) + "y")));
    peer.send("z".repeat(300) + "\r");
    let lengths = [(); 3].map(|()| match text(&mut channel) {
        Attempt::Done(Ok(text)) => text.len(),
        other => panic!("{other:?}"),
    });
    assert_eq!(lengths, [128, 128, 44]);
    peer.send("x".repeat(128) + "\r");
    assert_eq!(text(&mut channel), done(&"x".repeat(128)));
    assert_eq!(text(&mut channel), done(""));
}

#[test]
fn characters_are_not_split() {
    let (mut channel, peer) = connected(LineKind::Server);
    peer.send("字".repeat(43));
    assert_eq!(text(&mut channel), done(&"字".repeat(42)));
    peer.send("\r");
    assert_eq!(text(&mut channel), done("字"));
}

#[test]
fn invalid_bytes_are_ignored() {
    let (mut channel, peer) = connected(LineKind::Server);
    peer.send(b"a\xff\xfe\0b\xe5\xad\r");
    assert_eq!(text(&mut channel), done("ab"));
}

#[test]
fn a_flood_of_invalid_bytes_takes_no_memory() {
    let (mut channel, peer) = connected(LineKind::Server);
    peer.send("start");
    for _ in 0..40 {
        peer.send(vec![0xff; 10_000]);
        assert_eq!(text(&mut channel), Attempt::Wait);
        assert!(channel.state.input.len() <= input::CAPACITY);
    }
    peer.send("ed\r");
    let heard = (0..40).map(|_| text(&mut channel)).find(|turn| *turn != Attempt::Wait);
    assert_eq!(heard, Some(done("started")));
}

#[test]
fn a_timeout_ends_the_wait() {
    let (mut channel, peer) = connected(LineKind::Client);
    assert_eq!(channel.control("timeout", SettingValue::Num(2.0)), 0);
    peer.send("half");
    assert_eq!(channel.read_text(1.9), Attempt::Wait);
    assert_eq!(channel.read_text(2.0), TIMED_OUT);
    peer.send(" done\r");
    assert_eq!(channel.read_text(0.0), done("half done"));
    assert_eq!(channel.read_byte(2.5), Attempt::Done(Err(SioFault::TimedOut)));
    assert_eq!(channel.read_bytes(4, 2.5), Attempt::Done(None));
    peer.stall_after(0);
    assert_eq!(channel.send(&mut Sending::bytes(vec![1]), 1.0), Attempt::Wait);
    assert_eq!(channel.send(&mut Sending::bytes(vec![1]), 2.0), Attempt::Done(Err(SioFault::TimedOut)));
}

#[test]
fn a_timeout_of_zero_is_none() {
    let (mut channel, _peer) = channel(LineKind::Client);
    assert_eq!(channel.read_text(1e9), Attempt::Wait);
    assert_eq!(channel.read_bytes(1, 1e9), Attempt::Wait);
    assert_eq!(channel.send(&mut Sending::bytes(vec![1]), 1e9), Attempt::Wait);
}

/// A public driver polls its sockets in this way.
#[test]
fn a_negative_timeout_never_waits() {
    let (mut channel, peer) = channel(LineKind::Server);
    assert_eq!(channel.control("timeout", SettingValue::Num(-1.0)), 0);
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Done(None));
    assert_eq!(channel.send(&mut Sending::bytes(vec![1]), 0.0), Attempt::Done(Err(SioFault::TimedOut)));
    peer.connect();
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Done(Some(vec![])));
    peer.send([7, 8]);
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Done(Some(vec![7])));
    peer.disconnect();
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Done(Some(vec![8])));
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Done(None));
    assert_eq!(channel.read_text(0.0), TIMED_OUT);
}

#[test]
fn bytes_are_read_until_full_or_empty() {
    let (mut channel, peer) = connected(LineKind::Client);
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Wait);
    peer.send([1, 2, 3, 4, 5]);
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Done(Some(vec![1, 2, 3, 4])));
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Done(Some(vec![5])));
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Wait);
    peer.send([6]);
    assert_eq!(channel.read_byte(0.0), Attempt::Done(Ok(6)));
    assert_eq!(channel.read_byte(0.0), Attempt::Wait);
}

#[test]
fn a_serial_line_returns_available_bytes() {
    let (mut channel, peer) = channel(LineKind::Serial);
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Done(Some(vec![])));
    assert_eq!(channel.read_text(0.0), Attempt::Wait);
    peer.send("ab");
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Done(Some(b"ab".to_vec())));
    peer.send("abc");
    assert_eq!((channel.clear(), channel.clear()), (Some(3), Some(0)));
}

#[test]
fn clearing_closes_a_socket() {
    let (mut channel, peer) = connected(LineKind::Server);
    peer.send("abc\rd");
    assert_eq!(text(&mut channel), done("abc"));
    peer.send("ef");
    assert_eq!(channel.clear(), Some(3));
    assert!(!peer.is_connected());
    assert_eq!(channel.clear(), None);
    peer.connect();
    peer.send("new\r");
    assert_eq!(text(&mut channel), done("new"));
    assert_eq!(channel.clear(), Some(0));
}

#[test]
fn an_unfinished_string_is_dropped_with_its_peer() {
    let (mut channel, peer) = connected(LineKind::Server);
    peer.send("one\rtw");
    assert_eq!(text(&mut channel), done("one"));
    peer.disconnect();
    assert_eq!(text(&mut channel), Attempt::Wait);
    peer.connect();
    peer.send("three\r");
    let heard = (0..3).map(|_| text(&mut channel)).find(|turn| *turn != Attempt::Wait);
    assert_eq!(heard, Some(done("three")));
}

#[test]
fn a_peer_can_leave_during_a_string() {
    let (mut channel, peer) = connected(LineKind::Client);
    peer.stall_after(2);
    let mut sending = Sending::bytes(vec![1, 2, 3]);
    assert_eq!(channel.send(&mut sending, 0.0), Attempt::Wait);
    peer.disconnect();
    assert_eq!(channel.send(&mut sending, 0.0), Attempt::Done(Ok(2)));
    let mut sending = Sending::bytes(vec![4]);
    assert_eq!(channel.send(&mut sending, 0.0), Attempt::Wait);
    peer.connect();
    peer.stall_after(9);
    assert_eq!(channel.send(&mut sending, 0.0), Attempt::Done(Ok(1)));
    assert_eq!(peer.take(), [1, 2, 4]);
}

#[test]
fn parameters_have_their_results() {
    let (mut channel, peer) = channel(LineKind::Server);
    assert_eq!(channel.control("port", SettingValue::Num(2000.0)), 0);
    assert_eq!(channel.control("speed", SettingValue::Num(1.0)), -1);
    assert_eq!(channel.control("port", SettingValue::Bool(true)), -2);
    assert_eq!(channel.control("endOfString", SettingValue::Num(256.0)), -3);
    peer.connect();
    assert_eq!(channel.control("port", SettingValue::Num(2001.0)), -4);
    assert_eq!(channel.control("bits", SettingValue::Num(8.0)), -5);
    channel.clear();
    assert_eq!(channel.control("port", SettingValue::Num(2001.0)), 0);
    assert_eq!(peer.settings(), [LineSetting::Port(2000), LineSetting::Port(2001)]);
}
