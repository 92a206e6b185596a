//! Clients for the tests: browsers and strangers.

use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::time::Duration;

use tungstenite::http::Request;
use tungstenite::{Error, WebSocket, client};

use super::super::limits::ServerLimits;
use super::super::{Server, StoredMessage};

/// Timeout that is longer than every test.
const TIMEOUT: Duration = Duration::from_secs(20);

/// Starts a server on a free port.
pub(super) fn server(limits: ServerLimits) -> Server {
    Server::with_limits("127.0.0.1:0".parse().unwrap(), limits).unwrap()
}

/// Server address and secret in a page address.
pub(super) fn parts(page: &str) -> (&str, &str) {
    page.strip_prefix("http://").unwrap().trim_end_matches('/').split_once('/').unwrap()
}

/// Creates a text message.
pub(super) fn text(text: &str) -> StoredMessage {
    StoredMessage::Text(text.into())
}

pub(super) fn stream(address: &str) -> TcpStream {
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(TIMEOUT)).unwrap();
    stream
}

/// Sends bytes and reads until the server closes the connection.
pub(super) fn exchange(address: &str, request: &[u8]) -> String {
    let (mut stream, mut answer) = (stream(address), Vec::new());
    // The server may close the connection before it has read the entire request.
    let _ = stream.write_all(request);
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).into_owned()
}

/// Response to a request with this path and these headers.
pub(super) fn get(address: &str, path: &str, headers: &str) -> String {
    exchange(address, format!("GET {path} HTTP/1.1\r\n{headers}\r\n").as_bytes())
}

/// Opens a socket from a page of this server. The error is the status of the rejection.
pub(super) fn open(page: &str) -> Result<WebSocket<TcpStream>, u16> {
    let (address, secret) = parts(page);
    open_from(address, secret, address, &format!("http://{address}"))
}

/// Opens a socket with this host and origin. The error is the status of the rejection.
pub(super) fn open_from(address: &str, secret: &str, host: &str, origin: &str) -> Result<WebSocket<TcpStream>, u16> {
    let request = Request::get(format!("ws://{address}/{secret}/socket"))
        .header("Host", host)
        .header("Origin", origin)
        .header("Connection", "Upgrade")
        .header("Upgrade", "websocket")
        .header("Sec-WebSocket-Version", "13")
        .header("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ==");
    match client(request.body(()).unwrap(), stream(address)) {
        Ok((socket, _)) => Ok(socket),
        Err(tungstenite::HandshakeError::Failure(Error::Http(response))) => Err(response.status().as_u16()),
        Err(error) => panic!("{error}"),
    }
}

/// Next text or binary message; `None` if the connection has ended.
pub(super) fn next(socket: &mut WebSocket<TcpStream>) -> Option<Vec<u8>> {
    loop {
        match socket.read() {
            Ok(tungstenite::Message::Text(text)) => return Some(text.as_bytes().to_vec()),
            Ok(tungstenite::Message::Binary(bytes)) => return Some(bytes.to_vec()),
            Ok(tungstenite::Message::Close(_)) | Err(_) => return None,
            Ok(_) => {}
        }
    }
}

/// Next text message as JSON.
pub(super) fn next_json(socket: &mut WebSocket<TcpStream>) -> serde_json::Value {
    serde_json::from_slice(&next(socket).unwrap()).unwrap()
}

/// Sends a text message. Returns whether the connection still exists.
pub(super) fn send(socket: &mut WebSocket<TcpStream>, text: &str) -> bool {
    socket.send(tungstenite::Message::text(text)).is_ok()
}
