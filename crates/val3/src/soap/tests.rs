//! Raw HTTP requests, permitted and hostile, to a server whose run echoes pings.

use std::io::{Read as _, Write as _};
use std::net::{SocketAddr, TcpStream};
use std::time::Duration;

use val3_service::ServiceAnswer;
use val3_soap::v0::PingAnswer;
use val3_soap::{SoapAnswer, SoapRequest};

use super::limits::SoapLimits;
use super::{PendingCall, SoapPort};
use crate::serve::quota::RateLimits;

/// Ping in SOAP 1.2.
const PING: &str = "<s:Envelope xmlns:s='http://www.w3.org/2003/05/soap-envelope' xmlns:v='CS8ServerV0'>\
    <s:Header><v:sessionId s:mustUnderstand='true'>7</v:sessionId></s:Header>\
    <s:Body><v:ping><message>hello</message></v:ping></s:Body></s:Envelope>";

/// Type of messages in SOAP 1.2.
const SOAP_12: &str = "Content-Type: application/soap+xml; charset=utf-8\r\n";

fn echo(call: PendingCall) {
    let result = match &call.call.request {
        SoapRequest::Ping(ping) => Ok(SoapAnswer::Ping(PingAnswer { message: ping.message.clone() })),
        other => panic!("{other:?}"),
    };
    let session = call.call.session;
    call.answer(ServiceAnswer { session, result });
}

/// Executes a test with the address of a server whose pings are echoed.
fn with_server(limits: SoapLimits, test: impl FnOnce(SocketAddr) + Send) {
    let port = SoapPort::with_limits("0".parse().unwrap(), limits).unwrap();
    let address = port.address();
    std::thread::scope(|scope| {
        let test = scope.spawn(move || test(address));
        while !test.is_finished() {
            if let Some(call) = port.wait_for_call(Duration::from_millis(10)) {
                echo(call);
            }
        }
        test.join().unwrap();
    });
}

fn stream(address: SocketAddr) -> TcpStream {
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
    stream
}

/// Sends bytes and reads until the server closes the connection.
fn exchange(address: SocketAddr, request: &str) -> String {
    let (mut stream, mut answer) = (stream(address), Vec::new());
    let _ = stream.write_all(request.as_bytes());
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).into_owned()
}

fn post(path: &str, headers: &str, body: &str) -> String {
    format!(
        "POST {path} HTTP/1.1\r\nHost: robot\r\nConnection: close\r\n{headers}Content-Length: {}\r\n\r\n{body}",
        body.len()
    )
}

#[test]
fn the_answer_has_the_version_and_the_session_of_the_request() {
    with_server(SoapLimits::default(), |address| {
        let answer = exchange(address, &post("/", SOAP_12, PING));
        assert!(answer.starts_with("HTTP/1.1 200 OK\r\n"), "{answer}");
        assert!(answer.contains("content-type: application/soap+xml; charset=utf-8\r\n"), "{answer}");
        assert!(answer.contains("<V0:sessionId>7</V0:sessionId>"), "{answer}");
        assert!(answer.contains("<V0:pingResponse><message>hello</message></V0:pingResponse>"), "{answer}");
        let old = PING.replace("http://www.w3.org/2003/05/soap-envelope", "http://schemas.xmlsoap.org/soap/envelope/");
        let answer = exchange(address, &post("/", "Content-Type: text/xml\r\n", &format!("\u{feff}{old}")));
        assert!(answer.contains("content-type: text/xml; charset=utf-8\r\n"), "{answer}");
    });
}

#[test]
fn all_forms_of_bodies_are_read() {
    with_server(SoapLimits::default(), |address| {
        let chunks: String = PING
            .as_bytes()
            .chunks(50)
            .map(|chunk| format!("{:x}\r\n{}\r\n", chunk.len(), std::str::from_utf8(chunk).unwrap()))
            .collect();
        let head = format!("POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n{SOAP_12}");
        let chunked = exchange(address, &format!("{head}Transfer-Encoding: chunked\r\n\r\n{chunks}0\r\n\r\n"));
        assert!(chunked.contains("hello"), "{chunked}");
        let mut connection = stream(address);
        let length = PING.len();
        write!(connection, "{head}Expect: 100-continue\r\nContent-Length: {length}\r\n\r\n").unwrap();
        let mut interim = [0; 25];
        connection.read_exact(&mut interim).unwrap();
        assert_eq!(&interim, b"HTTP/1.1 100 Continue\r\n\r\n");
        connection.write_all(PING.as_bytes()).unwrap();
        let mut answer = String::new();
        connection.read_to_string(&mut answer).unwrap();
        assert!(answer.contains("hello"), "{answer}");
        let parts = format!("--b\r\nContent-ID: <r>\r\n\r\n{PING}\r\n--b--\r\n");
        let related = "Content-Type: multipart/related; type=\"application/xop+xml\"; start=\"<r>\"; boundary=b\r\n";
        assert!(exchange(address, &post("/", related, &parts)).contains("hello"));
    });
}

