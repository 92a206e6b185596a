//! Subscriptions of events.

use val3_soap::v2::{SubscribeToControllerEvents, UnsubscribeToControllerEvents};
use val3_soap::{ExceptionCode, SoapRequest};

use super::client::Client;

fn subscribe(url: &str, send_interval: i32) -> SoapRequest {
    let service_url = Some(url.to_owned());
    SoapRequest::SubscribeToControllerEvents(SubscribeToControllerEvents { service_url, send_interval })
}

#[test]
fn only_services_on_this_machine_are_accepted() {
    let mut client = Client::logged_in();
    for url in ["http://127.0.0.1:5656/", "http://localhost:5656", "http://[::1]:5656/service", "http://127.0.0.9"] {
        client.ask(subscribe(url, 500));
    }
    client.ask(SoapRequest::UnsubscribeToControllerEvents(UnsubscribeToControllerEvents));
    for url in ["", "127.0.0.1:5656", "http://192.168.0.7:5656/", "http://localhost@robot/", "http://robot:5656/"] {
        assert_eq!(client.code(subscribe(url, 500)), ExceptionCode::ClientCommunication, "{url}");
    }
    assert_eq!(client.code(subscribe("http://127.0.0.1:5656/", 0)), ExceptionCode::InvalidParameters);
}
