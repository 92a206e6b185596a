//! Real sockets on loopback.

#![allow(clippy::disallowed_methods, reason = "the other end is the system's: the tests give it time")]

use std::io::{Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream, UdpSocket};
use std::time::Duration;

use super::*;

fn loopback(port: u16) -> SocketAddr {
    (Ipv4Addr::LOCALHOST, port).into()
}

/// Repeats the call until it is done; fails after some seconds.
#[track_caller]
fn until<T>(mut ask: impl FnMut() -> Attempt<T>) -> T {
    for _ in 0..2_000 {
        if let Attempt::Done(value) = ask() {
            return value;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("nothing has come");
}

/// Server that clients can call, and its address.
fn server(clients: u16) -> (Channel, SocketAddr) {
    let mut server = TcpServer::new(loopback(0), NetworkAccess::Loopback);
    assert_eq!(server.local_address(), None);
    server.apply(&LineSetting::Clients(clients)).unwrap();
    server.open();
    let address = server.local_address().unwrap();
    (Channel::new(Box::new(server)), address)
}

fn call(address: SocketAddr) -> TcpStream {
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(5))).unwrap();
    stream
}

fn text(channel: &mut Channel) -> String {
    until(|| channel.read_text(0.0)).unwrap()
}

fn send(channel: &mut Channel, text: &str) {
    let mut sending = channel.text(text);
    let total = sending.total();
    assert_eq!(until(|| channel.send(&mut sending, 0.0)), Ok(total));
}

