//! The server with clients of raw bytes.

use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use val3_modbus::{ModbusFile, TableKind};

use super::connections::ConnectionLimits;
use super::*;

/// Bits 0 to 7 of the client, 8 to 15 of the robot.
fn server(limits: ConnectionLimits) -> Server {
    let file = ModbusFile::read(
        r#"<TOPICSLIST><TOPIC Name="Modbus" Actif="1"><MODULE IDModule="BOOLEAN">
        <ITEM Name="bIn" Syntaxe="%Q0:8"/><ITEM Name="bOut" Syntaxe="%I8:8"/></MODULE></TOPIC>
        <GENERAL_PARAMETERS TopicName="Modbus" ConnectionNumber="2"/></TOPICSLIST>"#,
    );
    let map = ModbusMap::of(&file).unwrap();
    Server::with_limits("127.0.0.1:0".parse().unwrap(), ModbusImage::new(&map), limits).unwrap()
}

fn connect(server: &Server) -> TcpStream {
    let stream = TcpStream::connect(server.address()).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(10))).unwrap();
    stream
}

const READ: [u8; 12] = [0, 1, 0, 0, 0, 6, 1, 1, 0, 0, 0, 16];

/// Reads the 11 bytes of the response to [`READ`], and returns the bits.
fn bits(stream: &mut TcpStream) -> [u8; 2] {
    let mut response = [0; 11];
    stream.read_exact(&mut response).unwrap();
    let [0, 1, 0, 0, 0, 5, 1, 1, 2, first, second] = response else { panic!("{response:?}") };
    [first, second]
}

/// Whether the server closes the connection without further bytes.
fn is_closed(stream: &mut TcpStream) -> bool {
    matches!(stream.read(&mut [0; 16]), Ok(0)) || stream.take_error().is_ok_and(|error| error.is_some())
}

#[test]
fn requests_are_split_and_joined() {
    let server = server(ConnectionLimits::for_clients(2));
    let mut client = connect(&server);
    client.write_all(&[READ, READ].concat()).unwrap();
    assert_eq!([bits(&mut client), bits(&mut client)], [[0, 0]; 2]);
    for byte in READ {
        client.write_all(&[byte]).unwrap();
        client.flush().unwrap();
    }
    assert_eq!(bits(&mut client), [0, 0]);
    server.exchange(|image| image.publish(TableKind::Bits, 9, 1));
    client.write_all(&READ).unwrap();
    assert_eq!(bits(&mut client), [0, 2]);
}

#[test]
fn a_further_client_is_closed_until_another_leaves() {
    let server = server(ConnectionLimits::for_clients(2));
    let mut clients = [connect(&server), connect(&server)];
    for client in &mut clients {
        client.write_all(&READ).unwrap();
        bits(client);
    }
    assert!(is_closed(&mut connect(&server)));
    drop(clients);
    let start = Instant::now();
    while start.elapsed() < Duration::from_secs(10) {
        let mut client = connect(&server);
        let mut response = [0; 11];
        if client.write_all(&READ).is_ok() && client.read_exact(&mut response).is_ok() {
            return;
        }
    }
    panic!("the places stay occupied");
}

#[test]
fn silent_and_wrong_clients_are_closed() {
    let short = Duration::from_millis(50);
    let limits = ConnectionLimits { idle_time: short, message_time: short, ..ConnectionLimits::for_clients(2) };
    let server = server(limits);
    assert!(is_closed(&mut connect(&server)), "no request");
    let mut half = connect(&server);
    half.write_all(&READ[..7]).unwrap();
    assert!(is_closed(&mut half), "half a request");
    let patient = self::server(ConnectionLimits::for_clients(2));
    let mut wrong = connect(&patient);
    wrong.write_all(b"GET / HTTP/1.1\r\n").unwrap();
    assert!(is_closed(&mut wrong), "another protocol");
}

#[test]
fn a_client_that_never_reads_is_closed() {
    let short = Duration::from_millis(100);
    let server = server(ConnectionLimits { send_time: short, ..ConnectionLimits::for_clients(1) });
    let mut client = connect(&server);
    client.set_write_timeout(Some(Duration::from_secs(10))).unwrap();
    let many = READ.repeat(1000);
    let start = Instant::now();
    while client.write_all(&many).is_ok() {
        assert!(start.elapsed() < Duration::from_secs(30), "the server accepts requests without end");
    }
}

#[test]
fn the_end_of_the_server_closes_connections() {
    let server = server(ConnectionLimits::for_clients(2));
    let address = server.address();
    let mut client = connect(&server);
    client.write_all(&READ).unwrap();
    bits(&mut client);
    drop(server);
    assert!(is_closed(&mut client));
    assert!(TcpStream::connect(address).is_err());
}