#[test]
fn a_connection_serves_several_requests() {
    with_server(SoapLimits::default(), |address| {
        let mut connection = stream(address);
        let request = post("/", SOAP_12, PING).replace("Connection: close\r\n", "");
        for _ in 0..20 {
            connection.write_all(request.as_bytes()).unwrap();
            let (mut answer, mut buffer) = (String::new(), [0; 4096]);
            while !answer.contains("</SOAP-ENV:Envelope>") {
                let count = connection.read(&mut buffer).unwrap();
                assert_ne!(count, 0, "{answer}");
                answer.push_str(std::str::from_utf8(&buffer[..count]).unwrap());
            }
        }
    });
}

#[test]
fn wrong_requests_are_explained() {
    with_server(SoapLimits::default(), |address| {
        let status = |request: &str| exchange(address, request).split(' ').nth(1).map(str::to_owned);
        assert_eq!(status("GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n").as_deref(), Some("405"));
        assert_eq!(status(&post("/other", SOAP_12, PING)).as_deref(), Some("404"));
        assert_eq!(status(&post("/", "Content-Type: text/plain\r\n", PING)).as_deref(), Some("415"));
        assert_eq!(status(&post("/", "", PING)).as_deref(), Some("415"));
        assert_eq!(status(&post("/", &format!("Origin: http://evil\r\n{SOAP_12}"), PING)).as_deref(), Some("403"));
        let fault = |path: &str, body: &str| {
            let answer = exchange(address, &post(path, SOAP_12, body));
            assert!(answer.starts_with("HTTP/1.1 500 "), "{answer}");
            answer.split_once("lang=\"en\">").unwrap().1.split_once("</").unwrap().0.to_owned()
        };
        assert_eq!(fault("/", "<a>"), "the message is not XML: it ends within the element `a`");
        assert_eq!(
            fault("/", &PING.replace("message", "massage").replace("v:ping", "v:login1")),
            "INVALID-SOAP-HANDLER: there is no operation `login1` of the name space `CS8ServerV0` at this address"
        );
        assert_eq!(
            fault("/CS8ServerV1", PING),
            "INVALID-SOAP-HANDLER: there is no operation `ping` of the name space `CS8ServerV0` at this address"
        );
        let wrong =
            PING.replace("v:ping", "v:getRobotJointPos").replace("<message>hello</message>", "<robot>one</robot>");
        assert_eq!(
            fault("/", &wrong),
            "INVALID-PARAMETERS: the element `robot` must contain a whole number, not `one`"
        );
    });
}

#[test]
fn large_slow_and_many_requests_are_rejected() {
    let limits = SoapLimits {
        body_time: Duration::from_millis(100),
        calls: RateLimits { per_second: 1, at_once: 3, refused: u32::MAX },
        ..SoapLimits::default()
    };
    with_server(limits, |address| {
        let large =
            format!("POST / HTTP/1.1\r\nHost: x\r\n{SOAP_12}Content-Length: 9999999\r\n\r\n{}", " ".repeat(2 << 20));
        assert!(!exchange(address, &large).starts_with("HTTP/1.1 200"));
        let slow = format!("POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n{SOAP_12}Content-Length: 10\r\n\r\n<a");
        assert!(exchange(address, &slow).starts_with("HTTP/1.1 408"));
        let answers = [(); 5].map(|()| exchange(address, &post("/", SOAP_12, PING)));
        assert!(answers[0].starts_with("HTTP/1.1 200") && answers[4].starts_with("HTTP/1.1 429"), "{answers:?}");
    });
}

/// The client may repeat it, for example a move.
#[test]
fn a_request_that_was_answered_as_busy_is_not_executed_later() {
    let limits = SoapLimits { answer_time: Duration::from_millis(50), ..SoapLimits::default() };
    let port = SoapPort::with_limits("0".parse().unwrap(), limits).unwrap();
    for _ in 0..2 {
        assert!(exchange(port.address(), &post("/", SOAP_12, PING)).starts_with("HTTP/1.1 504"));
    }
    assert!(port.next_call().is_none());
    assert!(exchange(port.address(), &post("/", SOAP_12, PING)).starts_with("HTTP/1.1 504"));
    assert!(port.wait_for_call(Duration::from_millis(10)).is_none());
}

#[test]
fn the_end_of_the_run_ends_requests() {
    let port = SoapPort::with_limits("0".parse().unwrap(), SoapLimits::default()).unwrap();
    let address = port.address();
    let client = std::thread::spawn(move || exchange(address, &post("/", SOAP_12, PING)));
    let call = port.wait_for_call(Duration::from_secs(10)).unwrap();
    drop(call);
    assert!(client.join().unwrap().starts_with("HTTP/1.1 503"));
    drop(port);
    assert!(TcpStream::connect(address).is_err());
}