/// The bytes that a client receives until the server's end, or `count` bytes.
fn heard(stream: &mut TcpStream, count: usize) -> String {
    let mut bytes = vec![0; count];
    stream.read_exact(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn is_closed(stream: &mut TcpStream) -> bool {
    !matches!(stream.read(&mut [0]), Ok(1..))
}

#[test]
fn a_server_answers_one_client_after_another() {
    let (mut channel, address) = server(1);
    for round in 0..3 {
        let mut client = call(address);
        client.write_all(format!("ask {round}\rand more\r").as_bytes()).unwrap();
        assert_eq!(text(&mut channel), format!("ask {round}"));
        send(&mut channel, "answer");
        assert_eq!(heard(&mut client, 7), "answer\r");
        assert_eq!(text(&mut channel), "and more");
    }
}

#[test]
fn the_last_data_of_a_client_are_read() {
    let (mut channel, address) = server(1);
    for name in ["a", "b", "c"] {
        call(address).write_all(format!("{name}\runfinished").as_bytes()).unwrap();
    }
    assert_eq!([(); 3].map(|()| text(&mut channel)), ["a", "b", "c"]);
}

#[test]
fn clients_above_the_limit_are_turned_down() {
    let (mut channel, address) = server(2);
    let (mut first, mut second) = (call(address), call(address));
    until(|| if channel.attend() == Connection::Open { Attempt::Done(()) } else { Attempt::Wait });
    second.write_all(b"second\r").unwrap();
    assert_eq!(text(&mut channel), "second");
    let mut third = call(address);
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Wait);
    assert!(is_closed(&mut third));
    send(&mut channel, "to second");
    assert_eq!(heard(&mut second, 10), "to second\r");
    first.write_all(b"first\r").unwrap();
    assert_eq!(text(&mut channel), "first");
    drop(second);
    let mut fourth = call(address);
    fourth.write_all(b"fourth\r").unwrap();
    assert_eq!(text(&mut channel), "fourth");
    assert_eq!(channel.control("clients", SettingValue::Num(3.0)), -4);
}

/// A public driver discovers its peers in this way.
#[test]
fn a_polled_server_reports_connections() {
    let (mut channel, address) = server(1);
    assert_eq!(channel.control("timeout", SettingValue::Num(-1.0)), 0);
    assert_eq!(channel.control("nagle", SettingValue::Bool(false)), 0);
    assert_eq!(channel.read_bytes(1, 0.0), Attempt::Done(None));
    let client = call(address);
    until(|| if channel.read_bytes(1, 0.0) == Attempt::Done(Some(vec![])) { Attempt::Done(()) } else { Attempt::Wait });
    drop(client);
    until(|| if channel.read_bytes(1, 0.0) == Attempt::Done(None) { Attempt::Done(()) } else { Attempt::Wait });
    assert_eq!(channel.clear(), None);
    let mut client = call(address);
    client.write_all(&[5]).unwrap();
    let got = until(|| match channel.read_bytes(1, 0.0) {
        Attempt::Done(Some(bytes)) if !bytes.is_empty() => Attempt::Done(bytes),
        _ => Attempt::Wait,
    });
    assert_eq!(got, [5]);
}

#[test]
fn clearing_ends_the_connection() {
    let (mut channel, address) = server(1);
    let mut client = call(address);
    client.write_all(b"one\rrest").unwrap();
    assert_eq!(text(&mut channel), "one");
    assert_eq!(channel.control("port", SettingValue::Num(2000.0)), -4);
    let thrown =
        until(|| if channel.attend() == Connection::Open { Attempt::Done(channel.clear()) } else { Attempt::Wait });
    assert_eq!(thrown, Some(4));
    assert!(is_closed(&mut client));
    assert_eq!(channel.clear(), None);
    call(address).write_all(b"again\r").unwrap();
    assert_eq!(text(&mut channel), "again");
}

#[test]
fn a_stopped_server_cannot_be_called() {
    let (mut channel, address) = server(1);
    let mut client = call(address);
    channel.attend();
    channel.shut_down();
    assert!(is_closed(&mut client));
    assert!(TcpStream::connect(address).is_err());
}

#[test]
fn a_flood_is_throttled() {
    let (mut channel, address) = server(1);
    let client = call(address);
    client.set_nonblocking(true).unwrap();
    let chunk = vec![b'x'; 100_000];
    let mut poured = 0;
    for _ in 0..2_000 {
        poured += (&client).write(&chunk).unwrap_or(0);
        channel.attend();
    }
    assert!(poured < 64 << 20, "{poured} bytes went somewhere");
    assert_eq!(text(&mut channel), "x".repeat(128));
}

#[test]
fn a_stalled_client_ends_in_the_timeout() {
    let (mut channel, address) = server(1);
    let _client = call(address);
    assert_eq!(channel.control("timeout", SettingValue::Num(1.0)), 0);
    let mut sending = Sending::bytes(vec![0; 64 << 20]);
    for _ in 0..200 {
        assert_eq!(channel.send(&mut sending, 0.5), Attempt::Wait);
    }
    assert_eq!(channel.send(&mut sending, 1.0), Attempt::Done(Err(SioFault::TimedOut)));
}

#[test]
fn a_reset_is_survived() {
    let (mut channel, address) = server(1);
    let client = socket2::SockRef::from(&call(address)).try_clone().unwrap();
    client.set_linger(Some(Duration::ZERO)).unwrap();
    client.send(b"half").unwrap();
    until(|| if channel.attend() == Connection::Open { Attempt::Done(()) } else { Attempt::Wait });
    drop(client);
    let mut sending = channel.text("lost");
    for _ in 0..50 {
        assert_eq!(channel.send(&mut sending, 0.0), Attempt::Wait);
        std::thread::sleep(Duration::from_millis(1));
    }
    call(address).write_all(b"next\r").unwrap();
    assert_eq!(text(&mut channel), "next");
}

#[test]
fn a_taken_port_is_waited_for() {
    let taken = TcpListener::bind(loopback(0)).unwrap();
    let address = taken.local_addr().unwrap();
    let mut channel = Channel::new(Box::new(TcpServer::new(address, NetworkAccess::Loopback)));
    assert_eq!(channel.attend(), Connection::Closed);
    drop(taken);
    channel.attend();
    call(address).write_all(b"free\r").unwrap();
    assert_eq!(text(&mut channel), "free");
}

#[test]
fn a_client_retries_until_it_is_connected() {
    let listener = TcpListener::bind(loopback(0)).unwrap();
    let address = listener.local_addr().unwrap();
    drop(listener);
    let mut channel = Channel::new(Box::new(TcpClient::new(address, NetworkAccess::Loopback)));
    for _ in 0..20 {
        assert_eq!(channel.read_text(0.0), Attempt::Wait);
    }
    let listener = TcpListener::bind(address).unwrap();
    for round in 0..2 {
        let mut sending = channel.text("hello");
        assert_eq!(until(|| channel.send(&mut sending, 0.0)), Ok(6));
        let (mut peer, _) = listener.accept().unwrap();
        assert_eq!(heard(&mut peer, 6), "hello\r");
        peer.write_all(format!("welcome {round}\r").as_bytes()).unwrap();
        assert_eq!(text(&mut channel), format!("welcome {round}"));
        drop(peer);
        until(|| if channel.attend() == Connection::Closed { Attempt::Done(()) } else { Attempt::Wait });
    }
    assert_eq!(channel.control("timeout", SettingValue::Num(0.5)), 0);
    drop(listener);
    until(|| match channel.read_bytes(1, 0.6) {
        Attempt::Done(None) => Attempt::Done(()),
        _ => Attempt::Wait,
    });
}

#[test]
fn a_client_can_connect_to_another_server() {
    let listener = TcpListener::bind(loopback(0)).unwrap();
    let port = f64::from(listener.local_addr().unwrap().port());
    let mut channel = Channel::new(Box::new(TcpClient::new(loopback(1), NetworkAccess::Loopback)));
    assert_eq!(channel.control("target", SettingValue::Text("192.168.0.254")), 0);
    assert_eq!(channel.control("port", SettingValue::Num(port)), 0);
    let mut sending = channel.text("x");
    assert_eq!(until(|| channel.send(&mut sending, 0.0)), Ok(2));
    assert_eq!(channel.control("port", SettingValue::Num(port)), -4);
    assert_eq!(channel.control("clients", SettingValue::Num(1.0)), -5);
    assert_eq!(channel.clear(), Some(0));
    assert_eq!(channel.control("port", SettingValue::Num(port)), 0);
}

#[test]
fn datagrams_are_sent_and_received() {
    let mut line = UdpLine::new(loopback(0), None, NetworkAccess::Loopback);
    line.open();
    let address = line.local_address().unwrap();
    let mut channel = Channel::new(Box::new(line));
    let mut sending = channel.text("to nobody");
    assert_eq!(channel.send(&mut sending, 0.0), Attempt::Wait);
    let peer = UdpSocket::bind(loopback(0)).unwrap();
    peer.set_read_timeout(Some(Duration::from_secs(5))).unwrap();
    peer.send_to(b"ping\r", address).unwrap();
    assert_eq!(text(&mut channel), "ping");
    send(&mut channel, "pong");
    let mut bytes = [0; 16];
    assert_eq!(peer.recv(&mut bytes).unwrap(), 5);
    assert_eq!(&bytes[..5], b"pong\r");
    assert_eq!(channel.control("nagle", SettingValue::Bool(true)), -5);
    assert_eq!(channel.control("port", SettingValue::Num(9.0)), -4);
    assert_eq!(channel.clear(), Some(0));
    assert_eq!(channel.clear(), None);
    send(&mut channel, "again");
    assert_eq!(peer.recv(&mut bytes).unwrap(), 6, "the last sender is still the target");
}
